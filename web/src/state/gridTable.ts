// The table of one list of the model or of several of a kind: contents of the grid, and its commands.
import { useEffect, useMemo, useRef } from 'preact/hooks';
import { firstItem } from '../logic/firstItems';
import { readCell } from '../logic/gridCells';
import { listColumns, shownColumns, type GridColumn } from '../logic/gridColumns';
import { duplicated, nextItem, shifted } from '../logic/gridEdits';
import { columnSizes, readPaste, type Pasted } from '../logic/gridPaste';
import { resultColumns } from '../logic/gridResults';
import { cellPath, inputColumns, itemCount, listColumn, resultView, viewRows, writtenText, type ViewColumn, type ViewList, type ViewRow } from '../logic/gridView';
import { valueIn, withValue } from '../logic/gridValues';
import type { GridCell, PastePlace } from '../panels/grid/gridParts';
import { askedColumns, chosenUnits, countIn, dropDrafts, loadSchema, modelParts, removeRows, replaceItems, schema, writeCells, writeItems, type TypedCell } from './gridEdit';
import { byPath } from './model';
import { listedStages } from './operation';
import { runSummary } from './runs';
import { calmLay, ofRun } from './shown';

const ownColumn: ViewColumn = { id: listColumn, title: 'on', unit: '', group: '', info: 'Structure of the box', editable: false, isText: true, units: [], choices: [], column: null };

export interface GridTable {
  columns: ViewColumn[];
  rows: ViewRow[];
  /** Columns that are not shown. */
  hidden: GridColumn[];
  /** Columns and units are stored under this path. */
  key: string;
}

/** Unchanged rows remain the same objects, so that they are not drawn again. */
function keptRows(before: ViewRow[], after: ViewRow[]): ViewRow[] {
  const known = new Map(before.map((row) => [row.id, row]));
  return after.map((row) => { const old = known.get(row.id); return old && JSON.stringify(old) === JSON.stringify(row) ? old : row; });
}

function keptColumns(before: ViewColumn[], after: ViewColumn[]): ViewColumn[] {
  return JSON.stringify(before) === JSON.stringify(after) ? before : after;
}

export function useGridTable(lists: ViewList[]): GridTable | null {
  useEffect(loadSchema, []);
  const before = useRef<{ rows: ViewRow[]; columns: ViewColumn[] }>({ rows: [], columns: [] });
  const root = schema.value, model = modelParts.value, key = lists[0]?.path ?? '';
  const asked = askedColumns.value[key], units = chosenUnits.value[key];
  const all = useMemo(() => (root && key ? listColumns(root, key) : []), [root, key]);
  const lay = calmLay.value, run = ofRun.value ? runSummary.value : null, stages = listedStages.value;
  const results = useMemo(() => resultColumns(key, { lay, run, stages }), [key, lay, run, stages]);
  const shown = useMemo(() => {
    const items = lists.flatMap((list) => Array.from({ length: itemCount(model, list.path) }, (_none, i) => ({ id: `${list.path}[${i}]` })));
    const isGiven = (column: string): boolean => items.some((row) => model.byPath.get(cellPath(row, column))?.given || model.drafts.has(cellPath(row, column)));
    return shownColumns(all, isGiven, [...(asked ?? []), ...(lists[0]?.usual ?? [])], results.length > 0);
  }, [all, model, asked, key, results.length > 0]);
  const inputs = useMemo(() => [...(lists.length > 1 ? [ownColumn] : []), ...inputColumns(shown, lists, model, units ?? {})], [shown, model, units, lists.length]);
  const rows = useMemo(() => viewRows(lists, inputs, results, model), [inputs, results, model, JSON.stringify(lists)]);
  if (!root || all.length === 0) return null;
  before.current = { rows: keptRows(before.current.rows, rows), columns: keptColumns(before.current.columns, [...inputs, ...results.map(resultView)]) };
  return { ...before.current, hidden: all.filter((c) => !shown.includes(c)), key };
}

export function askColumns(key: string, columns: string[]): void {
  askedColumns.value = { ...askedColumns.value, [key]: [...new Set([...(askedColumns.value[key] ?? []), ...columns])] };
}

export function chooseUnit(key: string, column: ViewColumn, unit: string): void {
  chosenUnits.value = { ...chosenUnits.value, [key]: { ...chosenUnits.value[key], [column.id]: unit } };
}

const typedCell = ({ row, column, text }: GridCell): TypedCell => ({ list: row.list, row: row.index, key: column.id, text, read: readCell(text, column.column!, column.unit) });

export const editCells = (cells: GridCell[]): void => { void writeCells(cells.filter((c) => c.column.column !== null).map(typedCell)); };
export const dropCells = (cells: GridCell[]): void => dropDrafts(cells.map((c) => cellPath(c.row, c.column.id)));

/** Values of a new row: those common to the last two rows, in addition to pasted values. */
export function commonValues(items: unknown[], columns: GridColumn[], without: string[]): unknown {
  const last = items.at(-1), before = items.at(-2) ?? last;
  if (last === undefined || columns[0]?.key === '') return {};
  return columns.filter((c) => c.key !== 'name' && !without.includes(c.key)).reduce<unknown>((item, c) => {
    const value = valueIn(last, c.key);
    return value !== undefined && JSON.stringify(value) === JSON.stringify(valueIn(before, c.key)) ? withValue(item, c.key, value) : item;
  }, {});
}

function itemsIn(list: string, columns: GridColumn[]): unknown[] {
  const count = itemCount(modelParts.value, list);
  return Array.from({ length: count }, (_none, i) => columns.reduce<unknown>((item, c) => {
    const written = writtenText(byPath.value.get(cellPath({ id: `${list}[${i}]` }, c.key)));
    return written ? withValue(item, c.key, written) : item;
  }, {}));
}

