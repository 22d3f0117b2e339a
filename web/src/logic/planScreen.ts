// Conversion between the plan (east and north in metres) and pixels.
import { around } from './plan';

export interface PlanScreen { width: number; height: number; scale: number; x: (east: number) => number; y: (north: number) => number; east: (x: number) => number; north: (y: number) => number }

type Place = readonly [number, number];

/** `left`: fraction of the width used by the table next to the drawing. */
export function planScreen(points: readonly Place[], width: number, height: number, left: number): PlanScreen {
  const box = around(points);
  const scale = Math.min((width - left) / (box.east - box.west), height / (box.north - box.south));
  const west = (box.west + box.east) / 2 - (width + left) / 2 / scale, north = (box.north + box.south) / 2 + height / 2 / scale;
  return {
    width, height, scale,
    x: (east) => (east - west) * scale, y: (place) => (north - place) * scale,
    east: (x) => west + x / scale, north: (y) => north - y / scale,
  };
}

export const screenPath = (points: readonly Place[], on: PlanScreen): string =>
  points.map(([x, y], i) => `${i ? 'L' : 'M'}${on.x(x).toFixed(1)} ${on.y(y).toFixed(1)}`).join('');
