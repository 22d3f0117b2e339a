// Geometry of a tube along a line of points: rings of directions that do not twist (parallel transport).
// Radius and minimum thickness on the screen are added by the graphics card, see view/pipe.ts.

export interface Tube {
  centres: Float32Array;
  normals: Float32Array;
  stations: number;
  sides: number;
}

export function tubeIndices(stations: number, sides: number): Uint32Array {
  const out = new Uint32Array(Math.max(0, stations - 1) * sides * 6);
  let k = 0;
  for (let i = 0; i + 1 < stations; ++i) {
    for (let j = 0; j < sides; ++j) {
      const a = i * sides + j;
      const b = i * sides + ((j + 1) % sides);
      const c = a + sides;
      const d = b + sides;
      out.set([a, b, c, b, d, c], k);
      k += 6;
    }
  }
  return out;
}

/** `points`: x, y, z of each station in turn. `into` is reused if it is large enough; it may be longer. */
export function tube(points: ArrayLike<number>, sides: number, into?: Tube): Tube {
  const stations = Math.floor(points.length / 3);
  const size = stations * sides * 3;
  const out = into && into.centres.length >= size && into.sides === sides
    ? into
    : { centres: new Float32Array(size), normals: new Float32Array(size), stations, sides };
  out.stations = stations;
  let ax = 0, ay = 0, az = 0; // direction that is transported along the line
  for (let i = 0; i < stations; ++i) {
    const p = Math.max(0, i - 1) * 3;
    const q = Math.min(stations - 1, i + 1) * 3;
    let tx = points[q]! - points[p]!, ty = points[q + 1]! - points[p + 1]!, tz = points[q + 2]! - points[p + 2]!;
    const length = Math.hypot(tx, ty, tz) || 1;
    tx /= length; ty /= length; tz /= length;
    if (i === 0) {
      // any direction across the first tangent
      if (Math.abs(tz) < 0.9) { ax = -tz * tx; ay = -tz * ty; az = 1 - tz * tz; } else { ax = 1 - tx * tx; ay = -tx * ty; az = -tx * tz; }
    } else {
      const along = ax * tx + ay * ty + az * tz;
      ax -= along * tx; ay -= along * ty; az -= along * tz;
    }
    const size_a = Math.hypot(ax, ay, az) || 1;
    ax /= size_a; ay /= size_a; az /= size_a;
    const bx = ty * az - tz * ay, by = tz * ax - tx * az, bz = tx * ay - ty * ax;
    for (let j = 0; j < sides; ++j) {
      const angle = (2 * Math.PI * j) / sides;
      const c = Math.cos(angle), s = Math.sin(angle);
      const k = (i * sides + j) * 3;
      for (let m = 0; m < 3; ++m) out.centres[k + m] = points[3 * i + m]!;
      out.normals[k] = c * ax + s * bx;
      out.normals[k + 1] = c * ay + s * by;
      out.normals[k + 2] = c * az + s * bz;
    }
  }
  return out;
}
