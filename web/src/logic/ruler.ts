// Distances between two points of the picture, in ship axes.
import type { Vector } from '../api/types';
import { toShip, type ShipAxes } from './shipAxes';

/** A clicked point in world axes; in the plan its height is unknown. */
export interface RulerPoint { place: Vector; flat: boolean }

export interface Measured {
  distance: number;
  /** Positive astern, to port and up [m]. */
  astern: number; port: number;
  /** Null if one of the points has no height. */
  up: number | null;
}

export function measure(axes: ShipAxes, [a, b]: readonly [RulerPoint, RulerPoint]): Measured {
  const from = toShip(axes, a.place), to = toShip(axes, b.place);
  const [astern, port] = [to[0] - from[0], to[1] - from[1]];
  const up = a.flat || b.flat ? null : to[2] - from[2];
  return { distance: Math.hypot(astern, port, up ?? 0), astern, port, up };
}

/** Points after a click: a third click starts again. */
export const withPoint = (points: readonly RulerPoint[], next: RulerPoint): RulerPoint[] => (points.length >= 2 ? [next] : [...points, next]);
