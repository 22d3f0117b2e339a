// What a diagram along the pipe shows: lists ready to be drawn, in engineering units.
import type { Converged, Envelopes, Scene } from '../api/types';
import { resample } from '../logic/decimate';
import { quantity } from '../logic/show';
import type { Line } from '../logic/table';

export interface ChartData {
  title: string; xName: string; yName: string; x: number[]; lines: (Line & { band?: boolean; width?: number })[];
  /** arc length of every x, for the common cursor */
  s: number[];
  marks: { x: number; y: number; label: string }[];
  level: { y: number; label: string }[];
  keepAspect?: boolean;
}

const ink = { now: '#0b66c2', band: '#e07b1a', mean: '#8a96a3', run: '#5d7f2f' };

function distance(s: Converged): number[] {
  const { x, y } = s.pipe;
  const out = [0];
  for (let i = 1; i < x.length; ++i) out.push(out[i - 1]! + Math.hypot(x[i]! - x[i - 1]!, y[i]! - y[i - 1]!));
  return out;
}

/** Diagrams end a little behind touchdown: the long rest on the seabed says nothing. */
function shownCount(s: Converged): number {
  const end = (s.touchdown?.s ?? Infinity) + 60;
  const n = s.pipe.s.findIndex((v) => v > end);
  return n < 0 ? s.pipe.s.length : n + 1;
}

export function shape(s: Converged, scene: Scene | null, plan: boolean): ChartData {
  const n = shownCount(s);
  const x = distance(s).slice(0, n);
  const arc = s.pipe.s.slice(0, n);
  let values = s.pipe.z.slice(0, n);
  if (plan) {
    // off the straight line from tensioner to anchor, to port of the vessel positive
    const m = s.pipe.x.length - 1;
    const ux = s.pipe.x[m]! - s.pipe.x[0]!, uy = s.pipe.y[m]! - s.pipe.y[0]!, size = Math.hypot(ux, uy) || 1;
    values = s.pipe.x.slice(0, n).map((px, i) => ((px - s.pipe.x[0]!) * uy - (s.pipe.y[i]! - s.pipe.y[0]!) * ux) / size);
  }
  const at = (place: number): number => resample(arc, x, [place])[0] ?? 0;
  return {
    title: plan ? 'Plan of the pipe' : 'Elevation of the pipe', xName: 'horizontal distance from the tensioner [m]', yName: plan ? 'off line [m]' : 'height above water [m]', x, s: arc,
    lines: [{ name: 'pipe', colour: ink.now, values, width: 2.2 }],
    marks: plan ? [] : s.supports.map((b) => ({ x: at(b.s), y: b.place[2], label: b.name })),
    level: plan || !scene ? [] : [{ y: 0, label: 'water' }, { y: -scene.water_depth, label: 'seabed' }],
  };
}

export function along(key: string, s: Converged, e: Envelopes | null): ChartData {
  const q = quantity(key)!;
  const n = shownCount(s);
  const values = (s.pipe[q.key] as number[]).slice(0, n).map((v) => v * q.factor);
  let x = s.pipe.s.slice(0, n);
  const lines: ChartData['lines'] = [];
  const band = e && q.key !== 'utilisation' && q.key !== 'checks' ? e[q.key] : null;
  if (band?.max && band.min) {
    const end = x[x.length - 1]!;
    const m = e!.s.filter((v) => v <= end).length;
    const scaled = (list: number[]): number[] => list.slice(0, m).map((v) => v * q.factor);
    const nowAtRun = resample(x, values, e!.s.slice(0, m));
    x = e!.s.slice(0, m);
    lines.push({ name: 'largest', colour: ink.band, values: scaled(band.max), band: true }, { name: 'least', colour: ink.band, values: scaled(band.min), band: true });
    if (band.mean) lines.push({ name: 'mean', colour: ink.mean, values: scaled(band.mean), dash: true });
    lines.push({ name: 'static', colour: ink.now, values: nowAtRun, width: 2 });
  } else lines.push({ name: 'static', colour: ink.now, values, width: 2 });
  return { title: q.name, xName: 'arc length from the tensioner [m]', yName: `${q.name.toLowerCase()} [${q.unit}]`, x, s: x, lines, marks: s.supports.map((b) => ({ x: b.s, y: Number.NaN, label: b.name })), level: [] };
}

export function reactions(s: Converged): ChartData {
  return {
    title: 'Roller box reactions', xName: 'arc length from the tensioner [m]', yName: 'reaction [kN]', x: s.supports.map((b) => b.s), s: s.supports.map((b) => b.s),
    lines: [{ name: 'reaction', colour: ink.band, values: s.supports.map((b) => b.reaction / 1e3), width: -1 }], marks: [], level: [],
  };
}

export const colours = ink;
