// Runs: the list, the selected run, and its data for diagrams and animation.
import { batch, computed, effect, signal, untracked } from '@preact/signals';
import { finishReads, get, post } from '../api/client';
import type { Check, Column, Envelopes, Impact, Lay, Run, RunSummary, Scene, Study } from '../api/types';
import { isStudy, listedNames, newerList } from '../logic/runs';
import { opened } from './model';
import { say, sayError } from './notices';
import { workspace } from './workspace';

export const runs = signal<Run[]>([]);
export const selectedId = signal<string | null>(null);
export const selected = computed(() => runs.value.find((r) => r.id === selectedId.value) ?? null);
export const envelopes = signal<Envelopes | null>(null);
export const columns = signal<Column[]>([]);
export const impacts = signal<Impact[]>([]);
/** Data of the selected run, null until available: its static state, fixed scene, summary. */
export const runLay = signal<Lay | null>(null);
export const runScene = signal<Scene | null>(null);
export const runSummary = signal<RunSummary | null>(null);
/** Results of the cases of a study. */
export const study = signal<Study | null>(null);
/** Code checks of the run. */
export const runChecks = computed<Check[] | null>(() => { const s = runSummary.value; return (s?.dynamic ?? s)?.checks?.list ?? null; });
/** Runs that have ended since the list was last viewed. */
export const newRuns = signal<readonly string[]>([]);
/** Time at which a run was first seen running, to estimate its end. */
const begun = new Map<string, { time: number; progress: number }>();

export async function fetchRuns(): Promise<void> {
  try { const list = await get<Run[]>('runs'); runs.value = newerList(runs.value, list); } catch (error) { sayError(error); }
}

export interface Order { kind: Run['kind']; duration?: number; seeds?: number[]; of?: string; stage?: string }

export async function startRun(order: Order): Promise<void> {
  try {
    const { id } = await post<{ id: string }>('runs', order);
    await fetchRuns();
    select(id);
  } catch (error) { sayError(error); }
}

const names = computed(() => listedNames(runs.value));
export const runName = (run: Run): string => names.value.get(run.id) ?? (run.name || run.title || run.id);

let annotated: Promise<boolean> = Promise.resolve(true);

/** Sequential, so that earlier texts do not arrive after later ones. Returns true if they were accepted. */
export function annotate(id: string, texts: { name?: string; note?: string }): Promise<boolean> {
  annotated = annotated.then(async () => {
    try { await post(`runs/${id}/annotate`, texts); } catch (error) { sayError(error); return false; }
    await fetchRuns();
    return true;
  });
  return annotated;
}

export async function deleteRuns(ids: readonly string[]): Promise<void> {
  if (selected.value && ids.some((id) => id === selected.value?.id || id === selected.value?.parent)) select(null);
  await finishReads(); // of the deleted run
  for (const id of ids) {
    try { await post(`runs/${id}/delete`); forget(id); } catch (error) { sayError(error); return; }
  }
}

function forget(id: string): void {
  const gone = (r: Run): boolean => r.id === id || r.parent === id;
  if (selected.value && gone(selected.value)) select(null);
  runs.value = runs.value.filter((r) => !gone(r));
  newRuns.value = newRuns.value.filter((known) => known !== id);
}

/** The new state comes as an event; that of the answer could be older than a later event. */
export async function resumeRun(id: string): Promise<void> {
  try { await post(`runs/${id}/resume`); } catch (error) { sayError(error); }
}

export async function cancelRun(id: string): Promise<void> {
  try { await post(`runs/${id}/cancel`); await fetchRuns(); } catch (error) { sayError(error); }
}

let loadCount = 0;

function clear(): void {
  envelopes.value = null;
  columns.value = [];
  impacts.value = [];
  runLay.value = null;
  runScene.value = null;
  runSummary.value = null;
  study.value = null;
}

export function select(id: string | null): void {
  batch(() => { selectedId.value = id; clear(); });
  if (id) void load(id);
}

/** Another model is opened: the page shows it. */
export function startRuns(): void {
  effect(() => { void opened.value; untracked(() => { if (selectedId.value) select(null); }); });
  effect(() => { if (workspace.value === 'runs' && newRuns.value.length) newRuns.value = []; });
}

