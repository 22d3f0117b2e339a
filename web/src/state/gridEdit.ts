// Typed and pasted cells on their way into the model: what can be read is written in one step, what cannot stays in its
// cell with the reason. Rows of lists added, removed and moved.
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
const tooLong = 'The list is too long to be written here: change it in the YAML.';

/** By the path of a list: columns that the user added, and the units chosen for some. */
export const askedColumns = signal<Record<string, string[]>>({});
export const chosenUnits = signal<Record<string, Record<string, string>>>({});
/** Changes of grids that the program has not answered yet. */
export const writingRows = signal(0);

effect(() => { void opened.value; untracked(() => { drafts.value = new Map(); }); });

export const modelParts = computed<ModelParts>(() => ({ byPath: byPath.value, fields: fields.value, diagnostics: diagnosticsByKey(diagnostics.value), drafts: drafts.value }));

function setDrafts(change: (map: Map<string, Draft>) => void): void {
  const next = new Map(drafts.value);
  change(next);
  drafts.value = next;
}

export const dropDrafts = (paths: string[]): void => setDrafts((map) => { for (const path of paths) map.delete(path); });

/** Changes of rows rest on those before them: one after another. */
let queue: Promise<unknown> = Promise.resolve();

function inTurn(act: () => Promise<boolean>): Promise<boolean> {
  ++writingRows.value;
  const next = queue.then(act, act).finally(() => { --writingRows.value; });
  queue = next.catch(() => undefined);
  return next;
}

async function send(changes: Change[]): Promise<boolean> {
  if (changes.length === 0) return true;
  if (changes.length > mostChanges) throw new Error(`${changes.length} changes are more than the ${mostChanges} that can be made in one step`);
  return setKeys(changes);
}

/** A cell by its place in a list, with what was typed and what is read of it. */
export interface TypedCell { list: string; row: number; key: string; text: string; read: ReadCell }

const pathOf = (cell: { list: string; row: number; key: string }): string => `${cell.list}[${cell.row}]${cell.key ? `.${cell.key}` : ''}`;

function note(cells: TypedCell[]): Map<string, Draft> {
  const own = new Map<string, Draft>();
  for (const cell of cells) {
    const path = pathOf(cell), base = writtenText(byPath.value.get(path));
    if ('message' in cell.read) own.set(path, { text: cell.text, message: cell.read.message, base });
    else own.set(path, { text: cell.text, message: '', base });
  }
  setDrafts((map) => { for (const [path, draft] of own) map.set(path, draft); });
  return own;
}

/** What was on its way is in the model now, or was refused for a reason; newer texts in the same cells stay. */
function settle(own: Map<string, Draft>, refused: string): void {
  setDrafts((map) => {
    for (const [path, draft] of own) {
      if (map.get(path) !== draft || draft.message) continue;
      if (refused) map.set(path, { ...draft, message: refused });
      else map.delete(path);
    }
  });
}

const reason = (error: unknown): string => (error instanceof ApiError || error instanceof Error ? error.message : String(error));

function isSame(cell: TypedCell): boolean {
  if ('message' in cell.read) return true;
  return String(cell.read.value ?? '') === writtenText(byPath.value.get(pathOf(cell)));
}

/** Number of items in the model, also of those that the program did not name. */
export function countIn(list: string): number {
  const field = byPath.value.get(list);
  return field?.given && field.kind === 'list' ? field.count ?? 0 : 0;
}

function changesIn(list: string, edits: CellEdit[], fill: (row: number) => unknown): Change[] {
  const items = listItems(fields.value, list);
  if (!items && edits.length > mostCells) throw new Error(tooLong);
  const known = items ?? Array.from({ length: countIn(list) }, (): unknown => ({}));
  // of items that are not known all that matters is which of their cells are given
  if (!items) for (const e of edits) if (e.row < known.length) known[e.row] = withValue(known[e.row], e.key, e.value ?? '');
  return cellChanges(list, known, edits, fill);
}

/** `fill`: what a new row has besides the cells that were typed. */
export function writeCells(typed: TypedCell[], fill: (list: string, row: number) => unknown = () => ({})): Promise<boolean> {
  const own = note(typed);
  return inTurn(async () => {
    try {
      const lists = [...new Set(typed.map((cell) => cell.list))];
      const changes = lists.flatMap((list) => {
        const cells = typed.filter((cell) => cell.list === list && !isSame(cell));
        const edits = cells.flatMap((cell): CellEdit[] => ('value' in cell.read ? [{ row: cell.row, key: cell.key, value: cell.read.value }] : []));
        return changesIn(list, edits, (row) => fill(list, row));
      });
      const done = await send(changes);
      settle(own, '');
      return done;
    } catch (error) {
      settle(own, reason(error));
      return false;
    }
  });
}

/** Drafts of a list whose rows got other numbers; null: the row is gone. */
function moveDrafts(list: string, next: (row: number) => number | null): void {
  setDrafts((map) => {
    const own = [...map].filter(([path]) => path.startsWith(`${list}[`));
    for (const [path] of own) map.delete(path);
    for (const [path, draft] of own) {
      const match = /^\[(\d+)\](.*)$/.exec(path.slice(list.length))!;
      const row = next(Number(match[1]));
      if (row !== null) map.set(`${list}[${row}]${match[2]}`, draft);
    }
  });
}

/** Another order or other rows of a list. `moves`: the new number of a row that was there. */
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

/** All rows of a list from a pasted table; `prefix`: what has to be done before there can be a list. */
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
