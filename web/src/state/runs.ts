// Runs: the list, the one that is looked at, and what diagrams and animation need of it.
import { computed, signal } from '@preact/signals';
import { address, get, post } from '../api/client';
import type { Check, Column, Envelopes, Impact, Run } from '../api/types';
import { newerList } from '../logic/runs';
import { say, sayError } from './notices';

export const runs = signal<Run[]>([]);
export const selectedId = signal<string | null>(null);
export const selected = computed(() => runs.value.find((r) => r.id === selectedId.value) ?? null);
export const envelopes = signal<Envelopes | null>(null);
export const columns = signal<Column[]>([]);
export const impacts = signal<Impact[]>([]);
/** Code checks of the run that is looked at; null until it has some. */
export const runChecks = signal<Check[] | null>(null);
/** When a run was first seen running: for the time to finish. */
const begun = new Map<string, { at: number; progress: number }>();

export async function fetchRuns(): Promise<void> {
  try { const list = await get<Run[]>('runs'); runs.value = newerList(runs.value, list); } catch (error) { sayError(error); }
}

export async function startRun(kind: Run['kind'], duration?: number): Promise<void> {
  try {
    const { id } = await post<{ id: string }>('runs', { kind, ...(duration ? { duration } : {}) });
    await fetchRuns();
    select(id);
  } catch (error) { sayError(error); }
}

export async function cancelRun(id: string): Promise<void> {
  try { await post(`runs/${id}/cancel`); await fetchRuns(); } catch (error) { sayError(error); }
}

let loadCount = 0;

export function select(id: string | null): void {
  selectedId.value = id;
  envelopes.value = null;
  columns.value = [];
  impacts.value = [];
  runChecks.value = null;
  if (id) void load(id);
}

async function load(id: string): Promise<void> {
  const mine = ++loadCount;
  const run = runs.value.find((r) => r.id === id);
  if (!run) return;
  // a run that failed or was cancelled leaves no histories behind
  if (run.state === 'failed' || run.state === 'cancelled') { columns.value = []; return; }
  try {
    if (run.kind === 'dynamic' && (run.state === 'done' || (run.state === 'running' && run.time !== undefined))) {
      const list = await get<Column[]>(`runs/${id}/columns`);
      if (mine === loadCount && selectedId.value === id) columns.value = list;
    }
    if (run.state !== 'done') return;
    const e = await get<Envelopes>(`runs/${id}/envelopes`);
    const i = run.kind === 'dynamic' ? await get<{ impacts: Impact[] }>(`runs/${id}/impacts`) : { impacts: [] };
    const summary = await get<{ checks?: { list: Check[] }; dynamic?: { checks?: { list: Check[] } } }>(`runs/${id}/summary`);
    if (mine === loadCount && selectedId.value === id) { envelopes.value = e; impacts.value = i.impacts; runChecks.value = (summary.dynamic ?? summary).checks?.list ?? null; }
  } catch (error) { sayError(error); }
}

export function runEvent(run: Run): void {
  const old = runs.value.find((r) => r.id === run.id);
  runs.value = old ? runs.value.map((r) => (r.id === run.id ? { ...r, ...run } : r)) : [run, ...runs.value];
  if (run.state === 'running' && !begun.has(run.id)) begun.set(run.id, { at: Date.now(), progress: run.progress });
  if (old?.state !== run.state) {
    if (run.id === selectedId.value) void load(run.id);
    if (run.state === 'done' && old) say(`${run.title || 'Run'}: done`);
  } else if (run.id === selectedId.value && run.state === 'running' && run.time !== undefined && columns.value.length === 0) void load(run.id);
}

/** Seconds to the end, judged by the pace so far; null before there is one. */
export function timeToFinish(run: Run): number | null {
  const b = begun.get(run.id);
  if (!b || run.progress - b.progress < 0.005) return null;
  return ((Date.now() - b.at) / 1000) * ((1 - run.progress) / (run.progress - b.progress));
}

export const reportAddress = (id: string): string => address(`runs/${id}/report.html`);

/** Values of histories around one time, for the animation: a coarse whole that is fetched once. */
export async function fetchSeries(id: string, names: string[], t0: number | null, t1: number | null, px: number): Promise<Record<string, { t: number[]; min: number[]; max: number[] }>> {
  const query = [...names.map((n) => `name=${encodeURIComponent(n)}`), ...(t0 === null ? [] : [`t0=${t0}`]), ...(t1 === null ? [] : [`t1=${t1}`]), `px=${Math.max(50, Math.round(px))}`].join('&');
  const answer = await get<{ series: Record<string, { t: number[]; min: number[]; max: number[] }> } | { t: number[]; min: number[]; max: number[] }>(`runs/${id}/series?${query}`);
  return 'series' in answer ? answer.series : { [names[0]!]: answer };
}
