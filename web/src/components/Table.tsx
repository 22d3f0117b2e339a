// A table from its data. On a page its rows can be sorted and copied; a report has neither.
import { useState } from 'preact/hooks';
import type { Cell, Column, RowMark, TableData } from './document';
import { cellText, nextOrder, rowOrder, tableText, type SortOrder } from './tableText';

interface Props {
  table: TableData;
  /** A click on the head of a column sorts by it. */
  sortable?: boolean;
  /** A button copies the table as tab-separated text. */
  copyable?: boolean;
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
    <th class={column.words ? 't' : undefined} scope="col" aria-sort={order}>
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

function Row({ cells, columns, mark }: { cells: Cell[]; columns: Column[]; mark: RowMark | undefined }) {
  return (
    <tr class={mark || undefined}>
      {cells.map((cell, i) => {
        const verdict = typeof cell === 'object' && cell !== null && cell.verdict.replace(' ', '-');
        return <td class={classes(columns[i]?.words && 't', verdict)}>{cellText(cell, columns[i])}</td>;
      })}
    </tr>
  );
}

/** Says beside itself that it has copied, until the pointer or the focus leaves it. */
function CopyButton({ text }: { text: () => string }) {
  const [state, setState] = useState('');
  const copy = () => navigator.clipboard.writeText(text()).then(() => setState('copied'), () => setState('not permitted by the browser'));
  const clear = () => setState('');
  return (
    <span class="copy" onMouseLeave={clear} onBlurCapture={clear}>
      <button type="button" class="tiny" title="Copy the table as tab-separated text" onClick={copy}>Copy</button>
      <span role="status">{state}</span>
    </span>
  );
}

export function Table({ table, sortable = false, copyable = false }: Props) {
  const [order, setOrder] = useState<SortOrder | null>(null);
  const sorting = (column: number): HeadProps['order'] => {
    if (order?.column !== column) return 'none';
    return order.descending ? 'descending' : 'ascending';
  };
  return (
    <div class="table">
      <table class={table.look}>
        {table.title || copyable ? (
          <caption>
            {table.title}
            {copyable ? <CopyButton text={() => tableText(table, order)} /> : null}
          </caption>
        ) : null}
        <thead>
          {table.groups ? <Groups groups={table.groups} /> : null}
          <tr>
            {table.columns.map((column, i) => (
              <Head
                column={column}
                order={sortable ? sorting(i) : undefined}
                onSort={sortable ? () => setOrder(nextOrder(order, i)) : undefined}
              />
            ))}
          </tr>
        </thead>
        <tbody>
          {rowOrder(table, order).map((i) => <Row key={i} cells={table.rows[i]!} columns={table.columns} mark={table.marks?.[i]} />)}
        </tbody>
      </table>
    </div>
  );
}
