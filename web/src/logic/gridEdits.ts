// Changes of a list in one step: cells, rows added, removed or reordered.
import type { Change } from '../api/types';
import { nextName } from './firstItems';
import type { GridColumn } from './gridColumns';
import { parseQuantity, tidy } from './units';
import { valueIn, withValue } from './gridValues';

export interface CellEdit { row: number; key: string; value: string | number | null }

/** Above this number of changed cells, whole rows are written: the program parses the text once per change. */
export const mostCells = 60;
/** Limit of the program for one request. */
export const mostChanges = 1000;

const cellPath = (list: string, row: number, key: string): string => `${list}[${row}]${key ? `.${key}` : ''}`;

const rowsIn = (edits: CellEdit[]): number[] => [...new Set(edits.map((e) => e.row))].sort((a, b) => a - b);

/** Changes of cells in present or new rows; a few cells are written individually, which keeps the layout of the text.
 * `fill`: values of a new row in addition to the edits. */
export function cellChanges(list: string, items: unknown[], edits: CellEdit[], fill: (row: number) => unknown = () => ({})): Change[] {
  const old = edits.filter((e) => e.row < items.length && !(e.value === null && valueIn(items[e.row], e.key) === undefined));
  const added = edits.filter((e) => e.row >= items.length);
  const rowChange = (rowEdits: CellEdit[]) => (row: number): Change => ({
    path: cellPath(list, row, ''), value: rowEdits.filter((e) => e.row === row).reduce((item, e) => withValue(item, e.key, e.value), row < items.length ? items[row] : fill(row)),
  });
  const cells = old.map((e): Change => ({ path: cellPath(list, e.row, e.key), value: e.value }));
  return [...(old.length > mostCells ? rowsIn(old).map(rowChange(old)) : cells), ...rowsIn(added).map(rowChange(added))];
}

/** Changes from the present items to the required ones. */
export function listChanges(list: string, before: unknown[], after: unknown[]): Change[] {
  if (after.length === 0) return before.length ? [{ path: list, value: null }] : [];
  const same = (row: number): boolean => row < before.length && JSON.stringify(before[row]) === JSON.stringify(after[row]);
  const written = after.flatMap((value, row) => (same(row) ? [] : [{ path: cellPath(list, row, ''), value }]));
  const left = before.slice(after.length).map((_item, i, all) => ({ path: cellPath(list, after.length + all.length - 1 - i, ''), value: null }));
  return [...written, ...left];
}

/** Rows are removed from the last to the first, so that the indices of the others remain valid. */
export function removal(list: string, count: number, rows: number[]): Change[] {
  if (rows.length >= count) return [{ path: list, value: null }];
  return [...rows].sort((a, b) => b - a).map((row) => ({ path: cellPath(list, row, ''), value: null }));
}

const nameIn = (item: unknown): string | null => {
  const name = typeof item === 'object' && item !== null ? (item as Record<string, unknown>).name : undefined;
  return name === undefined || name === null ? null : String(name);
};

/** The item with a unique name. */
export function renamed(item: unknown, others: unknown[]): unknown {
  let name = nameIn(item);
  if (name === null) return item;
  const taken = new Set(others.map(nameIn));
  while (taken.has(name)) name = nextName(name);
  return { ...(item as object), name };
}

/** Copies of some rows after the last of them. */
export function duplicated(items: unknown[], rows: number[]): unknown[] {
  const next = [...items];
  const copies: unknown[] = [];
  for (const row of rows) copies.push(renamed(items[row], [...items, ...copies]));
  next.splice(Math.max(...rows) + 1, 0, ...copies);
  return next;
}

/** Consecutive rows moved by one; unchanged at the end of the list. */
export function shifted(items: unknown[], top: number, bottom: number, step: 1 | -1): unknown[] {
  const neighbour = step < 0 ? top - 1 : bottom + 1;
  if (neighbour < 0 || neighbour >= items.length) return items;
  const next = [...items];
  const [moved] = next.splice(neighbour, 1);
  next.splice(step < 0 ? bottom : top, 0, moved);
  return next;
}

function stepped(last: unknown, before: unknown): string | null {
  const a = parseQuantity(String(before ?? '')), b = parseQuantity(String(last ?? ''));
  if (!a?.unit || a.unit !== b?.unit) return null;
  return `${tidy(2 * b.number - a.number, 8)} ${b.unit}`;
}

const mayStep = ['x', 'y', 'z', 'depth', 'distance', 'arc_length', 'time', 'cable_out', 'pipe_out', 'ahead', 'strain', 'stress', 'curvature', 'moment'];

/** A row after the last: a copy of it, with positions extrapolated by the step of the last two. */
export function nextItem(items: unknown[], columns: GridColumn[], first: unknown): unknown {
  const last = items.at(-1), before = items.at(-2);
  if (last === undefined) return first ?? columns.filter((c) => c.required).reduce<unknown>((item, c) => withValue(item, c.key, c.example || c.standard || '1'), {});
  let next = renamed(last, items);
  if (before === undefined) return next;
  for (const key of mayStep) {
    const value = stepped(valueIn(last, key), valueIn(before, key));
    if (value !== null) next = withValue(next, key, value);
  }
  return next;
}
