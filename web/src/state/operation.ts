// The operation on the line: its table of stages, and the stage shown in picture and diagrams.
import { batch, computed, effect, signal, untracked } from '@preact/signals';
import { get, post } from '../api/client';
import type { Diagnostic, Lay, Operation, OperationStage } from '../api/types';
import { bedHeight } from '../logic/bed';
import { firstOperation, needsLay, type FirstOperation, type LaySize, type OperationParts } from '../logic/firstOperation';
import { designChanges, listChanges, operationTypes, shortenedEnd } from '../logic/operationKeys';
import { write } from '../logic/units';
import { calm, changes, failure, scene, values } from './live';
import { byPath, errors, opened, revision, setKeys } from './model';
import { say, sayError } from './notices';
import { selectedId } from './runs';

interface Solved extends Operation { status: 'solved'; revision: number }
type Answer = Solved | { status: 'overtaken' } | { status: 'invalid'; diagnostics: Diagnostic[] };
export interface StageEvent { done: number; of: number; name: string; stands: boolean }

export const typeName = computed(() => String(byPath.value.get('operation.type')?.value ?? ''));
/** An operation on the line, as opposed to one of vessel and moorings. */
export const hasOperation = computed(() => operationTypes.some((type) => type.id === typeName.value));

export const operation = signal<Solved | null>(null);
/** The last solved stage, while stages are being solved. */
export const progress = signal<StageEvent | null>(null);
export const solving = signal(false);
/** The model has changed since the stages were solved. */
export const outdated = computed(() => operation.value !== null && operation.value.revision !== revision.value);

/** The solved stages in the order of the model's list: a recovery is solved in reverse. */
export const listedStages = computed<OperationStage[]>(() => { const stages = operation.value?.stages ?? []; return typeName.value === 'recovery' ? [...stages].reverse() : stages; });

/** Index of the stage from 0; -1: the lay of the model. */
export const chosenStage = signal(-1);
export const stageLay = signal<Lay | null>(null);
export const shownStage = computed<OperationStage | null>(() => (stageLay.value ? operation.value?.stages[chosenStage.value] ?? null : null));
export const playing = signal(false);

/** Requested lines of stages. */
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

/** Null if the lay of the model as written has no solution: an operation cannot be sized then. */
function laySize(): LaySize | null {
  const lay = calm.value, around = scene.value, { key, touchdown, pipe } = lay ?? {};
  if (!lay || !around || !key || !touchdown || !pipe?.s.length || failure.value || changes.value.length || lay.revision !== revision.value) return null;
  const [x, y] = [pipe.x[0]!, pipe.y[0]!], reach = Math.hypot(touchdown.place[0] - x, touchdown.place[1] - y) || 1;
  const [ax, ay] = [(touchdown.place[0] - x) / reach, (touchdown.place[1] - y) / reach];
  const boxes = lay.supports.filter((b) => b.structure === 'stinger');
  return {
    joint: byPath.value.get('pipe.joint.length')?.si ?? 12, touchdown: touchdown.s, tip: boxes.length ? Math.max(...boxes.map((b) => b.s)) : 0.1 * touchdown.s,
    tension: key.top_tension, bottomTension: key.bottom_tension, height: pipe.z[0]!,
    depthAt: (distance) => -bedHeight(around.seabed, x + ax * distance, y + ay * distance),
  };
}

/** Name of an item, or the default name: "tank 1". */
function firstName(list: RegExp, unnamed: string): string {
  const item = [...byPath.value.values()].find((f) => f.given && list.test(f.path));
  if (!item) return '';
  const path = list.exec(item.path)![0];
  return String(byPath.value.get(`${path}.name`)?.value ?? '') || unnamed;
}

/** Structures, tanks and davits of the model for operations. */
export const operationParts = computed<OperationParts>(() => {
  const text = (path: string): string => String(byPath.value.get(path)?.value ?? '');
  const davits: OperationParts['davits'] = [];
  for (let i = 0; byPath.value.has(`lines[${i}]`); ++i) {
    const held = [0, 1].some((end) => byPath.value.get(`lines[${i}].ends[${end}].line`)?.given), length = byPath.value.get(`lines[${i}].length`)?.si;
    if (held && text(`lines[${i}].name`) && length) davits.push({ name: text(`lines[${i}].name`), length });
  }
  return { structure: firstName(/^pipe\.structures\[0\]/, 'structure 1'), tank: firstName(/^supports\.stinger\.(?:sections\[\d+\]\.)?tanks\[0\]/, 'tank 1'), davits };
});

/** Writes an operation of this type with default values into the model, replacing any other. */
export async function addOperation(type: FirstOperation): Promise<void> {
  const lay = laySize();
  if (!lay && needsLay(type)) {
    say('No operation was added: its values depend on the lay of the model, which has no solution yet. Wait for the solution, correct the model, or apply or reset the slider values.');
    return;
  }
  const clear = byPath.value.get('operation')?.given ? [{ path: 'operation', value: null }] : [];
  try { await setKeys([...clear, ...firstOperation(type, lay, operationParts.value)]); } catch (error) { sayError(error); }
}

/** Number of times that a procedure is shortened, with finer steps each time. */
const maxShortenings = 3;

/** Seeks tensions within the limits, and solves all stages. At lower tension less cable is needed to reach the seabed: stages
 * that would only pay out cable onto the seabed are left out. */
export async function designProcedure(): Promise<void> {
  const next = designChanges(byPath.value);
  if (next.length === 0) return;
  try {
    if (!await setKeys(next) || errors.value.length > 0) return;
    await solveOperation();
    for (let i = 0; i < maxShortenings && operation.value && !outdated.value; ++i) {
      const end = shortenedEnd(typeName.value, operation.value.stages);
      if (end === null || !await setKeys([{ path: 'operation.stages.to', value: write(end, 'm') }])) return;
      await solveOperation();
    }
  } catch (error) { sayError(error); }
}

/** The solved stages as a list in the model, to be edited individually. */
export async function listStages(): Promise<void> {
  if (!operation.value || outdated.value) return;
  try { if (await setKeys(listChanges(typeName.value, operation.value.stages))) await solveOperation(); } catch (error) { sayError(error); }
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

/** The next stage with a solution, cyclically; the same one if there is no other. */
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
  // another model, or it has no stages left
  effect(() => { void opened.value; void hasOperation.value; untracked(() => { operation.value = null; known = new Map(); void chooseStage(-1); }); });
  // changes of the model, trial values or a run return to the lay
  effect(() => { void revision.value; void selectedId.value; void values.value; untracked(() => { if (chosenStage.value >= 0) void chooseStage(-1); }); });
  effect(() => {
    if (!playing.value) return undefined;
    const timer = setInterval(() => void chooseStage(nextStage(chosenStage.peek(), 1)), 700);
    return () => clearInterval(timer);
  });
}
