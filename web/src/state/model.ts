// The open model: text, fields and faults, and everything that changes them. The program holds the truth; the page
// sends each change with the revision it knows, so that two tabs can not overwrite each other unseen.
import { computed, signal } from '@preact/signals';
import { ApiError, get, post, put } from '../api/client';
import type { Change, Diagnostic, Field, Info, ModelAnswer } from '../api/types';
import { UndoStack } from '../logic/undo';
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
/** Counts models that were opened anew, for whatever has to start afresh then (camera, sliders). */
export const opened = signal(0);

export const errors = computed(() => diagnostics.value.filter((d) => d.severity === 'error'));
export const byPath = computed(() => new Map(fields.value.map((f) => [f.path, f])));
export const title = computed(() => String(byPath.value.get('title')?.value ?? '') || fileName.value || 'New model');

let undoStack = new UndoStack('');
export const canUndo = signal(false);
export const canRedo = signal(false);

function noteUndo(): void {
  canUndo.value = undoStack.canUndo;
  canRedo.value = undoStack.canRedo;
}

// Requests that change the model go one after another: each needs the revision that the one before it made.
let queue: Promise<unknown> = Promise.resolve();
export const writing = signal(0);

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
  if (answer.diagnostics) diagnostics.value = answer.diagnostics;
  if (answer.fields) fields.value = answer.fields;
  if (answer.revision !== undefined) revision.value = answer.revision;
}

function takeOpened(answer: ModelAnswer): void {
  take(answer);
  conflict.value = null;
  hasModel.value = answer.text.trim() !== '';
  undoStack = new UndoStack(answer.text);
  noteUndo();
  ++opened.value;
}

export async function start(): Promise<void> {
  try {
    info.value = await get<Info>('info');
    if (info.value.has_model) takeOpened(await get<ModelAnswer>('model'));
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
    if (error instanceof ApiError && error.status === 409) {
      conflict.value = { mine: mine(), changes };
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
  } catch (error) { sayError(error); }
}

/** Sets keys in the YAML; throws with the program's reason where that can not be done. */
export async function setKeys(changes: Change[]): Promise<void> {
  await guarded(async () => {
    const answer = await post<ModelAnswer>('model/set', { changes, revision: revision.value });
    take(answer);
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
  ++opened.value;
}

export async function openFile(name: string): Promise<void> {
  try { takeOpened(await inTurn(() => post<ModelAnswer>('model/open', { name }))); } catch (error) { sayError(error); }
}

export async function openExample(name: string): Promise<void> {
  try { await openNew((await get<{ text: string }>(`examples/${encodeURIComponent(name)}`)).text); } catch (error) { sayError(error); }
}

export async function save(name: string): Promise<boolean> {
  try {
    const done = await guarded(async () => take(await post<ModelAnswer>('model/save', { name, text: text.value, revision: revision.value })), () => text.value);
    if (done) say(`Saved as ${fileName.value}`);
    return done;
  } catch (error) { sayError(error); return false; }
}

export async function takeTheirs(): Promise<void> {
  try {
    const theirs = await get<ModelAnswer>('model');
    take(theirs);
    undoStack.push(theirs.text, 'other', performance.now());
    noteUndo();
    conflict.value = null;
    newer.value = false;
  } catch (error) { sayError(error); }
}

export async function keepMine(): Promise<void> {
  const c = conflict.value;
  if (!c) return;
  conflict.value = null;
  newer.value = false;
  try {
    revision.value = (await get<ModelAnswer>('model')).revision;
    await putText(c.mine, 'other');
    if (c.changes.length) await setKeys(c.changes);
  } catch (error) { sayError(error); }
}

/** Another tab has changed the model: set by the event, and offered in the header. */
export const newer = signal(false);

export function modelEvent(event: { revision: number }): void {
  // The event may overtake the answer to this tab's own change: look again when nothing is on its way.
  void queue.then(() => setTimeout(() => {
    if (writing.value === 0 && event.revision > revision.value) newer.value = true;
  }, 50));
}
