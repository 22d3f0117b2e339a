// The open model: text, fields and diagnostics, and everything that changes them. The program owns the state; the page
// sends each change with its revision, so that two tabs cannot overwrite each other unnoticed.
import { batch, computed, signal } from '@preact/signals';
import { ApiError, get, post, put } from '../api/client';
import type { Change, Diagnostic, DiskConflict, Field, Info, ModelAnswer } from '../api/types';
import { UndoStack, type Kept } from '../logic/undo';
import { withoutPaths } from '../logic/findings';
import { say, sayError } from './notices';

export const info = signal<Info | null>(null);
export const text = signal('');
export const fileName = signal('');
export const saved = signal(true);
export const revision = signal(0);
export const diagnostics = signal<Diagnostic[]>([]);
export const fields = signal<Field[]>([]);
export const hasModel = signal(false);
export const loading = signal(true);
/** Conflict with another tab: the text of this tab, kept until the user decides between the two. */
export const conflict = signal<{ mine: string; changes: Change[] } | null>(null);
/** Conflict with the file on disk: both texts, until the user decides. */
export const overwrite = signal<{ name: string; mine: string; theirs: string; version: string } | null>(null);
/** Version of the model file known to this page. */
export const disk = signal<string | null | undefined>(undefined);
/** An unchanged example: replacing it loses nothing. */
const untouched = signal<string | null>(null);
/** True if opening another model would lose changes. */
export const unsaved = computed(() => hasModel.value && !saved.value && text.value !== untouched.value);
/** Counts opened models, for everything that is reset then (camera, sliders). */
export const opened = signal(0);

export const errors = computed(() => diagnostics.value.filter((d) => d.severity === 'error'));
export const byPath = computed(() => new Map(fields.value.map((f) => [f.path, f])));
export const title = computed(() => String(byPath.value.get('title')?.value ?? '') || fileName.value || 'New model');

// Undo is stored in the tab, so that it survives a reload.
const undoKey = 'overbend.undo';
const undoRoom = 1_500_000; // characters

function keptUndo(): Kept | null {
  try { return JSON.parse(sessionStorage.getItem(undoKey) ?? 'null') as Kept | null; } catch { return null; }
}

let undoStack = new UndoStack('');
export const canUndo = signal(false);
export const canRedo = signal(false);

function noteUndo(): void {
  canUndo.value = undoStack.canUndo;
  canRedo.value = undoStack.canRedo;
  try { sessionStorage.setItem(undoKey, JSON.stringify(undoStack.keep(undoRoom))); } catch { /* no space, or a private window: undo ends with a reload */ }
}

// Requests that change the model are sequential: each needs the revision of the previous one.
let queue: Promise<unknown> = Promise.resolve();
export const writing = signal(0);
/** True if the program has not received the text because it did not answer. */
const unsent = signal(false);

function inTurn<T>(act: () => Promise<T>): Promise<T> {
  ++writing.value;
  const next = queue.then(act, act).finally(() => { --writing.value; });
  queue = next.catch(() => undefined);
  return next;
}

function take(answer: Partial<ModelAnswer>): void {
  if (answer.text !== undefined) text.value = answer.text;
  if (answer.name !== undefined) fileName.value = answer.name;
  if (answer.saved !== undefined) saved.value = answer.saved;
  if (answer.diagnostics) diagnostics.value = answer.diagnostics.map((d) => ({ ...d, message: withoutPaths(d.message) }));
  if (answer.fields) fields.value = answer.fields;
  if (answer.revision !== undefined) revision.value = answer.revision;
  if (answer.disk !== undefined) disk.value = answer.disk;
}

/** `steps`: undo steps; empty for an opened file. */
function takeOpened(answer: ModelAnswer, steps = new UndoStack(answer.text)): void {
  take(answer);
  conflict.value = null;
  overwrite.value = null;
  untouched.value = null;
  hasModel.value = answer.text.trim() !== '';
  undoStack = steps;
  noteUndo();
  ++opened.value;
}

export async function start(): Promise<void> {
  try {
    info.value = await get<Info>('info');
    if (info.value.has_model) {
      const answer = await get<ModelAnswer>('model');
      takeOpened(answer, UndoStack.from(keptUndo(), answer.text));
    }
  } catch (error) {
    sayError(error);
  } finally {
    loading.value = false;
  }
}

async function guarded(act: () => Promise<void>, mine: () => string, changes: Change[] = []): Promise<boolean> {
  try {
    await inTurn(act);
    return true;
  } catch (error) {
    if (error instanceof ApiError && error.status === 409 && (error.body as Partial<DiskConflict> | null)?.error?.reason === 'disk') {
      const { disk: found, revision: ownRevision } = error.body as DiskConflict;
      if (ownRevision !== undefined) revision.value = ownRevision;
      overwrite.value = { name: found.name, mine: mine(), theirs: found.text, version: found.version };
      return false;
    }
    if (error instanceof ApiError && error.status === 409) {
      conflict.value = { mine: mine(), changes: [...(conflict.value?.changes ?? []), ...changes] };
      return false;
    }
    throw error;
  }
}

