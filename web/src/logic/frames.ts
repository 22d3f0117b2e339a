// Frames of an animation from the program: base64 of little-endian float32.

export interface FramesAnswer {
  total: number; from: number; stations: number; time: number[]; pose: number[][];
  place: string; effective_tension: string; von_mises: string;
  /** Lines with their number of points, and the positions of all points: mooring lines from fairlead to anchor, others from their first end. */
  lines?: FrameLine[]; line_place?: string;
}

export interface FrameLine { name: string; points: number }

export interface Chunk {
  from: number; count: number; stations: number; time: number[]; pose: number[][];
  place: Float32Array; effective_tension: Float32Array; von_mises: Float32Array;
  lines: FrameLine[]; linePlace: Float32Array;
}

export function floats(base64: string): Float32Array {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  return new Float32Array(bytes.buffer, 0, Math.floor(bytes.byteLength / 4));
}

export function decode(answer: FramesAnswer): Chunk {
  return {
    from: answer.from, count: answer.time.length, stations: answer.stations, time: answer.time, pose: answer.pose,
    place: floats(answer.place), effective_tension: floats(answer.effective_tension), von_mises: floats(answer.von_mises),
    lines: answer.lines ?? [], linePlace: floats(answer.line_place ?? ''),
  };
}

/** Interpolation between two frames: a at 0, b at 1. */
export function blend(a: ArrayLike<number>, aFrom: number, b: ArrayLike<number>, bFrom: number, count: number, f: number, out: Float32Array): Float32Array {
  for (let i = 0; i < count; ++i) out[i] = a[aFrom + i]! * (1 - f) + b[bFrom + i]! * f;
  return out;
}

/** Points of each line between frame `a` of one chunk and frame `b` of another; null if none were recorded. */
export function linesBetween(first: Chunk, a: number, second: Chunk, b: number, f: number): Map<string, Float32Array> | null {
  if (first.lines.length === 0) return null;
  const all = 3 * first.lines.reduce((sum, l) => sum + l.points, 0);
  const out = new Map<string, Float32Array>();
  let offset = 0;
  for (const line of first.lines) {
    out.set(line.name, blend(first.linePlace, a * all + offset, second.linePlace, b * all + offset, 3 * line.points, f, new Float32Array(3 * line.points)));
    offset += 3 * line.points;
  }
  return out;
}
