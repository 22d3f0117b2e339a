// Recovery from a state without a solution: the nearest value with a solution, between the last solved state and the present one.
import { computed, effect, signal, untracked } from '@preact/signals';
import { post } from '../api/client';
import type { StaticAnswer } from '../api/types';
import { liveChanges } from '../logic/live';
import { differing, nearestSolved, type Numbers } from '../logic/nearest';
import { findVariable, variableName, variableText } from '../logic/variables';
import { base, failure, solution, values, setLive } from './live';
import { errors, opened, revision, setKeys } from './model';
import { say, sayError } from './notices';

interface Solved { revision: number; values: Numbers; fields: Numbers }
const lastSolved = signal<Solved | null>(null);

const fieldNumbers = (): Numbers => Object.fromEntries([...base.value.fields.values()].filter((f) => f.given && typeof f.si === 'number').map((f) => [f.path, f.si!]));

interface Way { from: Numbers; to: Numbers; names: string[]; tried: boolean }

/** Values that differ from the solved state: trial values, otherwise those of the last changes of the model. */
const way = computed<Way | null>(() => {
  const solved = lastSolved.value;
  if (!failure.value || !solved || errors.value.length > 0) return null;
  if (solved.revision === revision.value) {
    const to = values.value, startValue = (id: string): number | undefined => solved.values[id] ?? findVariable(id, base.value)?.si;
    const from = Object.fromEntries(Object.keys(to).map((id) => [id, startValue(id)]));
    return Object.values(from).every((v) => v !== undefined) && Object.keys(to).length ? { from: from as Numbers, to, names: Object.keys(to), tried: true } : null;
  }
  const to = fieldNumbers(), names = differing(solved.fields, to);
  if (!names?.length || Object.keys(values.value).length) return null;
  const pick = (all: Numbers): Numbers => Object.fromEntries(names.map((name) => [name, all[name]!]));
  return { from: pick(solved.fields), to: pick(to), names, tried: false };
});

export const canFindNearest = computed(() => way.value !== null);
export const findingNearest = signal(false);

async function solves(state: Numbers): Promise<boolean> {
  const answer = await post<StaticAnswer | { status: 'overtaken' }>('static', { changes: liveChanges(base.value, state), full: false, lists: [], probe: true });
  return answer.status === 'converged';
}

/** Finds and applies it: to the sliders for trial values, otherwise to the model as one undo step. */
export async function takeNearest(): Promise<void> {
  const start = way.value, asked = revision.value;
  if (!start) return;
  findingNearest.value = true;
  try {
    const found = await nearestSolved(start.from, start.to, solves);
    if (asked !== revision.value) return;
    if (start.tried) for (const [id, si] of Object.entries(found)) setLive(id, si);
    else await setKeys(liveChanges(base.value, found));
    say(`Nearest solution: ${Object.entries(found).slice(0, 3).map(([id, si]) => {
      const variable = findVariable(id, base.value);
      return `${variableName(id, base.value.fields)} ${variable ? variableText(variable, si) : si}`;
    }).join(', ')}`);
  } catch (error) { sayError(error); } finally { findingNearest.value = false; }
}

export function startNearest(): void {
  effect(() => { void opened.value; lastSolved.value = null; });
  effect(() => {
    const s = solution.value;
    if (s) untracked(() => { if (!failure.value && s.revision === revision.value) lastSolved.value = { revision: s.revision, values: values.value, fields: fieldNumbers() }; });
  });
}
