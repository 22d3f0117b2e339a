// Data of diagrams along the pipe: lists ready to be drawn, in engineering units.
import type { Check, Envelopes, Lay, LineAtRest, LineParts, RunSummary, Scene, Vector } from '../api/types';
import { bedHeight } from '../logic/bed';
import { resample } from '../logic/series';
import { partAt, type PartName } from '../logic/operation';
import { quantity, shownUnit, unitName } from '../logic/show';

/** `band`: two of them enclose an area, the maximum first; `width` -1: bars. */
export interface Line { name: string; colour: string; values: (number | null)[]; dash?: boolean; band?: boolean; width?: number }

export interface ChartData {
  title: string; xName: string; yName: string; x: number[]; lines: Line[];
  /** arc length of every x, for the common cursor */
  s: number[];
  /** Boxes: `y` NaN at the lower edge, with `over` the name above the bar of that height. */
  marks: { x: number; y: number; label: string; over?: number }[];
  level: { y: number; label: string; kind?: 'limit' | 'water' | 'bed' }[];
  /** Name of every x, for bars. */
  names?: string[];
}

/** Lengths and forces in shown units. */
const metres = (v: number): number => v * shownUnit('m').factor;
const newtons = (v: number): number => v * shownUnit('N').factor;
const inMetres = `[${unitName('m')}]`, inNewtons = `[${unitName('N')}]`;

const ink = { current: '#0b66c2', band: '#e07b1a', mean: '#8a96a3', run: '#5d7f2f', bed: '#a8905a' };

function distance(s: Lay): number[] {
  const { x, y } = s.pipe;
  const out = [0];
  for (let i = 1; i < x.length; ++i) out.push(out[i - 1]! + Math.hypot(x[i]! - x[i - 1]!, y[i]! - y[i - 1]!));
  return out;
}

/** Diagrams end slightly beyond touchdown, or beyond the last free span: the remaining laid pipe carries no information. */
function shownCount(s: Lay): number {
  const spans = s.seabed?.free_spans ?? [];
  const end = Math.max(s.touchdown?.s ?? Infinity, ...spans.map((span) => span.s_to)) + 60;
  const n = s.pipe.s.findIndex((v) => v > end);
  return n < 0 ? s.pipe.s.length : n + 1;
}

/** Water and seabed behind an elevation; an uneven seabed is a line of its heights below the pipe. */
function surroundings(scene: Scene | null, plan: boolean, places: { x: number[]; y: number[] }): Pick<ChartData, 'lines' | 'level'> {
  if (plan || !scene) return { lines: [], level: [] };
  const water = { y: 0, label: 'water', kind: 'water' as const };
  const { shape: uneven, normal } = scene.seabed;
  if (!uneven && normal[0] === 0 && normal[1] === 0) return { lines: [], level: [water, { y: metres(-scene.water_depth), label: 'seabed', kind: 'bed' }] };
  return { lines: [{ name: 'seabed', colour: ink.bed, values: places.x.map((x, i) => metres(bedHeight(scene.seabed, x, places.y[i]!))), width: 1.4 }], level: [water] };
}

/** Pipe, head and cable as separate lines; each continues to the first point of the next. */
function partLines(arc: number[], values: number[], parts: LineParts): ChartData['lines'] {
  const names = arc.map((s) => partAt(parts, s));
  const only = (name: PartName): (number | null)[] => values.map((v, i) => (names[i] === name || names[i - 1] === name ? v : null));
  return [{ name: 'pipe', colour: ink.current, values: only('pipe'), width: 2.2 }, { name: 'head', colour: '#8e24aa', values: only('head'), width: 5 }, { name: 'cable', colour: ink.mean, values: only('cable'), dash: true }];
}

export function shape(s: Lay, scene: Scene | null, plan: boolean, parts: LineParts | null = null): ChartData {
  const n = shownCount(s);
  const x = distance(s).slice(0, n);
  const arc = s.pipe.s.slice(0, n);
  let values = s.pipe.z.slice(0, n);
  if (plan) {
    // offset from the straight line from tensioner to anchor, positive to port of the vessel
    const m = s.pipe.x.length - 1;
    const ux = s.pipe.x[m]! - s.pipe.x[0]!, uy = s.pipe.y[m]! - s.pipe.y[0]!, size = Math.hypot(ux, uy) || 1;
    values = s.pipe.x.slice(0, n).map((px, i) => ((px - s.pipe.x[0]!) * uy - (s.pipe.y[i]! - s.pipe.y[0]!) * ux) / size);
  }
  const findX = (place: number): number => resample(arc, x, [place])[0] ?? 0;
  const around = surroundings(scene, plan, { x: s.pipe.x.slice(0, n), y: s.pipe.y.slice(0, n) });
  return {
    title: plan ? 'Plan of the pipe' : 'Elevation of the pipe', xName: `horizontal distance from the tensioner ${inMetres}`, yName: `${plan ? 'off line' : 'height above water'} ${inMetres}`, x: x.map(metres), s: arc,
    lines: [...around.lines, ...(parts ? partLines(arc, values.map(metres), parts) : [{ name: 'pipe', colour: ink.current, values: values.map(metres), width: 2.2 }])],
    marks: plan ? [] : s.supports.map((b) => ({ x: metres(findX(b.s)), y: metres(b.place[2]), label: b.name })),
    level: around.level,
  };
}

