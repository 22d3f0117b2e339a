// Positions in ascending lists, and interpolation.
import { interpolate, lowerBound } from '../components/chart/scale';

/** Index of the last entry of an ascending list that is not above `x`; 0 before the first. */
export function indexBefore(list: ArrayLike<number>, x: number): number {
  const i = lowerBound(list, x);
  return list[i] === x ? i : Math.max(0, i - 1);
}

export function nearest(list: ArrayLike<number>, x: number): number {
  const i = indexBefore(list, x);
  return i + 1 < list.length && list[i + 1]! - x < x - list[i]! ? i + 1 : i;
}

/** Linear interpolation of y(x) at ascending places; null outside, so that a diagram shows a gap. */
export function resample(x: readonly number[], y: readonly number[], places: readonly number[]): (number | null)[] {
  return places.map((place) => (x.length < 2 || place < x[0]! || place > x[x.length - 1]! ? null : interpolate(x, y, place)));
}
