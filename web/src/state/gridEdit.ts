// Typed and pasted cells: readable ones are written in one step, unreadable ones stay in their
// cell with the reason. Rows of lists are added, removed and moved.
import { computed, effect, signal, untracked } from '@preact/signals';
import { ApiError, get } from '../api/client';
import type { Change } from '../api/types';
import type { ReadCell } from '../logic/gridCells';
import { cellChanges, listChanges, mostCells, mostChanges, removal, type CellEdit } from '../logic/gridEdits';
import { listItems, withValue } from '../logic/gridValues';
import { diagnosticsByKey, writtenText, type Draft, type ModelParts } from '../logic/gridView';
import type { Schema } from '../logic/schema';
import { byPath, diagnostics, fields, opened, setKeys } from './model';
import { sayError } from './notices';

export const schema = signal<Schema | null>(null);
let schemaAsked = false;
export function loadSchema(): void {
  if (schemaAsked) return;
  schemaAsked = true;
  get<Schema>('schema').then((s) => { schema.value = s; }).catch((error: unknown) => { schemaAsked = false; sayError(error); });
}

export const drafts = signal<Map<string, Draft>>(new Map());
const tooLong = 'The list is too long to be edited here: edit it in the YAML.';

/** By the path of a list: added columns, and selected units. */
export const askedColumns = signal<Record<string, string[]>>({});
export const chosenUnits = signal<Record<string, Record<string, string>>>({});
/** Pending changes of grids. */
export const writingRows = signal(0);

effect(() => { void opened.value; untracked(() => { drafts.value = new Map(); }); });

export const modelParts = computed<ModelParts>(() => ({ byPath: byPath.value, fields: fields.value, diagnostics: diagnosticsByKey(diagnostics.value), drafts: drafts.value }));

function setDrafts(change: (map: Map<string, Draft>) => void): void {
  const next = new Map(drafts.value);
  change(next);
  drafts.value = next;
}

export const dropDrafts = (paths: string[]): void => setDrafts((map) => { for (const path of paths) map.delete(path); });

/** Changes of rows depend on the previous ones: they are sent one after another. */
let queue: Promise<unknown> = Promise.resolve();

function inTurn(act: () => Promise<boolean>): Promise<boolean> {
  ++writingRows.value;
  const next = queue.then(act, act).finally(() => { --writingRows.value; });
  queue = next.catch(() => undefined);
  return next;
}

async function send(changes: Change[]): Promise<boolean> {
  if (changes.length === 0) return true;
  if (changes.length > mostChanges) throw new Error(`${changes.length} changes exceed the limit of ${mostChanges} in one step`);
  return setKeys(changes);
}

/** A cell by its position in a list, with its typed text and value. */
export interface TypedCell { list: string; row: number; key: string; text: string; read: ReadCell }

const cellKey = (cell: { list: string; row: number; key: string }): string => `${cell.list}[${cell.row}]${cell.key ? `.${cell.key}` : ''}`;

function note(cells: TypedCell[]): Map<string, Draft> {
  const written = new Map<string, Draft>();
  for (const cell of cells) {
    const path = cellKey(cell), base = writtenText(byPath.value.get(path));
    if ('message' in cell.read) written.set(path, { text: cell.text, message: cell.read.message, base });
    else written.set(path, { text: cell.text, message: '', base });
  }
  setDrafts((map) => { for (const [path, draft] of written) map.set(path, draft); });
  return written;
}

/** Pending cells are now in the model, or were rejected with a reason; newer texts in the same cells are kept. */
function settle(written: Map<string, Draft>, reason: string): void {
  setDrafts((map) => {
    for (const [path, draft] of written) {
      if (map.get(path) !== draft || draft.message) continue;
      if (reason) map.set(path, { ...draft, message: reason });
      else map.delete(path);
    }
  });
}

const reason = (error: unknown): string => (error instanceof ApiError || error instanceof Error ? error.message : String(error));

function isSame(cell: TypedCell): boolean {
  if ('message' in cell.read) return true;
  return String(cell.read.value ?? '') === writtenText(byPath.value.get(cellKey(cell)));
}