const pastedText = (text: string, place: PastePlace): string[][] | null => (/[\t\n]/.test(text.trim()) || (place.rectangle.top === place.rectangle.bottom && place.rectangle.left === place.rectangle.right) ? null : [[text.trim()]]);

/** Including hidden columns. */
export const allColumns = (table: GridTable): GridColumn[] => [...table.columns.flatMap((c) => (c.column ? [c.column] : [])), ...table.hidden];

/** A pasted table; its heads may name hidden columns. */
export const readTable = (table: GridTable, text: string, from = 0): Pasted => readPaste(text, table.columns, from, inputColumns(table.hidden, [], modelParts.value, {}), columnSizes(table.columns, table.rows));

/** Into the cells from the selected one on; missing rows are added to the last list. */
export function pasteAt(table: GridTable, text: string, place: PastePlace): Pasted {
  const { rectangle: r } = place;
  if (pastedText(text, place)) {
    // a single value fills the selection
    const cells = place.rows.slice(0, r.bottom - r.top + 1).flatMap((row) => table.columns.slice(r.left, r.right + 1).filter((c) => c.editable).map((column) => ({ row, column, text: text.trim() })));
    editCells(cells);
    return { rows: [], ignored: [], hasHead: false, columns: [] };
  }
  const pasted = readTable(table, text, place.column);
  const columns = allColumns(table);
  const last = place.rows.at(-1)!;
  const count = countIn(last.list);
  const cells = pasted.rows.flatMap((row, i) => row.cells.map((cell): TypedCell => {
    const target = place.rows[i], key = cell.column.id;
    return { list: target?.list ?? last.list, row: target?.index ?? count + i - place.rows.length, key, text: cell.text, read: cell.read };
  }));
  const common = commonValues(itemsIn(last.list, columns), columns, pasted.columns.map((c) => c.id));
  void writeCells(cells, () => common);
  return pasted;
}

export type PasteMode = 'replace' | 'append';

/** A whole table that replaces a list, or is appended to its rows. */
export function pasteTable(list: string, columns: GridColumn[], pasted: Pasted, mode: PasteMode): Promise<boolean> {
  const field = byPath.value.get(list), isArc = field?.kind === 'map' && field.given;
  const without = pasted.columns.map((c) => c.id), radius = list.replace(/boxes$/, 'radius');
  const prefix = isArc ? [{ path: list, value: null }, ...(byPath.value.get(radius)?.given ? [{ path: radius, value: null }] : [])] : [];
  const start = mode === 'append' ? countIn(list) : 0;
  const bad = pasted.rows.flatMap((row, i) => row.cells.filter((c) => 'message' in c.read).map((c): TypedCell => ({ list, row: start + i, key: c.column.id, text: c.text, read: c.read })));
  // a table with all required columns is a new list; other tables overwrite the present rows
  const isWhole = columns.every((c) => !c.required || without.includes(c.key));
  const make = (before: unknown[]): unknown[] => {
    const common = commonValues(before, columns, without);
    const items = pasted.rows.map((row, i) => row.cells.reduce<unknown>((item, c) => ('value' in c.read ? withValue(item, c.column.id, c.read.value) : item), (mode === 'replace' && !isWhole ? before[i] : undefined) ?? common));
    return mode === 'append' ? [...before, ...items] : items;
  };
  return replaceItems(list, make, bad, prefix, mode === 'append');
}

export function addRow(list: string, columns: GridColumn[]): Promise<boolean> {
  const first = firstItem(list, byPath.value.get('environment.water_depth')?.si ?? 0, String(byPath.value.get('operation.type')?.value ?? ''));
  return writeItems(list, (items) => [...items, nextItem(items, columns, first)]);
}

/** The selected rows by their list. */
function byList(rows: ViewRow[]): [list: string, indices: number[]][] {
  return [...new Set(rows.map((row) => row.list))].map((list) => [list, rows.filter((row) => row.list === list).map((row) => row.index).sort((a, b) => a - b)]);
}

export function removeSelected(rows: ViewRow[]): void { for (const [list, indices] of byList(rows)) void removeRows(list, indices); }

export function duplicateSelected(rows: ViewRow[]): void {
  for (const [list, indices] of byList(rows)) {
    const last = indices.at(-1)!;
    void writeItems(list, (items) => duplicated(items, indices), (row) => (row > last ? row + indices.length : row));
  }
}

export async function moveSelected(rows: ViewRow[], step: 1 | -1): Promise<string> {
  const [first, ...others] = byList(rows);
  if (!first || others.length > 0) return '';
  const [list, indices] = first, top = indices[0]!, bottom = indices.at(-1)!;
  const count = itemCount(modelParts.value, list);
  if (bottom - top + 1 !== indices.length || (step < 0 ? top === 0 : bottom === count - 1)) return '';
  const neighbour = step < 0 ? top - 1 : bottom + 1;
  const moves = (row: number): number => (row === neighbour ? (step < 0 ? bottom : top) : row >= top && row <= bottom ? row + step : row);
  return (await writeItems(list, (items) => shifted(items, top, bottom, step), moves)) ? `${list}[${top + step}]` : '';
}

/** The order shown becomes that of the model. */
export function writeOrder(sorted: ViewRow[]): void {
  for (const list of new Set(sorted.map((row) => row.list))) {
    const order = sorted.filter((row) => row.list === list).map((row) => row.index);
    void writeItems(list, (items) => (items.length === order.length ? order.map((i) => items[i]) : items), (row) => order.indexOf(row));
  }
}
