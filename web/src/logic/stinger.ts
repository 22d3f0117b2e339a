// A stinger set to another radius: each box keeps its distance along the curve from the first box, the first box stays
// where it is with the slope it has, and what a box stood off the old circle it stands off the new one.

export interface Box { x: number; z: number }

interface Circle { radius: number; slope: number }

/** Circle through the first box: radius and slope at that box (positive where it dips astern), by least squares. */
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
  // The centre lies below a stinger: anything else is not a curve that pipe can be laid over.
  if (!(b < 0) || radius > 1e5) return null;
  return { radius, slope: Math.atan2(-a, -b) };
}

function onCircle(start: Box, circle: Circle, arc: number, off: number): Box {
  const turn = circle.slope + arc / circle.radius;
  const r = circle.radius + off;
  return {
    x: start.x + r * Math.sin(turn) - circle.radius * Math.sin(circle.slope),
    z: start.z + r * Math.cos(turn) - circle.radius * Math.cos(circle.slope),
  };
}

/** `scale`: new radius over old. Null where the boxes lie on no circle. */
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