/** Number of items in the model, including those without fields. */
export function countIn(list: string): number {
  const field = byPath.value.get(list);
  return field?.given && field.kind === 'list' ? field.count ?? 0 : 0;
}

function changesIn(list: string, edits: CellEdit[], fill: (row: number) => unknown): Change[] {
  const items = listItems(fields.value, list);
  if (!items && edits.length > mostCells) throw new Error(tooLong);
  const known = items ?? Array.from({ length: countIn(list) }, (): unknown => ({}));
  // for unknown items only the given cells matter
  if (!items) for (const e of edits) if (e.row < known.length) known[e.row] = withValue(known[e.row], e.key, e.value ?? '');
  return cellChanges(list, known, edits, fill);
}

/** `fill`: values of a new row in addition to the typed cells. */
export function writeCells(typed: TypedCell[], fill: (list: string, row: number) => unknown = () => ({})): Promise<boolean> {
  const written = note(typed);
  return inTurn(async () => {
    try {
      const lists = [...new Set(typed.map((cell) => cell.list))];
      const changes = lists.flatMap((list) => {
        const cells = typed.filter((cell) => cell.list === list && !isSame(cell));
        const edits = cells.flatMap((cell): CellEdit[] => ('value' in cell.read ? [{ row: cell.row, key: cell.key, value: cell.read.value }] : []));
        return changesIn(list, edits, (row) => fill(list, row));
      });
      const done = await send(changes);
      settle(written, '');
      return done;
    } catch (error) {
      settle(written, reason(error));
      return false;
    }
  });
}

/** Drafts of a list whose rows were renumbered; null: the row is gone. */
function moveDrafts(list: string, next: (row: number) => number | null): void {
  setDrafts((map) => {
    const affected = [...map].filter(([path]) => path.startsWith(`${list}[`));
    for (const [path] of affected) map.delete(path);
    for (const [path, draft] of affected) {
      const match = /^\[(\d+)\](.*)$/.exec(path.slice(list.length))!;
      const row = next(Number(match[1]));
      if (row !== null) map.set(`${list}[${row}]${match[2]}`, draft);
    }
  });
}

/** Reorders or replaces rows of a list. `moves`: new index of a previous row. */
export function writeItems(list: string, make: (items: unknown[]) => unknown[], moves: (row: number) => number | null = (row) => row): Promise<boolean> {
  return inTurn(async () => {
    try {
      const items = byPath.value.get(list)?.kind === 'list' ? listItems(fields.value, list) : [];
      if (!items) throw new Error(tooLong);
      const done = await send(listChanges(list, items, make(items)));
      if (done) moveDrafts(list, moves);
      return done;
    } catch (error) { sayError(error); return false; }
  });
}

export function removeRows(list: string, rows: number[]): Promise<boolean> {
  return inTurn(async () => {
    try {
      const done = await send(removal(list, countIn(list), rows));
      if (done) moveDrafts(list, (row) => (rows.includes(row) ? null : row - rows.filter((gone) => gone < row).length));
      return done;
    } catch (error) { sayError(error); return false; }
  });
}

/** Replaces all rows of a list by a pasted table; `prefix`: changes required before there can be a list. */
export function replaceItems(list: string, items: (before: unknown[]) => unknown[], bad: TypedCell[], prefix: Change[] = [], isAppended = false): Promise<boolean> {
  return inTurn(async () => {
    try {
      const before = byPath.value.get(list)?.kind === 'list' ? listItems(fields.value, list) : [];
      if (!before) throw new Error(tooLong);
      const done = await send([...prefix, ...listChanges(list, prefix.length ? [] : before, items(before))]);
      if (done) { if (!isAppended) moveDrafts(list, () => null); note(bad); }
      return done;
    } catch (error) { sayError(error); return false; }
  });
}

export async function writeChanges(changes: Change[]): Promise<boolean> {
  return inTurn(async () => {
    try { return await send(changes); } catch (error) { sayError(error); return false; }
  });
}
