// Animation of a run: a clock, and frames fetched in chunks around it.
import { effect, signal, untracked } from '@preact/signals';
import { get } from '../api/client';
import type { Series } from '../api/types';
import { blend, decode, linesBetween, type Chunk, type FramesAnswer } from '../logic/frames';
import { indexBefore } from '../logic/series';
import { columns, fetchSeries } from './runs';
import { shownRun } from './shown';
import { sayError } from './notices';

const piece = 60; // frames in one request
const kept = 24; // chunks held in memory

export interface Shown { time: number; pose: number[]; places: Float32Array; effective_tension: Float32Array; von_mises: Float32Array; lines: Map<string, Float32Array> | null }

export const active = signal(false);
export const playing = signal(false);
export const speed = signal(1);
export const time = signal(0);
export const first = signal(0);
export const last = signal(0);
export const shown = signal<Shown | null>(null);

/** Histories around the time shown: tension, tensioner, reactions of the boxes. */
export const histories = signal<Record<string, Series>>({});
/** Maximum reaction of a box in the whole run, for the colours. */
export const largestReaction = signal(0);
const watched = /^(top_tension|tensioner\/.*|support\/.*\/reaction)$/;
const stretch = 60; // s of histories in one request
const stretches = new Map<number, Promise<Record<string, Series>>>();

function followHistories(): void {
  const names = columns.value.map((c) => c.name).filter((name) => watched.test(name));
  const id = runId;
  if (!id || names.length === 0) return;
  const k = Math.floor((time.value - first.value) / stretch), t0 = first.value + k * stretch;
  let wanted = stretches.get(k);
  if (!wanted) {
    wanted = fetchSeries(id, names, t0 - 1, t0 + stretch + 1, 620).catch(() => ({}));
    stretches.set(k, wanted);
    if (stretches.size > 8) stretches.delete(stretches.keys().next().value!);
  }
  void wanted.then((got) => { if (id === runId && Math.floor((time.value - first.value) / stretch) === k && histories.value !== got) histories.value = got; });
}

async function findLargest(): Promise<void> {
  const id = runId, names = columns.value.map((c) => c.name).filter((name) => /^support\/.*\/reaction$/.test(name));
  if (!id || names.length === 0) return;
  const all = await fetchSeries(id, names, 0, null, 50).catch(() => ({}));
  if (id === runId) largestReaction.value = Math.max(0, ...Object.values(all).flatMap((s) => s.max));
}

let runId = '';
let total = 0;
let step = 0.5;
const cache = new Map<number, Chunk>();
const asked = new Map<number, Promise<Chunk | null>>();

async function fetchPiece(k: number): Promise<Chunk | null> {
  const have = cache.get(k);
  if (have) { cache.delete(k); cache.set(k, have); return have; }
  const running = asked.get(k);
  if (running) return running;
  const id = runId;
  const promise = get<FramesAnswer>(`runs/${id}/frames?from=${k * piece}&count=${piece}`).then((answer) => {
    asked.delete(k);
    if (id !== runId) return null;
    total = answer.total;
    const chunk = decode(answer);
    cache.set(k, chunk);
    if (cache.size > kept) cache.delete(cache.keys().next().value!);
    return chunk;
  }).catch((error: unknown) => { asked.delete(k); sayError(error); return null; });
  asked.set(k, promise);
  return promise;
}

export async function open(id: string): Promise<void> {
  runId = id;
  cache.clear();
  asked.clear();
  stretches.clear();
  const chunk = await fetchPiece(0);
  if (!chunk || chunk.count === 0) return;
  step = chunk.count > 1 ? (chunk.time[chunk.count - 1]! - chunk.time[0]!) / (chunk.count - 1) : 0.5;
  first.value = chunk.time[0]!;
  last.value = chunk.time[0]! + (total - 1) * step;
  time.value = Math.max(first.value, Math.min(last.value, 0));
  active.value = true;
  await show();
}

export function close(): void {
  active.value = false;
  playing.value = false;
  shown.value = null;
  histories.value = {};
  largestReaction.value = 0;
  stretches.clear();
  runId = '';
}

function buffer(size: number): Float32Array { return new Float32Array(size); }

async function show(): Promise<void> {
  const position = Math.min(total - 1, Math.max(0, (time.value - first.value) / step));
  const i = Math.floor(position);
  const k = Math.floor(i / piece);
  const chunk = cache.get(k) ?? await fetchPiece(k);
  if (!chunk || !active.value) return;
  const next = Math.min(total - 1, i + 1);
  const following = Math.floor(next / piece) === k ? chunk : cache.get(k + 1) ?? chunk;
  if (i % piece > piece / 2 && (k + 1) * piece < total && !cache.has(k + 1)) void fetchPiece(k + 1);
  const a = Math.min(i - chunk.from, chunk.count - 1);
  const b = Math.min(Math.max(0, next - following.from), following.count - 1);
  const f = position - i;
  const n = chunk.stations;
  shown.value = {
    time: time.value,
    pose: chunk.pose[a]!.map((v, m) => v * (1 - f) + following.pose[b]![m]! * f),
    places: blend(chunk.place, 3 * n * a, following.place, 3 * n * b, 3 * n, f, buffer(3 * n)),
    effective_tension: blend(chunk.effective_tension, n * a, following.effective_tension, n * b, n, f, buffer(n)),
    von_mises: blend(chunk.von_mises, n * a, following.von_mises, n * b, n, f, buffer(n)),
    lines: linesBetween(chunk, a, following, b, f),
  };
}

let wanted = false;
let working = false;

/** Only the latest time is drawn while chunks are pending. */
async function showLatest(): Promise<void> {
  wanted = true;
  if (working) return;
  working = true;
  while (wanted) { wanted = false; await show(); }
  working = false;
}

export function seek(t: number): void {
  time.value = Math.min(last.value, Math.max(first.value, t));
  followHistories();
  void showLatest();
}

export function startAnimation(): void {
  let before = 0;
  const tick = (clock: number): void => {
    if (!playing.value) return;
    requestAnimationFrame(tick);
    const dt = Math.min(0.1, (clock - before) / 1000);
    before = clock;
    let t = time.value + dt * speed.value;
    if (t >= last.value) { t = first.value > 0 ? first.value : Math.min(0, last.value); if (last.value > 0) t = Math.max(first.value, 0); }
    seek(t);
  };
  effect(() => { if (playing.value) untracked(() => { before = performance.now(); requestAnimationFrame(tick); }); });
  effect(() => {
    if (active.value && columns.value.length) untracked(() => { followHistories(); void findLargest(); });
  });
  effect(() => {
    const run = shownRun.value;
    const id = run && run.kind === 'dynamic' && run.has_results ? run.id : null;
    untracked(() => { if (id && id !== runId) { close(); void open(id); } else if (!id && runId) close(); });
  });
}

/** The maximum of a history at a time: states and peaks are not averaged. */
export function peakAt(series: Series | undefined, t: number): number | null {
  return series && series.t.length ? series.max[indexBefore(series.t, t)]! : null;
}

export function valueAt(series: { t: number[]; min: number[]; max: number[] } | undefined, t: number): number | null {
  if (!series || series.t.length === 0) return null;
  const i = indexBefore(series.t, t);
  return (series.min[i]! + series.max[i]!) / 2;
}
