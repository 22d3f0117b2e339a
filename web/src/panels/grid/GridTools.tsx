// Buttons above a grid: rows, columns, copy and CSV.
import type { ComponentChildren } from 'preact';
import type { ViewRow } from '../../logic/gridView';
import { byPath } from '../../state/model';
import { isRow } from '../../logic/gridTables';
import { writingRows } from '../../state/gridEdit';
import { addRow, allColumns, askColumns, duplicateSelected, moveSelected, removeSelected, writeOrder, type GridTable } from '../../state/gridTable';
import { selectObject } from '../../state/workspace';

interface Props {
  table: GridTable;
  /** List that receives a new row. */
  list: string;
  selected: ViewRow[];
  sorted: ViewRow[] | null;
  copy: (heads: boolean) => void;
  save: () => void;
  children?: ComponentChildren;
}

export async function moveRows(rows: ViewRow[], step: 1 | -1): Promise<void> {
  const path = await moveSelected(rows, step);
  if (path) selectObject(path);
}

export function GridTools({ table, list, selected, sorted, copy, save, children }: Props) {
  const none = selected.length === 0, many = selected.length > 1 ? `${selected.length} rows` : 'the selected row';
  const target = selected.at(-1)?.list ?? list, isArc = isRow(byPath.value, target);
  return (
    <>
      <button type="button" disabled={isArc} onClick={() => void addRow(target, allColumns(table))} title="Add a copy of the last row">+ Row</button>
      <button type="button" disabled={none} onClick={() => duplicateSelected(selected)} title={`Copy ${many}`}>Duplicate</button>
      <button type="button" disabled={none} onClick={() => removeSelected(selected)} title={`Remove ${many} from the model`}>Remove</button>
      <button type="button" disabled={none || sorted !== null} onClick={() => void moveRows(selected, -1)} aria-label="Move up" title={`Move ${many} up (Alt ↑)`}>↑</button>
      <button type="button" disabled={none || sorted !== null} onClick={() => void moveRows(selected, 1)} aria-label="Move down" title={`Move ${many} down (Alt ↓)`}>↓</button>
      {sorted ? <button type="button" onClick={() => writeOrder(sorted)} title="Write the order shown into the model">Apply this order</button> : null}
      {table.hidden.length ? (
        <select value="" aria-label="Add a column" title="Columns without values" onChange={(e) => { askColumns(table.key, [e.currentTarget.value]); e.currentTarget.value = ''; }}>
          <option value="">+ column</option>
          {table.hidden.map((c) => <option key={c.key} value={c.key}>{c.title}</option>)}
        </select>
      ) : null}
      {children}
      <span class="fill">{writingRows.value ? 'Writing …' : ''}</span>
      <button type="button" class="tiny" onClick={() => copy(true)} title="Copy the selected cells, or all, with headings (Ctrl Shift C); Ctrl C copies without headings">Copy with headings</button>
      <button type="button" class="tiny" onClick={save} title="Save the table as a CSV file">CSV</button>
    </>
  );
}
