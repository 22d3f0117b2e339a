// Thinning of series to what a screen can show: the least and greatest value per stretch.

export interface Envelope { t: number[]; min: number[]; max: number[] }

/** At most `pixels` points; a series that is short enough comes back as it is. */
export function decimate(t: ArrayLike<number>, v: ArrayLike<number>, pixels: number): Envelope {
  const n = t.length;
  const out: Envelope = { t: [], min: [], max: [] };
  if (n <= pixels || pixels < 1) {
    for (let i = 0; i < n; ++i) { out.t.push(t[i]!); out.min.push(v[i]!); out.max.push(v[i]!); }
    return out;
  }
  for (let p = 0; p < pixels; ++p) {
    const first = Math.floor((p * n) / pixels);
    const last = Math.max(first + 1, Math.floor(((p + 1) * n) / pixels));
    let low = Infinity;
    let high = -Infinity;
    for (let i = first; i < last; ++i) { low = Math.min(low, v[i]!); high = Math.max(high, v[i]!); }
    out.t.push((t[first]! + t[last - 1]!) / 2);
    out.min.push(low);
    out.max.push(high);
  }
  return out;
}

/** Index of the last entry of an ascending list that is not above `x`; 0 before the first. */
export function indexBefore(list: ArrayLike<number>, x: number): number {
  let low = 0;
  let high = list.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (list[middle]! <= x) low = middle; else high = middle - 1;
  }
  return Math.max(0, low);
}

export function nearest(list: ArrayLike<number>, x: number): number {
  const i = indexBefore(list, x);
  return i + 1 < list.length && list[i + 1]! - x < x - list[i]! ? i + 1 : i;
}

/** Linear interpolation of y(x) at ascending places; null outside, so that a diagram shows a gap and no guess. */
export function resample(x: ArrayLike<number>, y: ArrayLike<number>, at: ArrayLike<number>): (number | null)[] {
  return Array.from(at, (place) => {
    if (x.length === 0 || place < x[0]! || place > x[x.length - 1]!) return null;
    const i = Math.min(indexBefore(x, place), x.length - 2);
    if (i < 0) return y[0]!;
    const f = (place - x[i]!) / (x[i + 1]! - x[i]! || 1);
    return y[i]! * (1 - f) + y[i + 1]! * f;
  });
}
