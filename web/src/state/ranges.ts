// Passing range of each pinned key, found in the background when the program is idle. One
// request at a time; any change ends the search, and outdated results are dropped.
import { computed, effect, signal, untracked } from '@preact/signals';
import { post } from '../api/client';
import type { StaticAnswer } from '../api/types';
import { findPassIntervals, judgement, type Judgement, type PassInterval } from '../logic/passRange';
import { liveChanges } from '../logic/live';
import { onStep, variableStep } from '../logic/variables';
import { base, changes, dragging, failure, solution, values } from './live';
import { errors, hasModel, revision } from './model';
import { sliders, type Slider } from './pins';
import { workspace } from './workspace';

/** Delay before a search begins [ms]. */
const idle = 700;

interface Found { state: string; intervals: PassInterval[] | null }
const found = signal<Record<string, Found>>({});

interface Context { keys: Set<string>; rest: string }

/** For each slider: its keys, and all other values of the model. */
const contexts = computed<Map<string, Context>>(() => new Map(sliders.value.map(({ variable, low, high }) => {
  const trial = variable.si + Math.max(0.01 * Math.abs(variable.si), 0.1 * variable.scale);
  const keys = new Set(liveChanges(base.value, { [variable.id]: trial }).map((change) => change.path));
  const rest = [...base.value.fields.values()].filter((field) => field.given && field.value != null && !keys.has(field.path));
  return [variable.id, { keys, rest: JSON.stringify([low, high, rest.map((field) => [field.path, field.value])]) }];
})));

/** All inputs of a slider's range: the model with trial values, except the keys of the slider. */
function stateAround(id: string): string {
  const context = contexts.value.get(id);
  return context ? context.rest + JSON.stringify(changes.value.filter((change) => !context.keys.has(change.path))) : '';
}

/** Range of a pinned key; undefined while unknown, null if the model has no check. */
export function passRange(id: string): PassInterval[] | null | undefined {
  const entry = found.value[id];
  return entry && entry.state === stateAround(id) ? entry.intervals : undefined;
}

class Overtaken extends Error {}

async function judge(slider: Slider, si: number, stop: () => boolean): Promise<Judgement> {
  if (stop()) throw new Overtaken();
  const list = liveChanges(base.value, { ...values.value, [slider.variable.id]: si });
  const answer = await post<StaticAnswer | { status: 'overtaken' }>('static', { changes: list, full: false, lists: [], probe: true });
  if (stop() || answer.status === 'overtaken') throw new Overtaken();
  return answer.status === 'converged' ? judgement(answer.verdict.kind) : 'failed';
}

async function search(slider: Slider, state: string, stop: () => boolean): Promise<void> {
  const { variable, low, high } = slider;
  const start = values.value[variable.id] ?? variable.si;
  const inside = (si: number): number => onStep(variable, si, variableStep(variable) / 10);
  const intervals = await findPassIntervals((si) => judge(slider, inside(si), stop), low, high, start);
  found.value = { ...found.value, [variable.id]: { state, intervals } };
}

export function startRanges(): void {
  effect(() => {
    const ready = hasModel.value && errors.value.length === 0 && !dragging.value && solution.value !== null && failure.value === null && workspace.value === 'lay';
    void revision.value;
    void changes.value;
    const wanted = sliders.value;
    let stopped = false;
    if (!ready) return () => { stopped = true; };
    const work = async (): Promise<void> => {
      for (const slider of wanted) {
        const state = stateAround(slider.variable.id);
        if (!slider.variable.integer && found.value[slider.variable.id]?.state !== state) await search(slider, state, () => stopped || document.hidden);
      }
    };
    // an error ends the search as well: the live statics report it
    const timer = setTimeout(() => untracked(() => { work().catch(() => undefined); }), idle);
    return () => { stopped = true; clearTimeout(timer); };
  });
}
