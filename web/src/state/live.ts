// Live statics: values on top of the model that are tried out with sliders, and the solution that belongs to them.
import { computed, effect, signal, untracked } from '@preact/signals';
import { get, post } from '../api/client';
import type { Change, Converged, Scene, StaticAnswer } from '../api/types';
import { LatestGate } from '../logic/gate';
import { liveChanges, type LiveBase, type LiveValues, readBase } from '../logic/live';
import { errors, fields, hasModel, opened, revision, setKeys } from './model';
import { say, sayError } from './notices';

export const values = signal<LiveValues>({});
export const base = computed<LiveBase>(() => readBase(fields.value));
export const changes = computed<Change[]>(() => liveChanges(base.value, values.value));

export const solution = signal<Converged | null>(null);
/** Why there is no solution for the values shown; the last good one then stays in grey. */
export const failure = signal<{ what: string; where: string; why: string } | null>(null);
export const scene = signal<Scene | null>(null);
export const solving = signal(false);
/** From the moment of asking to the answer, in ms. */
export const roundTrip = signal(0);

interface Request { changes: Change[]; asked: number }

const gate = new LatestGate<Request, StaticAnswer>(
  ({ changes: list }) => { solving.value = true; return post<StaticAnswer>('static', { changes: list, full: false }); },
  (answer, { asked }) => {
    solving.value = false;
    roundTrip.value = performance.now() - asked;
    if (answer.status === 'converged') { failure.value = null; solution.value = answer; }
    else if (answer.status === 'failed') failure.value = answer;
    else {
      const first = answer.diagnostics.find((d) => d.severity === 'error') ?? answer.diagnostics[0];
      failure.value = { what: 'The model can not be computed like this', where: first?.key ?? '', why: first?.message ?? '' };
    }
  },
  (error) => { solving.value = false; sayError(error); },
);

export const solves = gate;

export function setLive(key: string, value: number | undefined): void {
  const next = { ...values.value };
  if (value === undefined) delete next[key]; else next[key] = value;
  values.value = next;
}

export function resetLive(): void { values.value = {}; }

export async function applyLive(): Promise<void> {
  const list = changes.value;
  if (list.length === 0) return;
  try {
    await setKeys(list);
    resetLive();
    say('Written into the model');
  } catch (error) { sayError(error); }
}

async function fetchScene(): Promise<void> {
  try {
    const answer = await get<Scene | { status: 'invalid' }>('scene');
    if (answer.status === 'ok') scene.value = answer;
  } catch (error) { sayError(error); }
}

export function startLive(): void {
  let seen = 0;
  effect(() => {
    // another model: the sliders start from it, and the old pipe must not be taken for its own
    if (opened.value !== seen) { seen = opened.value; values.value = {}; solution.value = null; failure.value = null; }
  });
  effect(() => {
    const ready = hasModel.value && errors.value.length === 0;
    void revision.value;
    const list = changes.value;
    if (ready) untracked(() => gate.submit({ changes: list, asked: performance.now() }));
    else untracked(() => { if (hasModel.value && errors.value[0]) failure.value = { what: 'The model has an error', where: `line ${errors.value[0].line}`, why: errors.value[0].message }; });
  });
  effect(() => {
    void revision.value;
    if (hasModel.value && errors.value.length === 0) untracked(() => void fetchScene());
  });
}
