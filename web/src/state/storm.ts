// The storm workspace: setting up and starting a storm, its expected time, and whether results are outdated.
import { computed, effect, signal, untracked } from '@preact/signals';
import { get, post } from '../api/client';
import type { Run, RunSummary, Study } from '../api/types';
import { isStudy } from '../logic/runs';
import { firstStorm, missingInStorm, modelSeeds, seconds, type Pace } from '../logic/storm';
import { byPath, hasModel, revision, setKeys } from './model';
import { sayError } from './notices';
import { runs, select, selected, startRun, type Order } from './runs';
import { workspace } from './workspace';

/** Target of Run: the storm of the model, or a comparison of variants of it. */
export type StormKind = 'storm' | 'tensioner' | 'contact' | 'impacts';
export const stormKinds: readonly [StormKind, string, string][] = [
  ['storm', 'run this storm', 'Run'],
  ['tensioner', 'compare tensioner modes', 'Compare tensioner modes'],
  ['contact', 'compare contact models', 'Compare contact models'],
  ['impacts', 'compare impacts resolved and captured', 'Compare impacts'],
];
export const stormKind = signal<StormKind>('storm');

export const missing = computed(() => (hasModel.value ? missingInStorm(byPath.value) : []));
export const seeds = computed(() => modelSeeds(byPath.value));
export const duration = computed(() => seconds(String(byPath.value.get('analysis.dynamic.duration')?.value ?? '')));

/** Writes the RAOs of the library hull for the vessel of the model and returns the name of the file. */
export async function scaleHull(): Promise<string> {
  const length = byPath.value.get('vessel.length')?.si, beam = byPath.value.get('vessel.beam')?.si;
  if (typeof length !== 'number' || typeof beam !== 'number') {
    throw new Error('Enter the length and the beam of the vessel first: the library hull is scaled to them.');
  }
  return (await post<{ name: string }>('hull', { length, beam })).name;
}

/** Adds all missing input, in one undo step. */
export async function setUpStorm(): Promise<void> {
  try {
    const hull = missing.value.includes('vessel motion') ? await scaleHull() : null;
    await setKeys(firstStorm(byPath.value, hull));
  } catch (error) { sayError(error); }
}

function order(): Order {
  if (stormKind.value !== 'storm') return { kind: 'comparison', of: stormKind.value };
  return seeds.value.length > 1 ? { kind: 'seeds', seeds: seeds.value } : { kind: 'dynamic' };
}

export const startStorm = (): Promise<void> => startRun(order());

/** Dynamic runs of this folder, newest first, each study as one. */
export const storms = computed(() => runs.value.filter((run) => !run.parent && (run.kind === 'dynamic' || isStudy(run))));
/** The study that the selected run is, or belongs to. */
export const stormStudy = computed<Run | null>(() => {
  const run = selected.value;
  if (!run) return null;
  if (isStudy(run)) return run;
  return run.parent ? runs.value.find((item) => item.id === run.parent) ?? null : null;
});
export const stormCases = computed<Run[]>(() => (stormStudy.value ? runs.value.filter((run) => run.parent === stormStudy.value!.id) : []));

/** Histories shown in the dock, in order; an empty name is filled with a default. */
export const stormHistories = signal<string[]>([]);

/** Results across the cases of that study. */
export const acrossCases = signal<Study | null>(null);

/** Speed of the last completed run; null if the folder has none. */
export const pace = signal<Pace | null>(null);
/** Runs whose speed is known. */
const paces = new Map<string, number>();

async function findPace(run: Run): Promise<void> {
  try {
    let ratio = paces.get(run.id);
    if (ratio === undefined) {
      const computed = (await get<RunSummary>(`runs/${run.id}/summary`)).dynamic;
      if (!computed || !(computed.wall_time > 0)) return;
      ratio = computed.wall_time / (computed.duration + computed.build_up);
      paces.set(run.id, ratio);
    }
    pace.value = { ratio, sideBySide: Math.max(1, (navigator.hardwareConcurrency || 2) - 1) };
  } catch { /* a run with deleted files has no known speed */ }
}

/** Reference run for the speed: with the same title, otherwise the newest. */
function paceRun(): Run | null {
  const done = runs.value.filter((run) => run.kind === 'dynamic' && run.state === 'done' && run.has_results);
  const titles = new Map(runs.value.map((run) => [run.id, run.title]));
  const ownTitle = String(byPath.value.get('title')?.value ?? '');
  return done.find((run) => titles.get(run.parent || run.id) === ownTitle) ?? done[0] ?? null;
}

/** Keys in which the open model differs from that of the selected run; empty if there is none. */
export const staleKeys = signal('');
let staleCount = 0;

async function findStale(id: string): Promise<void> {
  const mine = ++staleCount;
  try {
    const { changed } = await get<{ changed: string }>(`runs/${id}/changes`);
    if (mine === staleCount) staleKeys.value = changed;
  } catch { if (mine === staleCount) staleKeys.value = ''; }
}

let studyCount = 0;

async function loadAcross(study: Run): Promise<void> {
  const mine = ++studyCount;
  if (study.state !== 'done') return; // its table is written at the end
  try {
    const answer = await get<Study>(`runs/${study.id}/study`);
    if (mine === studyCount) acrossCases.value = answer;
  } catch (error) { if (mine === studyCount) sayError(error); }
}

export function startStorms(): void {
  let paceKey = '', staleKey = '', acrossKey = '', timer = 0;
  effect(() => {
    const run = workspace.value === 'storm' ? paceRun() : null;
    untracked(() => { if (run && run.id !== paceKey) { paceKey = run.id; void findPace(run); } });
  });
  effect(() => {
    const id = selected.value?.id ?? '', key = `${id} ${revision.value}`;
    untracked(() => {
      if (key === staleKey) return;
      if (!staleKey.startsWith(`${id} `)) staleKeys.value = '';
      staleKey = key;
      clearTimeout(timer);
      if (id) timer = window.setTimeout(() => void findStale(id), 200);
      else { ++staleCount; staleKeys.value = ''; }
    });
  });
  effect(() => {
    const study = stormStudy.value, key = study?.has_results ? `${study.id} ${study.state}` : '';
    untracked(() => {
      if (key === acrossKey) return;
      acrossKey = key;
      ++studyCount;
      acrossCases.value = null;
      if (key) void loadAcross(study!);
    });
  });
  // A study is shown case by case: first the first one with results.
  effect(() => {
    const run = selected.value;
    if (workspace.value !== 'storm' || !run || !isStudy(run)) return;
    const first = stormCases.value.find((item) => item.has_results);
    if (first) untracked(() => select(first.id));
  });
}
