// The operation on the line: its table of stages, and the stage whose line picture and diagrams show.
import { batch, computed, effect, signal, untracked } from '@preact/signals';
import { get, post } from '../api/client';
import type { Diagnostic, Lay, Operation, OperationStage } from '../api/types';
import { values } from './live';
import { byPath, opened, revision } from './model';
import { say, sayError } from './notices';
import { selectedId } from './runs';

interface Solved extends Operation { status: 'solved'; revision: number }
type Answer = Solved | { status: 'overtaken' } | { status: 'invalid'; diagnostics: Diagnostic[] };
export interface StageEvent { done: number; of: number; name: string; stands: boolean }

/** Types of operation on the line; others are of vessel and moorings. */
const ofLine = ['abandonment', 'recovery', 'lay_down', 'start_up', 'move', 'passage', 'ballast', 'shore_pull', 'hold_back', 'lift'];
export const hasOperation = computed(() => ofLine.includes(String(byPath.value.get('operation.type')?.value ?? '')));

export const operation = signal<Solved | null>(null);
/** While stages are being solved: the last that is done. */
export const progress = signal<StageEvent | null>(null);
export const solving = signal(false);
/** The model has changed since the stages were solved. */
export const outdated = computed(() => operation.value !== null && operation.value.revision !== revision.value);

/** Number of the stage from 0; -1 none: the lay as the model describes it. */
export const chosenStage = signal(-1);
export const stageLay = signal<Lay | null>(null);
export const shownStage = computed<OperationStage | null>(() => (stageLay.value ? operation.value?.stages[chosenStage.value] ?? null : null));
export const playing = signal(false);

/** Lines of stages that have been asked for. */
let known = new Map<number, Lay>();
let askedFor = 0;

export async function solveOperation(): Promise<void> {
  solving.value = true;
  progress.value = null;
  try {
    const model = opened.value;
    const answer = await post<Answer>('operation');
    if (answer.status === 'overtaken' || model !== opened.value) return;
    if (answer.status === 'invalid') { say(answer.diagnostics.find((d) => d.severity === 'error')?.message ?? 'The model has errors'); return; }
    known = new Map();
    batch(() => { operation.value = answer; solving.value = false; progress.value = null; });
    const first = answer.stages.findIndex((s) => s.values !== null);
    await chooseStage(answer.stages[chosenStage.value]?.values ? chosenStage.value : first);
  } catch (error) { sayError(error); } finally { solving.value = false; progress.value = null; }
}

export async function chooseStage(i: number): Promise<void> {
  const stage = operation.value?.stages[i];
  const mine = ++askedFor;
  if (!stage) { batch(() => { chosenStage.value = -1; stageLay.value = null; playing.value = false; }); return; }
  if (!stage.values) return;
  try {
    const of = known;
    const lay = of.get(i) ?? await get<Lay>(`operation/stages/${i}`);
    of.set(i, lay);
    if (mine === askedFor && of === known) batch(() => { chosenStage.value = i; stageLay.value = lay; });
  } catch (error) { sayError(error); }
}

/** The next stage that stands, the first again after the last; the same one where there is no other. */
export function nextStage(from: number, step: 1 | -1): number {
  const stages = operation.value?.stages ?? [];
  for (let k = 1; k <= stages.length; ++k) {
    const i = (from + step * k + stages.length * k) % stages.length;
    if (stages[i]?.values) return i;
  }
  return from;
}

export function stageEvent(event: StageEvent): void { if (solving.value) progress.value = event; }

export function startOperation(): void {
  // another model, or none of its stages left
  effect(() => { void opened.value; void hasOperation.value; untracked(() => { operation.value = null; known = new Map(); void chooseStage(-1); }); });
  // what changes the model, tries values out or shows a run goes back to the lay
  effect(() => { void revision.value; void selectedId.value; void values.value; untracked(() => { if (chosenStage.value >= 0) void chooseStage(-1); }); });
  effect(() => {
    if (!playing.value) return undefined;
    const timer = setInterval(() => void chooseStage(nextStage(chosenStage.peek(), 1)), 700);
    return () => clearInterval(timer);
  });
}
