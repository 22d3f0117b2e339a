// Live statics: trial values on top of the model, and their solution.
import { batch, computed, effect, signal, untracked } from '@preact/signals';
import { get } from '../api/client';
import { Solver } from '../api/solver';
import type { Change, Converged, Scene, StaticAnswer } from '../api/types';
import { liveChanges, type LiveBase, type LiveValues, readBase } from '../logic/live';
import { liveScene } from '../logic/liveScene';
import { convertLike } from '../logic/units';
import { colourBy, slots } from './look';
import { byPath, errors, fields, hasModel, opened, revision, setKeys } from './model';
import { say, sayError } from './notices';

const depthKey = 'environment.water_depth', trimKey = 'vessel.trim';
export const values = signal<LiveValues>({});
export const base = computed<LiveBase>(() => readBase(fields.value));
export const changes = computed<Change[]>(() => liveChanges(base.value, values.value));

export const solution = signal<Converged | null>(null);
/** Reason for the missing solution at the values shown; the last solution is then shown in grey. */
export const failure = signal<{ what: string; where: string; why: string } | null>(null);
/** The solution for panels and diagrams: the latest, but during a drag at most every `calmTime` ms. */
export const calm = signal<Converged | null>(null);
const calmTime = 100;
/** A value is being dragged: slow or hidden updates can wait. */
export const dragging = signal(false);
const standing = signal<Scene | null>(null);
/** The fixed scene, with the trial values. */
export const scene = computed<Scene | null>(() => (standing.value ? liveScene(standing.value, values.value[depthKey], values.value[trimKey], base.value.fields.get(trimKey)?.si ?? 0) : null));
/** The solution takes noticeably long. */
export const solvingNow = signal(false);
/** From the request to the answer, in ms. */
export const roundTrip = signal(0);

interface Request { asked: number; revision: number; body: { changes: Change[]; full: boolean; lists?: string[] } }

/** Visible lists along the pipe: others are not sent during a drag. */
const looked = (): string[] => [...new Set([colourBy.value, ...slots.value])].filter((name) => /^(effective_tension|bending_moment|bending_stress|von_mises|strain|utilisation|checks)$/.test(name));

/** Revision at which the open model was opened. */
let openedAt = 0;

let slowTimer = 0;
/** A longer solution time is shown as pending [ms]. */
const slow = 150;

const gate = new Solver<Request>(
  (answer: StaticAnswer, request) => batch(() => {
    if (request.revision < openedAt) return; // of the previously open model
    roundTrip.value = performance.now() - request.asked;
    clearTimeout(slowTimer);
    solvingNow.value = false;
    ++solved.count;
    if (answer.status === 'converged') { failure.value = null; solution.value = answer; }
    else if (answer.status === 'failed') failure.value = answer;
    else {
      const first = answer.diagnostics.find((d) => d.severity === 'error') ?? answer.diagnostics[0];
      failure.value = { what: 'The model cannot be solved', where: first?.key ?? '', why: first?.message ?? '' };
    }
  }),
  sayError,
);

function submit(request: Request): void {
  clearTimeout(slowTimer);
  slowTimer = window.setTimeout(() => { solvingNow.value = true; }, slow);
  gate.submit(request);
}

/** Number of answers since the start, for measurements. */
export const solved = { count: 0 };
(globalThis as unknown as { __solved: typeof solved }).__solved = solved;

let restTimer = 0;

/** A drag ends when the value has been constant for a while: then all data are requested once more. */
function stir(): void {
  dragging.value = true;
  clearTimeout(restTimer);
  const rest = (): void => {
    if (gate.inFlight) { restTimer = window.setTimeout(rest, 30); return; }
    dragging.value = false;
  };
  restTimer = window.setTimeout(rest, 250);
}

/** Sets a trial SI value of a key, or of a variable that sets several; undefined resets it to the model. */
export function setLive(id: string, si: number | undefined): void {
  stir();
  const next = { ...values.value };
  if (si === undefined) delete next[id]; else next[id] = si;
  values.value = next;
}

export function resetLive(): void { values.value = {}; }

/** Writes the trial values into the model, in one step: all, or one value only. */
export async function applyLive(id?: string): Promise<void> {
  const wanted = values.value;
  const part: LiveValues = id === undefined ? wanted : id in wanted ? { [id]: wanted[id]! } : {};
  const written = (path: string): string => String(byPath.value.get(path)?.value ?? '');
  const list = liveChanges(base.value, part).map((c) => (typeof c.value === 'string' ? { ...c, value: convertLike(c.value, written(c.path)) } : c));
  if (list.length === 0) return;
  try {
    // values varied further meanwhile remain trial values
    const rest = (): void => { values.value = Object.fromEntries(Object.entries(values.value).filter(([key, si]) => part[key] !== si)); };
    if (!await setKeys(list, rest)) return;
    if (id === undefined) say('Written into the model');
  } catch (error) { sayError(error); }
}

let sceneCount = 0;

async function fetchScene(): Promise<void> {
  const mine = ++sceneCount, asked = revision.value;
  try {
    const answer = await get<Scene | { status: 'invalid' }>('scene');
    // an overtaken answer is older than the solution shown
    if (answer.status === 'ok' && mine === sceneCount && asked >= openedAt) standing.value = answer;
  } catch (error) { sayError(error); }
}

export function startLive(): void {
  let seen = 0;
  let last: Change[] | null = null;
  effect(() => {
    // another model: the sliders are reset, and the previous pipe must not be mistaken for its own
    if (opened.value !== seen) { seen = opened.value; openedAt = revision.peek(); values.value = {}; solution.value = null; calm.value = null; failure.value = null; standing.value = null; }
  });
  let timer = 0;
  effect(() => {
    const s = solution.value;
    if (s === null || !dragging.value) { clearTimeout(timer); timer = 0; calm.value = s; return; }
    timer ||= window.setTimeout(() => { timer = 0; calm.value = solution.peek(); }, calmTime);
  });
  effect(() => {
    const ready = hasModel.value && errors.value.length === 0;
    void revision.value;
    const list = changes.value, lean = dragging.value;
    if (ready) untracked(() => { if (!lean || list !== last) submit({ asked: performance.now(), revision: revision.value, body: { changes: list, full: false, ...(lean ? { lists: looked() } : {}) } }); last = list; });
    else untracked(() => { if (hasModel.value && errors.value[0]) failure.value = { what: 'The model has an error', where: errors.value[0].key || `line ${errors.value[0].line}`, why: errors.value[0].message }; });
  });
  effect(() => {
    void revision.value;
    if (hasModel.value && errors.value.length === 0) untracked(() => void fetchScene());
  });
}
