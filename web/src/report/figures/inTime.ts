// Common functions of diagrams over time.
import type { Area, Band, Vertical } from '../../components/chart/types';
import type { Trace } from '../data';

const kFullRange = 4095;  // quanta of a trace
const kThin = 60;  // quanta: maximum height of a stretch that counts as a point

/** Minutes if seconds would be long numbers. */
export interface TimeScale { name: string; seconds: number; range: [number, number] }

/** [s]; the build-up ends at 0. */
export function timeScale(buildUp: number, duration: number): TimeScale {
  const [name, seconds] = duration > 7200 ? ['min', 60] as const : ['s', 1] as const;
  return { name, seconds, range: [-buildUp / seconds, duration / seconds] };
}

export const timeLabel = ({ name }: TimeScale): string => `Time from the end of the build-up [${name}]`;

export const traceRange = (trace: Trace): [number, number] => [trace.lowest, trace.lowest + kFullRange * trace.quantum];

/** Time in the middle of stretch k of a trace. */
export function traceTime({ range: [first, last] }: TimeScale, trace: Trace): (k: number) => number {
  const step = (last - first) / trace.low.length;
  return (k) => first + (k + 0.5) * step;
}

/** True for stretches that are hardly more than a point, so that the band looks like a line. */
export function looksLikeLine({ low, high }: Trace): boolean {
  const heights = low.flatMap((value, k) => (value === null ? [] : [high[k]! - value])).sort((a, b) => a - b);
  return heights.length > 0 && heights[heights.length >> 1]! < kThin;
}

/** From the minimum to the maximum of every time interval. */
export function traceArea(trace: Trace, scale: TimeScale, look: { line: string; area: string }): Area {
  const time = traceTime(scale, trace);
  const value = (level: number | null) => (level === null ? null : trace.lowest + trace.quantum * level);
  const line = looksLikeLine(trace);
  const colour = line ? look.line : look.area;
  return { points: trace.low.map((low, k) => [time(k), value(low), value(trace.high[k]!)]), colour, edge: colour, edgeWidth: line ? 1.4 : 0.9 };
}

/** The build-up is shaded. */
export function buildUpMarks({ range: [first] }: TimeScale): { bands: Band[]; verticals: Vertical[] } {
  return first < 0 ? { bands: [{ x: [first, 0], colour: '#eceff2' }], verticals: [{ x: 0 }] } : { bands: [], verticals: [] };
}

export const rangeBand = (range: [number, number]): Band => ({ y: range, colour: '#cfe8cf' });