/** A text from the editor, from undo, or a new model. The page shows it at once, and the program checks it afterwards. */
export async function putText(next: string, origin: string, name?: string): Promise<void> {
  if (origin !== 'undo') { undoStack.push(next, origin, performance.now()); noteUndo(); }
  text.value = next;
  try {
    await guarded(async () => {
      const answer = await put<ModelAnswer>('model', { text: next, revision: revision.value, ...(name === undefined ? {} : { name }) });
      // Text typed since then is newer; its own request follows.
      take({ ...answer, text: text.value === next ? next : text.value });
      if (name !== undefined) fileName.value = name;
      hasModel.value = true;
    }, () => next);
    unsent.value = false;
  } catch (error) {
    if (error instanceof ApiError && error.status === 0) unsent.value = true;
    sayError(error);
  }
}

/** Sends the text that the program did not receive during an interruption. */
export function sendAgain(): void { if (unsent.value) void putText(text.value, 'undo'); }

/** Sets keys in the YAML. Returns false if another change came first, after which the user is asked. Throws with the reason
 * of the program if the keys cannot be set. `taken` runs together with the change, so that no intermediate state is shown. */
export async function setKeys(changes: Change[], taken?: () => void): Promise<boolean> {
  return guarded(async () => {
    const answer = await post<ModelAnswer>('model/set', { changes, revision: revision.value });
    batch(() => { take(answer); taken?.(); });
    undoStack.push(answer.text, 'form', performance.now());
    noteUndo();
  }, () => text.value, changes);
}

export function undo(): void { const t = undoStack.undo(); noteUndo(); if (t !== null) void putText(t, 'undo'); }
export function redo(): void { const t = undoStack.redo(); noteUndo(); if (t !== null) void putText(t, 'undo'); }

export async function openNew(newText: string): Promise<void> {
  const first = !hasModel.value;
  await putText(newText, 'new', '');
  if (first) { undoStack = new UndoStack(newText); noteUndo(); }
  untouched.value = null;
  ++opened.value;
}

export async function openFile(name: string): Promise<void> {
  try { takeOpened(await inTurn(() => post<ModelAnswer>('model/open', { name }))); } catch (error) { sayError(error); }
}

export async function openExample(name: string): Promise<void> {
  try {
    const example = (await get<{ text: string }>(`examples/${encodeURIComponent(name)}`)).text;
    await openNew(example);
    untouched.value = example;
  } catch (error) { sayError(error); }
}

/** `version`: version of the file to be replaced, if the user has confirmed it; otherwise the version that was read. */
export async function save(name: string, version?: string): Promise<boolean> {
  try {
    const known = version ?? (name === fileName.value ? disk.value : undefined);
    const done = await guarded(async () => {
      const sent = text.value;
      const answer = await post<ModelAnswer>('model/save', { name, text: sent, revision: revision.value, ...(known === undefined ? {} : { disk: known }) });
      // Text typed since then is newer; its own request follows.
      take({ ...answer, text: text.value === sent ? answer.text : text.value });
    }, () => text.value);
    if (done) { overwrite.value = null; say(`Saved as ${fileName.value}`); }
    return done;
  } catch (error) { sayError(error); return false; }
}

/** Replaces the text by that of the file; undo restores it. */
export async function takeFile(name: string): Promise<void> {
  try {
    const answer = await inTurn(() => post<ModelAnswer>('model/open', { name }));
    undoStack.push(answer.text, 'other', performance.now());
    takeOpened(answer, undoStack);
  } catch (error) { sayError(error); }
}

/** Typed text that has not been sent yet. */
export const typing = signal(false);

/** The browser warns before the page is closed with unsent changes. */
export function guardLeaving(): void {
  addEventListener('beforeunload', (e) => { if (typing.value || writing.value > 0 || unsent.value) e.preventDefault(); });
}

/** Counts decisions for the newer text: a field then shows it, even if the model has the same value as before. */
export const newerChosen = signal(0);

/** `unasked`: only if no change of this tab is pending, which would be lost. */
export async function takeTheirs(unasked = false): Promise<void> {
  try {
    const theirs = await get<ModelAnswer>('model');
    if (unasked && (writing.value > 0 || conflict.value || typing.value || theirs.revision <= revision.value)) return;
    const another = theirs.name !== fileName.value;
    undoStack.push(theirs.text, 'other', performance.now());
    if (another) takeOpened(theirs, undoStack);
    else { take(theirs); hasModel.value = theirs.text.trim() !== ''; noteUndo(); }
    if (!unasked) ++newerChosen.value;
    conflict.value = null;
  } catch (error) { sayError(error); }
}

export async function keepMine(): Promise<void> {
  const c = conflict.value;
  if (!c) return;
  conflict.value = null;
  try {
    revision.value = (await get<ModelAnswer>('model')).revision;
    await putText(c.mine, 'other');
    if (c.changes.length) await setKeys(c.changes);
  } catch (error) { sayError(error); }
}

export function modelEvent(event: { revision: number }): void {
  // The event may overtake the answer to a change of this tab: check again when nothing is pending.
  void queue.then(() => setTimeout(() => {
    if (writing.value > 0 || conflict.value || typing.value || event.revision <= revision.value) return;
    const before = text.value;
    void takeTheirs(true).then(() => { if (text.value !== before) say('Changed in another tab'); });
  }, 50));
}
