// One row of a grid: drawn again only if its content or its selection has changed.
import { Component } from 'preact';
import type { ViewCell, ViewColumn, ViewRow } from '../../logic/gridView';
import { selectObject } from '../../state/workspace';

export interface RowProps {
  row: ViewRow;
  columns: ViewColumn[];
  /** Number in the grid, which differs from that in the list if the rows are sorted. */
  number: number;
  /** Selected cells, none: -1. */
  left: number;
  right: number;
  /** Column of the active cell, -1 in other rows. */
  active: number;
  /** Text in the editor of the active cell; null while none is open. */
  editing: string | null;
  chosen: boolean;
  grid: string;
  commit: (text: string, key: string, shift: boolean) => void;
  cancel: () => void;
}

const keys = Object.keys as (o: RowProps) => (keyof RowProps)[];

interface EditorProps { text: string; column: ViewColumn; title: string; commit: RowProps['commit']; cancel: () => void }

/** The field in the active cell. Typed text is committed in whichever way the cell is left. */
function Editor({ text, column, title, commit, cancel }: EditorProps) {
  let left = false;
  const leave = (act: () => void): void => { if (!left) { left = true; act(); } };
  const choices = column.choices.length ? `choices-${column.id}` : undefined;
  return (
    <>
      <input
        class="editor"
        defaultValue={text}
        aria-label={title}
        list={choices}
        spellcheck={false}
        autocomplete="off"
        ref={(field) => { if (field && document.activeElement !== field) { field.focus(); field.setSelectionRange(field.value.length, field.value.length); } }}
        onBlur={(e) => { const { value } = e.currentTarget; leave(() => commit(value, '', false)); }}
        onKeyDown={(e) => {
          e.stopPropagation();
          if (e.isComposing) return;
          const { value } = e.currentTarget;
          if (e.key === 'Escape') { e.preventDefault(); leave(cancel); }
          else if (e.key === 'Enter' || e.key === 'Tab') { e.preventDefault(); leave(() => commit(value, e.key, e.shiftKey)); }
        }}
      />
      {choices ? <datalist id={choices}>{column.choices.map((c) => <option value={c} />)}</datalist> : null}
    </>
  );
}

function cellClass(cell: ViewCell, column: ViewColumn, selected: boolean, active: boolean): string {
  const names = [cell.state, cell.severity && `has-${cell.severity}`, column.isText ? 't' : 'n', selected && 'selected', active && 'active', !column.editable && cell.state !== 'result' && 'nested'];
  return names.filter(Boolean).join(' ');
}

export class GridRow extends Component<RowProps> {
  override shouldComponentUpdate(next: RowProps): boolean {
    return keys(next).some((key) => next[key] !== this.props[key]);
  }

  private content(cell: ViewCell, column: ViewColumn, isActive: boolean) {
    const { row, editing, commit, cancel } = this.props;
    if (isActive && editing !== null) return <Editor text={editing} column={column} title={`${column.title}, ${row.name || row.index + 1}`} commit={commit} cancel={cancel} />;
    if (cell.link) return <button type="button" class="link" tabIndex={-1} onClick={() => selectObject(cell.link)}>{cell.text || '–'} ›</button>;
    return <>{cell.text}{cell.message ? <small class="said">{cell.message}</small> : null}</>;
  }

  override render() {
    const { row, columns, number, left, right, active, chosen, grid } = this.props;
    return (
      <tr aria-rowindex={number + 2} class={chosen ? 'chosen' : undefined}>
        <th scope="row" data-row={number} class={row.mark ? 'has-error' : undefined} title={row.mark || `Row ${row.index + 1}: click selects it`}>
          {row.index + 1}
        </th>
        {columns.map((column, i) => {
          const cell = row.cells[i]!, selected = i >= left && i <= right && left >= 0;
          return (
            <td
              key={column.id}
              id={`${grid}-${number}-${i}`}
              role="gridcell"
              data-row={number}
              data-column={i}
              data-path={column.column ? `${row.id}${column.id ? `.${column.id}` : ''}` : undefined}
              class={cellClass(cell, column, selected, i === active)}
              aria-selected={selected}
              aria-readonly={!column.editable}
              aria-invalid={cell.severity === 'error' || undefined}
              title={cell.message || undefined}
            >
              {this.content(cell, column, i === active)}
            </td>
          );
        })}
      </tr>
    );
  }
}
