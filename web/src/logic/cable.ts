// The cable of a stage: tension along it, and its results.
import type { ChartData } from '../charts/data';
import type { Check, Lay, LineParts } from '../api/types';
import { display } from './show';

export interface CableState {
  /** Arc lengths from the tensioner or winch and tensions there, SI. */
  s: number[]; tension: number[];
  length: number; largest: number; least: number;
  /** Tension at the ends: first the end nearer to the vessel. */
  near: number; far: number;
  /** Length on the seabed, determined by height. */
  onBed: number;
}

/** `bed`: height of the seabed at a position; null if there is no cable in the line. */
export function cableState(lay: Lay, parts: LineParts | null, bed: (x: number, y: number) => number): CableState | null {
  if (!parts) return null;
  const { s, x, y, z, effective_tension: tension } = lay.pipe;
  const inside = [...s.keys()].filter((i) => (parts.cable_at_far_end ? s[i]! >= parts.head_to - 1e-6 : s[i]! <= parts.head_from + 1e-6));
  if (inside.length < 2 || !tension.length) return null;
  const places = inside.map((i) => s[i]!), values = inside.map((i) => tension[i]!);
  const lies = (i: number): boolean => z[i]! - bed(x[i]!, y[i]!) < 0.2;
  let onBed = 0;
  for (let k = 1; k < inside.length; ++k) if (lies(inside[k]!) && lies(inside[k - 1]!)) onBed += places[k]! - places[k - 1]!;
  return { s: places, tension: values, length: places.at(-1)! - places[0]!, largest: Math.max(...values), least: Math.min(...values), near: values[0]!, far: values.at(-1)!, onBed };
}

/** The check of its breaking load, if there is one. */
export const cableCheck = (checks: readonly Check[]): Check | null => checks.find((check) => check.id === 'cable_load') ?? null;

export function cableChart(cable: CableState, breakingLoad: number | null, check: Check | null): ChartData {
  const [metre, m] = display('m'), [newton, n] = display('N');
  const safety = check?.capacity;
  return {
    title: 'Tension along the cable', xName: `arc length from the vessel [${metre}]`, yName: `effective tension [${newton}]`,
    x: cable.s.map((v) => v * m), s: cable.s, marks: [],
    lines: [{ name: 'cable', colour: '#0b7bd0', width: 2, values: cable.tension.map((v) => v * n) }],
    level: safety && breakingLoad && cable.largest > 0.3 * safety ? [{ y: safety * n, label: 'allowable', kind: 'limit' }] : [],
  };
}
