// Height of the seabed at a position, as drawn.
import type { BedShape, Scene } from '../api/types';

/** Interval of ascending knots that contains `value`, and the fraction within it; clamped at the ends. */
function interval(knots: number[], value: number): [number, number] {
  let i = 0;
  while (i + 2 < knots.length && knots[i + 1]! < value) ++i;
  const width = knots[i + 1]! - knots[i]! || 1;
  return [i, Math.min(Math.max((value - knots[i]!) / width, 0), 1)];
}

function onShape(shape: BedShape, x: number, y: number): number {
  if (!shape.y) {
    const [ox, oy] = shape.origin ?? [0, 0], [ax, ay] = shape.along ?? [1, 0];
    const [i, part] = interval(shape.x, (x - ox) * ax + (y - oy) * ay);
    return shape.z[i]! * (1 - part) + shape.z[i + 1]! * part;
  }
  const [i, u] = interval(shape.x, x), [j, v] = interval(shape.y, y);
  const heightAt = (row: number, column: number): number => shape.z[row * shape.x.length + column]!;
  return (heightAt(j, i) * (1 - u) + heightAt(j, i + 1) * u) * (1 - v) + (heightAt(j + 1, i) * (1 - u) + heightAt(j + 1, i + 1) * u) * v;
}

/** World height of the seabed below a position in plan [m]. */
export function bedHeight(bed: Scene['seabed'], x: number, y: number): number {
  if (bed.shape) return onShape(bed.shape, x, y);
  const n = bed.normal, p = bed.point;
  return p[2] - (n[0] * (x - p[0]) + n[1] * (y - p[1])) / (n[2] || 1);
}
