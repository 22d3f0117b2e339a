// Linear scales, ticks and ranges of charts.

export type Range = readonly [number, number];

/** Maps values to pixels. */
export interface Scale {
  (value: number): number;
  readonly domain: Range;
  invert(pixel: number): number;
}

export function linearScale(domain: Range, pixels: Range): Scale {
  const [lo, hi] = domain;
  const per = (pixels[1] - pixels[0]) / (hi - lo || 1);
  const scale = (value: number) => pixels[0] + (value - lo) * per;
  return Object.assign(scale, { domain, invert: (pixel: number) => lo + (pixel - pixels[0]) / (per || 1) });
}

/** A step of 1, 2 or 5 times a power of ten that divides a range into about `count` parts. */
export function tickStep(lo: number, hi: number, count: number): number {
  const rough = (hi - lo) / Math.max(count, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const part = rough / power;
  return power * (part >= Math.sqrt(50) ? 10 : part >= Math.sqrt(10) ? 5 : part >= Math.sqrt(2) ? 2 : 1);
}

/** Multiples of a round step within a range. */
export function ticks(lo: number, hi: number, count: number): number[] {
  if (!(hi > lo)) return [lo];
  const step = tickStep(lo, hi, count);
  const digits = decimals(step);
  const list = [];
  for (let i = Math.ceil(lo / step - 1e-9); i <= Math.floor(hi / step + 1e-9); ++i) list.push(Number((i * step).toFixed(digits)) + 0);
  return list;
}

const decimals = (step: number) => Math.min(Math.max(0, -Math.floor(Math.log10(step) + 1e-9)), 20);

/** Tick labels, with enough decimals to distinguish them and a minus of the width of a plus. */
export function tickTexts(values: readonly number[]): string[] {
  const steps = values.slice(1).map((value, i) => Math.abs(value - values[i]!)).filter((step) => step > 0);
  const digits = steps.length > 0 ? decimals(Math.min(...steps)) : 0;
  return values.map((value) => (steps.length > 0 ? value.toFixed(digits) : String(value)).replace('-', '\u2212'));
}

/** Minimum and maximum of the numeric values; [0, 0] if there are none. */
export function extent(values: Iterable<number | null | undefined>): [number, number] {
  let [lo, hi] = [Infinity, -Infinity];
  for (const value of values) {
    if (value === null || value === undefined || Number.isNaN(value)) continue;
    if (value < lo) lo = value;
    if (value > hi) hi = value;
  }
  return lo > hi ? [0, 0] : [lo, hi];
}

/** A range extended on both sides by a fraction of its width. */
export function withRoom([lo, hi]: Range, part: number, above = part): [number, number] {
  const width = hi - lo || Math.abs(hi) || 1;
  return [lo - part * width, hi + above * width];
}

/**
 * A range wide enough for the precision of its values: at least a hundredth of them, and ten units of the last decimal
 * shown. Smaller variations are solver noise and would fill the figure. `decimal`: unit of the last decimal shown.
 */
export function widened([lo, hi]: Range, decimal: number): [number, number] {
  const min = Math.max(0.01 * Math.max(Math.abs(lo), Math.abs(hi)), 10 * decimal);
  if (hi - lo >= min) return [lo, hi];
  return lo === 0 ? [0, min] : [0.5 * (lo + hi - min), 0.5 * (lo + hi + min)];
}

/** Index of the first value of an ascending list that is not below `value`. */
export function lowerBound(list: ArrayLike<number>, value: number): number {
  let [first, last] = [0, list.length];
  while (first < last) {
    const middle = (first + last) >> 1;
    if (list[middle]! < value) first = middle + 1; else last = middle;
  }
  return first;
}

/** Linear interpolation of a column over an ascending list, constant beyond its ends. */
export function interpolate(list: readonly number[], column: readonly number[], value: number): number {
  const i = Math.min(Math.max(lowerBound(list, value), 1), list.length - 1);
  const share = (value - list[i - 1]!) / (list[i]! - list[i - 1]! || 1);
  return column[i - 1]! + Math.min(Math.max(share, 0), 1) * (column[i]! - column[i - 1]!);
}
