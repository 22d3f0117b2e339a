// Texts and sort orders of tables, independent of their drawing.
import type { Cell, Column, TableData } from './document';
import { fixed } from './units';

/** Sort order by a column; null for the original order. */
export interface SortOrder { column: number; descending: boolean }

/** Text of a cell; numbers with the decimals of their column. */
export function cellText(cell: Cell | undefined, column: Column | undefined): string {
  if (cell === null || cell === undefined) return '';
  if (typeof cell === 'number') return fixed(cell, column?.digits ?? 3);
  return typeof cell === 'string' ? cell : cell.text;
}

/** "top tension [kN]", or the title alone. */
export function titleWithUnit(column: Column): string {
  return column.unit ? `${column.title} [${column.unit}]` : column.title;
}

/** Largest first, smallest first, original order; texts from A first. */
export function nextOrder(order: SortOrder | null, column: number, isText = false): SortOrder | null {
  if (order?.column !== column) return { column, descending: !isText };
  return order.descending === isText ? null : { column, descending: isText };
}

const isEmpty = (cell: Cell | undefined): boolean => ['', '-'].includes(cellText(cell, undefined));

/** Some columns give their numbers as texts. */
const numberIn = (cell: Cell | undefined): number => (typeof cell === 'number' ? cell : Number(cellText(cell, undefined)));

function compared(a: Cell | undefined, b: Cell | undefined): number {
  const difference = numberIn(a) - numberIn(b);
  if (!Number.isNaN(difference)) return difference;
  return cellText(a, undefined).localeCompare(cellText(b, undefined), 'en', { numeric: true });
}

/** Indices of the rows in an order: empty cells after the others, sums always last. */
export function rowOrder(table: TableData, order: SortOrder | null): number[] {
  const indices = table.rows.map((_row, i) => i);
  if (order === null) return indices;
  const cell = (row: number): Cell | undefined => table.rows[row]![order.column];
  const rank = (row: number): number => (table.marks?.[row] === 'total' ? 2 : isEmpty(cell(row)) ? 1 : 0);
  const direction = order.descending ? -1 : 1;
  return indices.sort((a, b) => rank(a) - rank(b) || (rank(a) === 0 ? direction * compared(cell(a), cell(b)) : a - b));
}

/** Title of the column with its group in front: "Tension: hold [kN]". */
export function fullTitles(table: TableData): string[] {
  const groups = (table.groups ?? []).flatMap(([title, span]) => Array<string>(span).fill(title));
  return table.columns.map((column, i) => (groups[i] ? `${groups[i]}: ` : '') + titleWithUnit(column));
}

/** Tab-separated text for a spreadsheet. */
export function tableText(table: TableData, order: SortOrder | null = null): string {
  const flat = (text: string): string => text.replace(/\s+/g, ' ');
  const rows = rowOrder(table, order).map((row) => table.columns.map((column, i) => cellText(table.rows[row]![i], column)));
  return [fullTitles(table), ...rows].map((cells) => `${cells.map(flat).join('\t')}\n`).join('');
}

const quoted = (text: string): string => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

/** Comma-separated values as in RFC 4180. */
export const csvText = (rows: (string | number)[][]): string => rows.map((cells) => `${cells.map((cell) => quoted(String(cell))).join(',')}\r\n`).join('');

/** Comma-separated values of a table, with all decimals of its numbers. */
export function tableCsv(table: TableData, order: SortOrder | null = null): string {
  const text = (cell: Cell | undefined): string | number => (typeof cell === 'number' ? cell : cellText(cell, undefined));
  const rows = rowOrder(table, order).map((row) => table.columns.map((_column, i) => text(table.rows[row]![i])));
  return csvText([fullTitles(table), ...rows]);
}
