// Histories of vessel and moorings in a run: the track of midship, and the extremes of every line.
import { effect, signal, untracked } from '@preact/signals';
import type { Column } from '../api/types';
import { scatter, type Scatter } from '../logic/plan';
import { columns, fetchSeries, selected } from './runs';
import { shownDrawn } from './shown';

export interface OffsetsInTime { track: [number, number][]; scatter: Scatter }
export interface Extremes { min: number; max: number }

/** Midship relative to its nominal position, east and north; null if the run has no such histories. */
export const offsetsInTime = signal<OffsetsInTime | null>(null);
/** By history, from t = 0 on. */
export const extremes = signal<Record<string, Extremes>>({});

const most = 20000; // points: longer histories are reduced by the program
const recorded = /^(mooring\/.*|thrust\/.*|vessel\/(surge|sway|heave|roll|pitch|yaw))$/;

/** Converts offsets forward and to port to offsets east and north. */
export function eastNorth(drawn: readonly number[], surge: readonly number[], sway: readonly number[]): [number, number][] {
  const heading = Math.atan2(drawn[6]!, drawn[3]!), c = Math.cos(heading), s = Math.sin(heading);
  return surge.map((u, i) => [c * u - s * sway[i]!, s * u + c * sway[i]!]);
}

let count = 0;

async function load(id: string, list: Column[], drawn: number[] | null): Promise<void> {
  const mine = ++count;
  const names = list.map((c) => c.name).filter((name) => recorded.test(name));
  const whole = names.length ? await fetchSeries(id, names, 0, null, 50) : {};
  if (mine !== count) return;
  const found: Record<string, Extremes> = {};
  for (const [name, s] of Object.entries(whole)) if (s.t.length) found[name] = { min: Math.min(...s.min), max: Math.max(...s.max) };
  let offsets: OffsetsInTime | null = null;
  if (drawn && names.includes('vessel/surge') && names.includes('vessel/sway')) {
    const both = await fetchSeries(id, ['vessel/surge', 'vessel/sway'], 0, null, most);
    const middle = (name: string): number[] => both[name]!.min.map((v, i) => (v + both[name]!.max[i]!) / 2);
    const track = eastNorth(drawn, middle('vessel/surge'), middle('vessel/sway'));
    if (track.length > 1) offsets = { track, scatter: scatter(track.map((p) => p[0]), track.map((p) => p[1])) };
  }
  if (mine === count) { extremes.value = found; offsetsInTime.value = offsets; }
}

export function startOffsets(): void {
  effect(() => {
    const run = selected.value, list = columns.value, drawn = shownDrawn.value;
    untracked(() => {
      if (run?.has_results && list.length) { void load(run.id, list, drawn).catch(() => undefined); return; }
      ++count;
      if (offsetsInTime.value) offsetsInTime.value = null;
      if (Object.keys(extremes.value).length) extremes.value = {};
    });
  });
}
