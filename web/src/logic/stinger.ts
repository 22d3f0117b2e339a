// A stinger set to another radius: each box keeps its arc distance from the first box, the first box keeps its position
// and slope, and each box keeps its offset from the circle.

export interface Box { x: number; z: number }

interface Circle { radius: number; slope: number }

/** Circle through the first box: radius and slope at that box (positive downwards astern), by least squares. */
export function fitCircle(boxes: Box[]): Circle | null {
  if (boxes.length < 3) return null;
  // A circle through the first box: x^2 + z^2 = a x + b z, with the first box as origin.
  let sxx = 0, sxz = 0, szz = 0, sxr = 0, szr = 0;
  for (const box of boxes) {
    const x = box.x - boxes[0]!.x, z = box.z - boxes[0]!.z, r = x * x + z * z;
    sxx += x * x; sxz += x * z; szz += z * z; sxr += x * r; szr += z * r;
  }
  const det = sxx * szz - sxz * sxz;
  if (Math.abs(det) < 1e-9 * sxx * szz || det === 0) return null;
  const a = (sxr * szz - szr * sxz) / det;
  const b = (szr * sxx - sxr * sxz) / det;
  const radius = Math.hypot(a, b) / 2;
  // The centre lies below a stinger: otherwise it is not a curve that supports a pipe.
  if (!(b < 0) || radius > 1e5) return null;
  return { radius, slope: Math.atan2(-a, -b) };
}

/** Centre x, z and radius. */
type Round = [number, number, number];

/** Solves three equations; null if they are singular. */
function solve3(rows: number[][]): Round | null {
  const m = rows.map((r) => [...r]);
  for (let i = 0; i < 3; ++i) {
    const p = [0, 1, 2].filter((r) => r >= i).reduce((a, b) => (Math.abs(m[b]![i]!) > Math.abs(m[a]![i]!) ? b : a));
    if (Math.abs(m[p]![i]!) < 1e-14) return null;
    [m[i], m[p]] = [m[p]!, m[i]!];
    for (let r = 0; r < 3; ++r) if (r !== i) { const f = m[r]![i]! / m[i]![i]!; for (let k = i; k < 4; ++k) m[r]![k]! -= f * m[i]![k]!; }
  }
  return [0, 1, 2].map((i) => m[i]![3]! / m[i]![i]!) as Round;
}

/** Least squares of a x = b over rows [a1, a2, a3, b]. */
const leastSquares = (rows: number[][]): Round | null =>
  solve3([0, 1, 2].map((i) => [0, 1, 2, 3].map((k) => rows.reduce((sum, r) => sum + r[i]! * r[k]!, 0))));

/** Radius of the circle with the minimum sum of squared distances to the boxes, as the program's fitted_radius. */
export function fittedRadius(boxes: Box[]): number | null {
  if (boxes.length < 3) return null;
  const a = boxes[0]!, b = boxes.at(-1)!, length = Math.hypot(b.x - a.x, b.z - a.z);
  const points = boxes.map((p) => [(p.x - (a.x + b.x) / 2) / length, (p.z - (a.z + b.z) / 2) / length] as const);
  const start = leastSquares(points.map(([x, z]) => [2 * x, 2 * z, 1, x * x + z * z]));
  if (!start) return null;
  let [x, z, r]: Round = [start[0], start[1], Math.sqrt(start[2] + start[0] ** 2 + start[1] ** 2)];
  for (let i = 0; i < 50 && r * length < 1e5; ++i) {
    const step = leastSquares(points.map(([px, pz]) => { const d = Math.hypot(px - x, pz - z); return [-(px - x) / d, -(pz - z) / d, -1, d - r]; }));
    if (!step) break;
    [x, z, r] = [x - step[0], z - step[1], r - step[2]];
    if (Math.hypot(...step) < 1e-10 * r) break;
  }
  return z < 0 && r * length < 1e5 ? r * length : null;
}

function onCircle(start: Box, circle: Circle, arc: number, off: number): Box {
  const turn = circle.slope + arc / circle.radius;
  const r = circle.radius + off;
  return {
    x: start.x + r * Math.sin(turn) - circle.radius * Math.sin(circle.slope),
    z: start.z + r * Math.cos(turn) - circle.radius * Math.cos(circle.slope),
  };
}

/** `scale`: new radius over old. Null if the boxes lie on no circle. */
export function withRadius(boxes: Box[], scale: number): Box[] | null {
  const old = fitCircle(boxes);
  if (!old || !(scale > 0)) return null;
  const start = boxes[0]!;
  const centre = { x: start.x - old.radius * Math.sin(old.slope), z: start.z - old.radius * Math.cos(old.slope) };
  const next = { radius: old.radius * scale, slope: old.slope };
  return boxes.map((box) => {
    const dx = box.x - centre.x, dz = box.z - centre.z;
    const arc = (Math.atan2(dx, dz) - old.slope) * old.radius;
    return onCircle(start, next, arc, Math.hypot(dx, dz) - old.radius);
  });
}
