// Of each pinned key the range in which every check passes, found in the background while nothing else is to do. One
// request at a time; any change ends the search, and what no longer belongs to the state shown is dropped.
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

/** Rest before a search begins [ms]. */
const idle = 700;

interface Found { state: string; intervals: PassInterval[] | null }
const found = signal<Record<string, Found>>({});

interface Context { own: Set<string>; rest: string }

/** By slider: the keys that it sets, and all the others of the model. */
const contexts = computed<Map<string, Context>>(() => new Map(sliders.value.map(({ variable, low, high }) => {
  const trial = variable.si + Math.max(0.01 * Math.abs(variable.si), 0.1 * variable.scale);
  const own = new Set(liveChanges(base.value, { [variable.id]: trial }).map((change) => change.path));
  const rest = [...base.value.fields.values()].filter((field) => field.given && field.value != null && !own.has(field.path));
  return [variable.id, { own, rest: JSON.stringify([low, high, rest.map((field) => [field.path, field.value])]) }];
})));

/** Everything that a slider's range depends on: the model with what is tried out, but for the slider's own keys. */
function stateAround(id: string): string {
  const context = contexts.value.get(id);
  return context ? context.rest + JSON.stringify(changes.value.filter((change) => !context.own.has(change.path))) : '';
}

/** The range of a pinned key; undefined while it is not known, null where no check judges the model. */
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
  const own = values.value[variable.id] ?? variable.si;
  const inside = (si: number): number => onStep(variable, si, variableStep(variable) / 10);
  const intervals = await findPassIntervals((si) => judge(slider, inside(si), stop), low, high, own);
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
    // an error ends the search as well: what the program has to say, the live statics say
    const timer = setTimeout(() => untracked(() => { work().catch(() => undefined); }), idle);
    return () => { stopped = true; clearTimeout(timer); };
  });
}
