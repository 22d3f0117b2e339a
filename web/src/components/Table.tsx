// A table from its data. On the page its rows can be sorted and copied; in a report they cannot.
import { useState } from 'preact/hooks';
import type { Cell, Column, RowMark, TableData } from './document';
import { download } from './download';
import { cellText, nextOrder, rowOrder, tableCsv, tableText, type SortOrder } from './tableText';

/** Action of a click on the name of a row; `colour`: of a dot in front of the name. */
export interface RowAction { act: () => void; title: string; chosen?: boolean; colour?: string }

interface Props {
  table: TableData;
  /** A click on the head of a column sorts by it. */
  sortable?: boolean;
  /** A button copies the table as tab-separated text. */
  copyable?: boolean;
  /** Name of a CSV file without extension: a button saves the table there. */
  file?: string;
  /** Row actions by the text in the first cell. */
  rowAction?: (name: string) => RowAction | undefined;
  /** Tooltip of a number. */
  numberTitle?: (text: string, column: Column) => string;
}

function classes(...names: (string | false | undefined)[]): string | undefined {
  return names.filter(Boolean).join(' ') || undefined;
}

function ColumnTitle({ column }: { column: Column }) {
  return (
    <>
      {column.title}
      {column.unit ? <><br /><span class="unit">{column.unit}</span></> : null}
    </>
  );
}

interface HeadProps { column: Column; order?: 'ascending' | 'descending' | 'none'; onSort?: () => void }

function Head({ column, order, onSort }: HeadProps) {
  const title = <ColumnTitle column={column} />;
  return (
    <th class={column.words ? 't' : undefined} scope="col" aria-sort={order} title={column.description}>
      {onSort ? <button type="button" class="sort" onClick={onSort}>{title}</button> : title}
    </th>
  );
}

function Groups({ groups }: { groups: [string, number][] }) {
  return (
    <tr class="groups">
      {groups.map(([title, span]) => <th colSpan={span} scope="colgroup">{title}</th>)}
    </tr>
  );
}

function RowName({ name, action }: { name: string; action: RowAction }) {
  return (
    <button type="button" class="linkname" aria-pressed={action.chosen} title={action.title} onClick={action.act}>
      {action.colour ? <i style={{ background: action.colour }} /> : null}
      {name}
    </button>
  );
}

interface RowProps { cells: Cell[]; mark: RowMark | undefined; of: Props }

function Row({ cells, mark, of: { table, rowAction, numberTitle } }: RowProps) {
  const action = rowAction?.(cellText(cells[0], table.columns[0]));
  return (
    <tr class={classes(mark, action?.chosen && 'chosen')}>
      {cells.map((cell, i) => {
        const column = table.columns[i]!, text = cellText(cell, column);
        const verdict = typeof cell === 'object' && cell !== null && cell.verdict.replace(' ', '-');
        return (
          <td class={classes(column.words && 't', verdict)} title={typeof cell === 'number' ? numberTitle?.(text, column) : undefined}>
            {i === 0 && action ? <RowName name={text} action={action} /> : text}
          </td>
        );
      })}
    </tr>
  );
}

/** Shows "copied" until the pointer or the focus leaves the button. */
function CopyButton({ text }: { text: () => string }) {
  const [state, setState] = useState('');
  const copy = () => navigator.clipboard.writeText(text()).then(() => setState('copied'), () => setState('not permitted by the browser'));
  const clear = () => setState('');
  return (
    <span onMouseLeave={clear} onBlurCapture={clear}>
      <span role="status">{state}</span>
      <button type="button" class="tiny" title="Copy the table as tab-separated text" onClick={copy}>copy</button>
    </span>
  );
}

function Caption({ of: { table, copyable, file }, order }: { of: Props; order: SortOrder | null }) {
  const save = () => download(`${file}.csv`, new Blob([tableCsv(table, order)], { type: 'text/csv' }));
  if (!table.title && !copyable && !file) return null;
  return (
    <caption>
      {table.title}
      {copyable || file ? (
        <span class="tools">
          {copyable ? <CopyButton text={() => tableText(table, order)} /> : null}
          {file ? <button type="button" class="tiny" title="Save the table as CSV" onClick={save}>csv</button> : null}
        </span>
      ) : null}
    </caption>
  );
}

export function Table(props: Props) {
  const { table, sortable } = props;
  const [order, setOrder] = useState<SortOrder | null>(null);
  const sorting = (column: number): HeadProps['order'] => {
    if (order?.column !== column) return 'none';
    return order.descending ? 'descending' : 'ascending';
  };
  return (
    <div class="table">
      <table class={table.look}>
        <Caption of={props} order={order} />
        <thead>
          {table.groups ? <Groups groups={table.groups} /> : null}
          <tr>
            {table.columns.map((column, i) => (
              <Head
                column={column}
                order={sortable ? sorting(i) : undefined}
                onSort={sortable ? () => setOrder(nextOrder(order, i, column.words)) : undefined}
              />
            ))}
          </tr>
        </thead>
        <tbody>
          {rowOrder(table, order).map((i) => <Row key={i} cells={table.rows[i]!} mark={table.marks?.[i]} of={props} />)}
        </tbody>
      </table>
    </div>
  );
}
