// Changes of a list as the program takes them, in one step: cells, rows added, taken away, put in another order.
import type { Change } from '../api/types';
import { nextName } from './firstItems';
import type { GridColumn } from './gridColumns';
import { parseQuantity, tidy } from './units';
import { valueIn, withValue } from './gridValues';

export interface CellEdit { row: number; key: string; value: string | number | null }

/** Beyond this many changed cells rows are written as a whole: every change costs the program a reading of the text. */
export const mostCells = 60;
/** The program takes no more in one request. */
export const mostChanges = 1000;

const cellPath = (list: string, row: number, key: string): string => `${list}[${row}]${key ? `.${key}` : ''}`;

const rowsIn = (edits: CellEdit[]): number[] => [...new Set(edits.map((e) => e.row))].sort((a, b) => a - b);

/** Cells of rows that are there or come next; of few only the cells themselves are written, which keeps their layout.
 * `fill`: what a new row has besides. */
export function cellChanges(list: string, items: unknown[], edits: CellEdit[], fill: (row: number) => unknown = () => ({})): Change[] {
  const old = edits.filter((e) => e.row < items.length && !(e.value === null && valueIn(items[e.row], e.key) === undefined));
  const added = edits.filter((e) => e.row >= items.length);
  const rowChange = (own: CellEdit[]) => (row: number): Change => ({
    path: cellPath(list, row, ''), value: own.filter((e) => e.row === row).reduce((item, e) => withValue(item, e.key, e.value), row < items.length ? items[row] : fill(row)),
  });
  const cells = old.map((e): Change => ({ path: cellPath(list, e.row, e.key), value: e.value }));
  return [...(old.length > mostCells ? rowsIn(old).map(rowChange(old)) : cells), ...rowsIn(added).map(rowChange(added))];
}

/** From the items as they are to those that shall be there. */
export function listChanges(list: string, before: unknown[], after: unknown[]): Change[] {
  if (after.length === 0) return before.length ? [{ path: list, value: null }] : [];
  const same = (row: number): boolean => row < before.length && JSON.stringify(before[row]) === JSON.stringify(after[row]);
  const written = after.flatMap((value, row) => (same(row) ? [] : [{ path: cellPath(list, row, ''), value }]));
  const left = before.slice(after.length).map((_item, i, all) => ({ path: cellPath(list, after.length + all.length - 1 - i, ''), value: null }));
  return [...written, ...left];
}

/** Rows taken away from the last to the first, so that the others keep their numbers until then. */
export function removal(list: string, count: number, rows: number[]): Change[] {
  if (rows.length >= count) return [{ path: list, value: null }];
  return [...rows].sort((a, b) => b - a).map((row) => ({ path: cellPath(list, row, ''), value: null }));
}

const nameIn = (item: unknown): string | null => {
  const name = typeof item === 'object' && item !== null ? (item as Record<string, unknown>).name : undefined;
  return name === undefined || name === null ? null : String(name);
};

/** The item under a name that no other has. */
export function renamed(item: unknown, others: unknown[]): unknown {
  let name = nameIn(item);
  if (name === null) return item;
  const taken = new Set(others.map(nameIn));
  while (taken.has(name)) name = nextName(name);
  return { ...(item as object), name };
}

/** Copies of some rows behind the last of them. */
export function duplicated(items: unknown[], rows: number[]): unknown[] {
  const next = [...items];
  const copies: unknown[] = [];
  for (const row of rows) copies.push(renamed(items[row], [...items, ...copies]));
  next.splice(Math.max(...rows) + 1, 0, ...copies);
  return next;
}

/** Rows that follow each other moved by one; the same where they are at the end already. */
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

/** A row that comes after the last: a copy of it, places continued with the step of the last two. */
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