/** Smallest value that the code checks allow for a quantity along the pipe, and the yield stress. */
function allowed(key: string, s: Lay, checks: readonly Check[], factor: number): ChartData['level'] {
  if (key === 'utilisation') return [{ y: 1, label: 'yield', kind: 'limit' }];
  if (key === 'checks') return [{ y: 1, label: 'allowable', kind: 'limit' }];
  const out: ChartData['level'] = [];
  const said = { von_mises: 'von Mises stress', strain: 'longitudinal strain', effective_tension: 'effective tension' }[key];
  const limits = checks.filter((c) => c.quantity === said && c.governing && c.capacity !== undefined);
  if (said && limits.length) {
    const least = limits.reduce((a, b) => (b.capacity! < a.capacity! ? b : a));
    out.push({ y: least.capacity! * factor, label: `allowable, ${least.code.replace(/ \(.*/, '')}`, kind: 'limit' });
  }
  const r = s.key?.overbend ?? s.key?.sagbend;
  if ((key === 'von_mises' || key === 'bending_stress') && r && r.utilisation > 0) out.push({ y: (r.von_mises / r.utilisation) * factor, label: 'yield', kind: 'limit' });
  return out;
}

export function along(key: string, s: Lay, e: Envelopes | null, checks: readonly Check[]): ChartData {
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
    lines.push({ name: 'static', colour: ink.current, values: nowAtRun, width: 2 });
  } else lines.push({ name: 'static', colour: ink.current, values, width: 2 });
  return { title: q.name, xName: `arc length from the tensioner ${inMetres}`, yName: `${q.name.toLowerCase().replace('von mises', 'von Mises')} [${q.unit}]`, x: x.map(metres), s: x, lines, marks: s.supports.map((b) => ({ x: metres(b.s), y: Number.NaN, label: b.name })), level: allowed(key, s, checks, q.factor) };
}

/** Tension of a line other than the pipe. */
export function lineTension(line: LineAtRest): ChartData {
  return { title: `Tension of ${line.name}`, xName: `unstressed length from the first end ${inMetres}`, yName: `effective tension ${inNewtons}`, x: line.s.map(metres), s: line.s, lines: [{ name: line.name, colour: ink.current, values: line.tension.map(newtons), width: 2 }], marks: [], level: [] };
}

/** A line between its ends, over their horizontal distance: in elevation or in plan. */
export function lineShape(line: { name: string; shape: Vector[] }, scene: Scene | null, plan: boolean): ChartData | null {
  const from = line.shape[0], to = line.shape.at(-1);
  if (!from || !to) return null;
  const ux = to[0] - from[0], uy = to[1] - from[1], size = Math.hypot(ux, uy) || 1;
  const x = line.shape.map((p) => ((p[0] - from[0]) * ux + (p[1] - from[1]) * uy) / size);
  // round-off of a straight line is removed
  const off = line.shape.map((p) => Math.round((1e3 * ((p[0] - from[0]) * uy - (p[1] - from[1]) * ux)) / size) / 1e3 || 0);
  const around = surroundings(scene, plan, { x: line.shape.map((p) => p[0]), y: line.shape.map((p) => p[1]) });
  return {
    title: `${plan ? 'Plan' : 'Elevation'} of ${line.name}`, xName: `horizontal distance along the line ${inMetres}`, yName: `${plan ? 'off line' : 'height above water'} ${inMetres}`, x: x.map(metres), s: x,
    lines: [...around.lines, { name: line.name, colour: ink.current, values: (plan ? off : line.shape.map((p) => p[2])).map(metres), width: 2.2 }], marks: [],
    level: around.level,
  };
}

/** The maximum of the run is drawn behind the static reaction. */
export function reactions(s: Lay, run: RunSummary['dynamic'] | undefined): ChartData {
  const x = s.supports.map((b) => b.s);
  const before = s.supports.map((b) => newtons(b.reaction));
  const most = run ? s.supports.map((b) => { const r = run.supports.find((o) => o.name === b.name); return r ? newtons(r.reaction.max) : null; }) : null;
  return {
    title: 'Box reactions', xName: `arc length from the tensioner ${inMetres}`, yName: `reaction ${inNewtons}`, x: x.map(metres), s: x, names: s.supports.map((b) => b.name),
    lines: [...(most ? [{ name: 'maximum of the run', colour: ink.band, values: most, width: -1 }] : []), { name: most ? 'static' : 'reaction', colour: most ? ink.current : ink.band, values: before, width: -1 }],
    marks: s.supports.map((b, i) => ({ x: metres(b.s), y: Number.NaN, label: b.name, over: Math.max(before[i]!, most?.[i] ?? 0) })), level: [],
  };
}

/** Rows of a CSV file, headed by titles with units. */
export function diagramRows({ xName, yName, x, lines }: ChartData): (string | number)[][] {
  const unit = /\[.*\]/.exec(yName)?.[0] ?? '';
  return [[xName, ...lines.map(({ name }) => `${name} ${unit}`.trim())], ...x.map((place, i) => [place, ...lines.map(({ values }) => values[i] ?? '')])];
}

export const colours = ink;
