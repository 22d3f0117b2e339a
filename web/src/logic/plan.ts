// The plan of a vessel on its moorings: north up, in metres, with its objects.
import type { Scene, Vector } from '../api/types';

export interface Box { west: number; south: number; east: number; north: number }

/** Bounding box of all points, with a margin as a fraction of the larger side; never thinner than `least` of the larger side. */
export function around(points: readonly (readonly [number, number])[], margin = 0.09, least = 0.35): Box {
  let west = Infinity, south = Infinity, east = -Infinity, north = -Infinity;
  for (const [x, y] of points) { west = Math.min(west, x); east = Math.max(east, x); south = Math.min(south, y); north = Math.max(north, y); }
  if (west > east) return { west: -1, south: -1, east: 1, north: 1 };
  const size = Math.max(east - west, north - south, 1);
  const wide = Math.max(0, (least * size - (east - west)) / 2) + margin * size, high = Math.max(0, (least * size - (north - south)) / 2) + margin * size;
  return { west: west - wide, east: east + wide, south: south - high, north: north + high };
}

/** Outline of the hull at the water line, with a pointed bow. */
export function outline(vessel: NonNullable<Scene['vessel']>): [number, number][] {
  const { pose: p, length, beam } = vessel;
  const corners: [number, number][] = [[-0.5, -0.5], [0.4, -0.5], [0.5, 0], [0.4, 0.5], [-0.5, 0.5]];
  return corners.map(([a, b]) => [p[0]! + p[3]! * a * length + p[4]! * b * beam, p[1]! + p[6]! * a * length + p[7]! * b * beam]);
}

export const flat = (p: Vector): [number, number] => [p[0], p[1]];

/** Point on a polyline, by the fraction of its length from the beginning. */
export function alongLine(points: readonly Vector[], share: number): [number, number] {
  const steps = points.slice(1).map((p, i) => Math.hypot(p[0] - points[i]![0], p[1] - points[i]![1]));
  let left = share * steps.reduce((a, b) => a + b, 0);
  for (let i = 0; i < steps.length; ++i) {
    if (left <= steps[i]! || i === steps.length - 1) {
      const f = steps[i]! > 0 ? Math.min(1, left / steps[i]!) : 0, a = points[i]!, b = points[i + 1]!;
      return [a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1])];
    }
    left -= steps[i]!;
  }
  return points.length ? flat(points[0]!) : [0, 0];
}

/** A round length of about a quarter of the width, for the scale bar. */
export function scaleLength(width: number): number {
  const raw = width / 4, power = 10 ** Math.floor(Math.log10(raw));
  return [5, 2, 1].map((m) => m * power).find((m) => m <= raw) ?? power;
}

/** Joint statistics of two quantities. */
export interface Scatter { x: { mean: number; std: number }; y: { mean: number; std: number }; covariance: number }

/** Axes of the ellipse of `times` standard deviations, and its rotation anticlockwise from x in rad. */
export function ellipse(s: Scatter, times: number): { a: number; b: number; turn: number } {
  const xx = s.x.std ** 2, yy = s.y.std ** 2, xy = s.covariance;
  const middle = (xx + yy) / 2, reach = Math.hypot((xx - yy) / 2, xy);
  return { a: times * Math.sqrt(Math.max(0, middle + reach)), b: times * Math.sqrt(Math.max(0, middle - reach)), turn: 0.5 * Math.atan2(2 * xy, xx - yy) };
}

/** Mean, standard deviation and covariance of two histories with the same times. */
export function scatter(x: readonly number[], y: readonly number[]): Scatter {
  const n = Math.min(x.length, y.length) || 1;
  const mean = (v: readonly number[]): number => v.slice(0, n).reduce((a, b) => a + b, 0) / n;
  const mx = mean(x), my = mean(y);
  let xx = 0, yy = 0, xy = 0;
  for (let i = 0; i < Math.min(x.length, y.length); ++i) { xx += (x[i]! - mx) ** 2; yy += (y[i]! - my) ** 2; xy += (x[i]! - mx) * (y[i]! - my); }
  return { x: { mean: mx, std: Math.sqrt(xx / n) }, y: { mean: my, std: Math.sqrt(yy / n) }, covariance: xy / n };
}

/** Middle of the foot of a name next to a mark, on the outer side of the mooring spread; above or below it if there is no room at the side. */
export function labelAt(mark: readonly [number, number], away: readonly [number, number], wide: number, width: number): [number, number] {
  const [x, y] = mark, size = Math.hypot(...away) || 1, aside = away[0] / size;
  if (Math.abs(aside) > 0.3) {
    const middle = x + Math.sign(aside) * (wide / 2 + 9);
    if (middle - wide / 2 >= 2 && middle + wide / 2 <= width - 2) return [middle, y + 4];
  }
  return [Math.min(Math.max(x, wide / 2 + 2), width - wide / 2 - 2), away[1] < 0 ? y - 10 : y + 18];
}