async function load(id: string): Promise<void> {
  const mine = ++loadCount;
  const run = runs.value.find((r) => r.id === id);
  if (!run) return;
  const current = (): boolean => mine === loadCount && selectedId.value === id;
  try {
    if (run.kind === 'dynamic' && (run.has_results || (run.state === 'running' && run.time !== undefined))) {
      const list = await get<Column[]>(`runs/${id}/columns`);
      if (!current()) return; // no more is read of a run that is no longer shown
      columns.value = list;
    }
    if (!run.has_results) return;
    if (run.kind === 'study') return;
    if (isStudy(run)) {
      if (run.state !== 'done') return; // its table is written at the end
      const gathered = await get<Study>(`runs/${id}/study`);
      if (current()) study.value = gathered;
      return;
    }
    const base = `runs/${id}`;
    const [e, i, lay, scene, summary] = await Promise.all([
      get<Envelopes>(`${base}/envelopes`), run.kind === 'dynamic' ? get<{ impacts: Impact[] }>(`${base}/impacts`) : { impacts: [] },
      get<Lay>(`${base}/statics`), get<Scene>(`${base}/scene`), get<RunSummary>(`${base}/summary`),
    ]);
    if (current()) batch(() => { envelopes.value = e; impacts.value = i.impacts; runLay.value = lay; runScene.value = scene; runSummary.value = summary; });
  } catch (error) { if (current()) sayError(error); }
}

export function runEvent(run: Run | { id: string; state: 'deleted' }): void {
  if (run.state === 'deleted') { forget(run.id); return; }
  const old = runs.value.find((r) => r.id === run.id);
  runs.value = old ? runs.value.map((r) => (r.id === run.id ? { ...r, ...run } : r)) : run.parent ? [...runs.value, run] : [run, ...runs.value];
  if (run.state === 'running' && !begun.has(run.id)) begun.set(run.id, { time: Date.now(), progress: run.progress });
  if (old?.state !== run.state) {
    if (run.id === selectedId.value) void load(run.id);
    if (run.state === 'done' && old && !run.parent) say(`${runName(run)}: done`);
    if ((run.state === 'done' || run.state === 'failed') && old && !run.parent && workspace.value !== 'runs') newRuns.value = [...newRuns.value.filter((id) => id !== run.id), run.id];
  } else if (run.id === selectedId.value && run.state === 'running' && !run.parent && run.time !== undefined && columns.value.length === 0) loadOnce(run.id);
}

let loading = '';
/** Loads a run unless that is in progress: events may come faster than the answer, which would never be the latest. */
function loadOnce(id: string): void {
  if (loading === id) return;
  loading = id;
  void load(id).finally(() => { loading = ''; });
}

/** Estimated seconds to the end; null if unknown. */
export function timeToFinish(run: Run): number | null {
  const b = begun.get(run.id);
  if (!b || run.progress - b.progress < 0.005) return null;
  return ((Date.now() - b.time) / 1000) * ((1 - run.progress) / (run.progress - b.progress));
}

/** Paths of the files of a run, below /api. */
export const tablePath = (id: string): string => `runs/${id}/table.csv`;
export const reportPath = (id: string): string => `runs/${id}/report.html`;

/** Values of histories around one time, for the animation: a coarse set that is fetched once. */
export async function fetchSeries(id: string, names: string[], t0: number | null, t1: number | null, px: number): Promise<Record<string, { t: number[]; min: number[]; max: number[] }>> {
  const query = [...names.map((n) => `name=${encodeURIComponent(n)}`), ...(t0 === null ? [] : [`t0=${t0}`]), ...(t1 === null ? [] : [`t1=${t1}`]), `px=${Math.max(50, Math.round(px))}`].join('&');
  const answer = await get<{ series: Record<string, { t: number[]; min: number[]; max: number[] }> } | { t: number[]; min: number[]; max: number[] }>(`runs/${id}/series?${query}`);
  return 'series' in answer ? answer.series : { [names[0]!]: answer };
}
