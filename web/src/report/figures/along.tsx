// Common parts of diagrams along the pipe: part of the line, bands and names of the boxes, yield stress, touchdown.
import type { VNode } from 'preact';
import { Chart } from '../../components/Chart';
import type { Area, Curve, LegendEntry, Level, Point } from '../../components/chart/types';
import { colours } from '../../components/colours';
import { overbendEnd, wholeEnd } from '../../components/lay';
import { fixed, shortened, useUnits } from '../../components/units';
import type { PipeData, ShownColumn } from '../data';

/** A quantity along the pipe and the format of its values. */
export interface AlongKind extends Partial<ShownColumn> {
  name: string;
  /** Label of the axis, if shorter. */
  axis?: string;
  unit: string;
  /** The axis begins at zero. */
  zero?: boolean;
  /** Yield stress is drawn. */
  yield?: boolean;
}

interface AlongProps {
  pipe: PipeData;
  kind: AlongKind;
  part: string;
  /** Range of the values as shown. */
  range: readonly [number, number];
  /** Room above the yield stress, if it is the maximum, in tenths of the range, for labels. */
  aboveYield?: number;
  curves: Curve[];
  areas?: Area[];
  levels?: Level[];
  points: Point[];
  legend?: LegendEntry[];
  hover: (s: number) => string;
}

/** Arc length at the end of a part of a figure: "overbend" or the whole line. */
export const partEnd = (pipe: PipeData, part: string): number => (part === 'overbend' ? overbendEnd(pipe) : wholeEnd(pipe));

/** Indices of an ascending list up to an end. */
export const upTo = (s: readonly number[], end: number): number[] => [...s.keys()].filter((i) => s[i]! <= end + 1e-9);

/** A value as shown, with its unit. */
export const shownValue = (value: number, { unit, digits = 0 }: AlongKind): string => `${fixed(value, digits)} ${unit}`;

/** Index of the maximum. */
export function largest(indices: readonly number[], value: (i: number) => number): number {
  return indices.reduce((best, i) => (value(i) > value(best) ? i : best), indices[0]!);
}

interface Yield { min: number; max: number; curve?: Curve; level: Level }

/** A level for a single steel grade, otherwise a curve with the name of the lowest. */
function yieldStress({ stations }: PipeData, kind: AlongKind, end: number): Yield | null {
  const indices = upTo(stations.s, end);
  const values = indices.map((i) => stations.yield_stress[i]! * kind.factor!);
  const [min, max] = [Math.min(...values), Math.max(...values)];
  if (!kind.yield || !(min > 0)) return null;
  const look = { colour: colours.accent, dash: '8 4', width: 1.3 };
  const name = `yield ${fixed(min, 0)} ${kind.unit}`;
  if (min === max) return { min, max, level: { value: min, name, ...look } };
  const points = indices.map((i, k) => [stations.s[i]!, values[k]!] as const);
  return { min, max, curve: { points, ...look }, level: { value: min, name, ...look, width: 0 } };
}

/** Range of the axis, with room for labels above the curve. */
function axisRange([lo, hi]: readonly [number, number], kind: AlongKind, limit: Yield | null, aboveYield: number): [number, number] {
  if (kind.zero) [lo, hi] = [Math.min(lo, 0), Math.max(hi, 0)];
  if (limit && hi > 0.5 * limit.max) hi = Math.max(hi, limit.max);
  const room = 0.1 * (hi - lo || 1);
  return [lo < 0 || !kind.zero ? lo - room : lo, hi + (hi === limit?.max ? aboveYield : 2) * room];
}

export function AlongChart({ pipe, kind, part, range, aboveYield = 1.4, curves, areas, levels = [], points, legend, hover }: AlongProps): VNode {
  const { unit } = useUnits();
  const overbend = part === 'overbend';
  const end = partEnd(pipe, part);
  const limit = yieldStress(pipe, kind, end);
  const [lo, hi] = axisRange(range, kind, limit, aboveYield);
  const touchdown = !overbend && pipe.touchdown.s <= end ? [{ x: pipe.touchdown.s, name: 'touchdown' }] : [];
  const all = [...levels, ...(limit ? [limit.level] : []), ...(lo < 0 ? [{ value: 0, colour: colours.zero, width: 1 }] : [])];
  return (
    <Chart
      title={`${kind.name}, ${overbend ? 'overbend' : 'whole line'}`}
      height={284}
      x={{ range: [0, end], label: 'Distance along the pipe from the tensioner', si: 'm' }}
      y={{ range: [lo, hi], label: `${kind.axis ?? kind.name} [${kind.unit}]`, digits: kind.digits }}
      rightAxis={limit && !limit.curve ? { factor: 100 / limit.min, label: '% of yield stress' } : undefined}
      right={kind.yield ? 74 : undefined}
      bands={pipe.supports.map((box) => ({ x: [box.s - box.length / 2, box.s + box.length / 2] }))}
      lane={overbend ? pipe.supports.map((box) => ({ value: box.s, text: shortened(box.name) })) : undefined}
      curves={limit?.curve ? [...curves, limit.curve] : curves}
      areas={areas}
      levels={all}
      points={points.filter((point) => point.x <= end)}
      verticals={touchdown}
      legend={legend}
      hover={(s) => `${hover(s)}, at ${fixed(s * unit('m').factor, 1)} ${unit('m').name}`}
    />
  );
}
