// The open model: text, fields and faults, and everything that changes them. The program holds the truth; the page
// sends each change with the revision it knows, so that two tabs cannot overwrite each other unseen.
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
/** Another tab was first: this tab's text, kept until the user says which of the two shall stay. */
export const conflict = signal<{ mine: string; changes: Change[] } | null>(null);
/** Save found another text in the file than the one that was read: both, until the user says which shall stay. */
export const overwrite = signal<{ name: string; mine: string; theirs: string; version: string } | null>(null);
/** Version of the model's file that this page knows. */
export const disk = signal<string | null | undefined>(undefined);
/** An example as it was opened: as long as it is untouched nothing would be lost with it. */
const untouched = signal<string | null>(null);
/** Whether opening another model would lose something. */
export const unsaved = computed(() => hasModel.value && !saved.value && text.value !== untouched.value);
/** Counts models that were opened anew, for whatever has to start afresh then (camera, sliders). */
export const opened = signal(0);

export const errors = computed(() => diagnostics.value.filter((d) => d.severity === 'error'));
export const byPath = computed(() => new Map(fields.value.map((f) => [f.path, f])));
export const title = computed(() => String(byPath.value.get('title')?.value ?? '') || fileName.value || 'New model');

// Undo is kept in the tab, so that it outlives a reload.
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
  try { sessionStorage.setItem(undoKey, JSON.stringify(undoStack.keep(undoRoom))); } catch { /* no room, or a private window: undo ends with a reload */ }
}

// Requests that change the model go one after another: each needs the revision that the one before it made.
let queue: Promise<unknown> = Promise.resolve();
export const writing = signal(0);
/** Whether the text is one that the program did not get, since it did not answer. */
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

/** `steps`: what undo goes back to; a file that is opened starts afresh. */
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
      const { disk: found, revision: own } = error.body as DiskConflict;
      if (own !== undefined) revision.value = own;
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

/** A text from the editor, from undo, or a whole new one. The page shows it at once and the program judges it after. */
export async function putText(next: string, origin: string, name?: string): Promise<void> {
  if (origin !== 'undo') { undoStack.push(next, origin, performance.now()); noteUndo(); }
  text.value = next;
  try {
    await guarded(async () => {
      const answer = await put<ModelAnswer>('model', { text: next, revision: revision.value, ...(name === undefined ? {} : { name }) });
      // What was typed since then is the newer text; its own request follows.
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

/** Sends the text that the program did not get while it could not be reached. */
export function sendAgain(): void { if (unsent.value) void putText(text.value, 'undo'); }

/** Sets keys in the YAML, unless another change came before: then the user is asked, and this gives false. Throws with the
 * program's reason where the keys cannot be set. `taken` is done together with the change, so that nothing is shown in between. */
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

/** `version`: that of the file which shall be replaced, when the user has seen it; else the one that was read. */
export async function save(name: string, version?: string): Promise<boolean> {
  try {
    const known = version ?? (name === fileName.value ? disk.value : undefined);
    const done = await guarded(async () => {
      const sent = text.value;
      const answer = await post<ModelAnswer>('model/save', { name, text: sent, revision: revision.value, ...(known === undefined ? {} : { disk: known }) });
      // What was typed since then is the newer text; its own request follows.
      take({ ...answer, text: text.value === sent ? answer.text : text.value });
    }, () => text.value);
    if (done) { overwrite.value = null; say(`Saved as ${fileName.value}`); }
    return done;
  } catch (error) { sayError(error); return false; }
}

/** Takes the text of the file in the place of the own one, which undo brings back. */
export async function takeFile(name: string): Promise<void> {
  try {
    const answer = await inTurn(() => post<ModelAnswer>('model/open', { name }));
    undoStack.push(answer.text, 'other', performance.now());
    takeOpened(answer, undoStack);
  } catch (error) { sayError(error); }
}

/** Text that is being typed and has not been sent yet. */
export const typing = signal(false);

/** The browser asks before the page is left with changes that the program has not taken yet. */
export function guardLeaving(): void {
  addEventListener('beforeunload', (e) => { if (typing.value || writing.value > 0 || unsent.value) e.preventDefault(); });
}

/** How often the newer text was chosen: a field then shows that, also where it is what the model had before. */
export const newerChosen = signal(0);

/** `unasked`: only where no change of this tab is under way, which would be lost. */
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
  // The event may overtake the answer to this tab's own change: look again when nothing is on its way.
  void queue.then(() => setTimeout(() => {
    if (writing.value > 0 || conflict.value || typing.value || event.revision <= revision.value) return;
    const before = text.value;
    void takeTheirs(true).then(() => { if (text.value !== before) say('Changed in another tab'); });
  }, 50));
}
