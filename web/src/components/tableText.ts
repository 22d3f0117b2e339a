// Texts and orders of tables, apart from how they are drawn.
import type { Cell, Column, TableData } from './document';
import { fixed } from './units';

/** Order of rows by a column; null as they came. */
export interface SortOrder { column: number; descending: boolean }

/** A cell as it is read; numbers with the decimals of their column. */
export function cellText(cell: Cell | undefined, column: Column | undefined): string {
  if (cell === null || cell === undefined) return '';
  if (typeof cell === 'number') return fixed(cell, column?.digits ?? 3);
  return typeof cell === 'string' ? cell : cell.text;
}

/** "top tension [kN]", or the title alone. */
export function titleWithUnit(column: Column): string {
  return column.unit ? `${column.title} [${column.unit}]` : column.title;
}

/** Ascending, descending, as they came. */
export function nextOrder(order: SortOrder | null, column: number): SortOrder | null {
  if (order?.column !== column) return { column, descending: false };
  return order.descending ? null : { column, descending: true };
}

function compared(a: Cell | undefined, b: Cell | undefined): number {
  if (typeof a === 'number' && typeof b === 'number') return a - b;
  return cellText(a, undefined).localeCompare(cellText(b, undefined), 'en', { numeric: true });
}

/** Indices of the rows in an order: empty cells after the others, sums always last. */
export function rowOrder(table: TableData, order: SortOrder | null): number[] {
  const indices = table.rows.map((_row, i) => i);
  if (order === null) return indices;
  const cell = (row: number): Cell | undefined => table.rows[row]![order.column];
  const rank = (row: number): number => (table.marks?.[row] === 'total' ? 2 : cellText(cell(row), undefined) === '' ? 1 : 0);
  const direction = order.descending ? -1 : 1;
  return indices.sort((a, b) => rank(a) - rank(b) || (rank(a) === 0 ? direction * compared(cell(a), cell(b)) : a - b));
}

/** The column's title with that of its group in front: "Tension: hold [kN]". */
function fullTitles(table: TableData): string[] {
  const groups = (table.groups ?? []).flatMap(([title, span]) => Array<string>(span).fill(title));
  return table.columns.map((column, i) => (groups[i] ? `${groups[i]}: ` : '') + titleWithUnit(column));
}

/** Tab-separated text, as a spreadsheet takes it. */
export function tableText(table: TableData, order: SortOrder | null = null): string {
  const flat = (text: string): string => text.replace(/\s+/g, ' ');
  const rows = rowOrder(table, order).map((row) => table.columns.map((column, i) => cellText(table.rows[row]![i], column)));
  return [fullTitles(table), ...rows].map((cells) => `${cells.map(flat).join('\t')}\n`).join('');
}
