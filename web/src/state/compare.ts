// Compared runs and their data.
import { computed, effect, signal, untracked } from '@preact/signals';
import { get } from '../api/client';
import type { Column, Envelopes, Field } from '../api/types';
import type { ComparedSummary } from '../logic/runCompare';
import { maxCompared } from '../logic/runCompare';
import { ApiError } from '../api/client';
import { sayError } from './notices';
import { runs } from './runs';

/** Ids in the order of selection: the first is the reference. */
export const checked = signal<string[]>([]);
export const compared = computed(() => checked.value.slice(0, maxCompared).map((id) => runs.value.find((run) => run.id === id)).filter((run) => run !== undefined));

export function check(id: string, on: boolean): void { checked.value = on ? [...checked.value.filter((c) => c !== id), id] : checked.value.filter((c) => c !== id); }

/** Data of a run for a comparison; null if it has none. */
export interface RunParts { fields: Field[] | null; text: string; summary: ComparedSummary | null; envelopes: Envelopes | null; columns: Column[] }
export const runParts = signal<ReadonlyMap<string, RunParts>>(new Map());

const missing = <T,>(value: T) => (error: unknown): T => { if (error instanceof ApiError && error.status === 404) return value; throw error; };

async function load(id: string): Promise<void> {
  const run = runs.value.find((r) => r.id === id);
  if (!run) return;
  const base = `runs/${id}`, single = run.kind === 'static' || run.kind === 'dynamic';
  try {
    const [model, summary, envelopes, columns] = await Promise.all([
      get<{ text: string; fields: Field[] }>(`${base}/model`).catch(missing({ text: '', fields: null })),
      single && run.has_results ? get<ComparedSummary>(`${base}/summary`).catch(missing(null)) : null,
      single && run.has_results ? get<Envelopes>(`${base}/envelopes`).catch(missing(null)) : null,
      run.kind === 'dynamic' && run.has_results ? get<Column[]>(`${base}/columns`).catch(missing([])) : [],
    ]);
    runParts.value = new Map([...runParts.value, [id, { fields: model.fields, text: model.text, summary, envelopes, columns }]]);
  } catch (error) { sayError(error); }
}

const asked = new Map<string, string>();

/** Loads the compared runs; reloads a run when it has ended. */
export function startCompare(): void {
  effect(() => {
    for (const run of compared.value) {
      const state = `${run.state} ${run.has_results}`;
      if (asked.get(run.id) === state || run.state === 'running') continue;
      asked.set(run.id, state);
      untracked(() => void load(run.id));
    }
  });
  effect(() => {
    const known = new Set(runs.value.map((run) => run.id));
    untracked(() => {
      if (checked.value.some((id) => !known.has(id))) checked.value = checked.value.filter((id) => known.has(id));
    });
  });
}
