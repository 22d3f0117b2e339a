// The common colour scale: viridis (van der Walt and Smith 2015), uniform in lightness, suitable for colour-blind readers
// and for grey print. Values above a limit are shown in reds.

/** Values above a limit, outside the colour scale. */
export const aboveLimit = '#e0243c';

export type Rgb = [number, number, number];

/** In steps of a tenth. */
const anchors = ['#440154', '#482475', '#414487', '#355f8d', '#2a788e', '#21918c', '#22a884', '#44bf70', '#7ad151', '#bddf26', '#fde725'];

export function readHex(hex: string): Rgb {
  const n = Number.parseInt(hex.slice(1), 16);
  return [(n >> 16) & 255, (n >> 8) & 255, n & 255];
}

export function writeHex(rgb: Rgb): string {
  return `#${rgb.map((v) => Math.round(Math.min(255, Math.max(0, v))).toString(16).padStart(2, '0')).join('')}`;
}

/** From the smallest to the largest value above a limit. */
const above = ['#f0937c', '#d92b3a', '#8f0b26'];

/** Colour at the fraction `share` of a list of colours, 0 to 1. */
function mixed(list: readonly string[], share: number): string {
  const place = Math.min(1, Math.max(0, Number.isFinite(share) ? share : 0)) * (list.length - 1);
  const first = Math.min(list.length - 2, Math.floor(place));
  const [low, high] = [readHex(list[first]!), readHex(list[first + 1]!)];
  return writeHex([0, 1, 2].map((k) => low[k]! + (high[k]! - low[k]!) * (place - first)) as Rgb);
}

/** Colour of `t` from 0 (dark violet) to 1 (yellow). */
export const viridis = (t: number): string => mixed(anchors, t);

/** Values from 0 to 1 on white paper: light to dark, without the palest yellow. */
export function paperScale(t: number): string {
  return viridis(0.88 - 0.83 * Math.min(1, Math.max(0, t)));
}

/** The same colour, brighter or darker. */
export function shade(hex: string, factor: number): string {
  return writeHex(readHex(hex).map((v) => v * factor) as Rgb);
}

/** viridis from `low` to `top`, reds from there to `high`; if no value exceeds a limit, top and high are the same. */
export interface ValueScale { low: number; top: number; high: number }

/** Utilisations have a limit, other results have none. */
export const resultLimit = (name: string): number | null => (/utilisation/.test(name) ? 1 : null);

/** Scale from the smallest to the largest of the values. */
export function valueScale(values: readonly number[], limit: number | null = null): ValueScale {
  const [low, high] = values.length > 0 ? [Math.min(...values), Math.max(...values)] : [0, 1];
  if (limit !== null && high > limit) return { low: Math.min(low, limit), top: limit, high };
  const half = low === high ? 0.5 * Math.abs(low) || 0.5 : 0;
  return { low: low - half, top: high + half, high: high + half };
}

const shareBetween = (from: number, to: number, value: number): number => (value - from) / (to - from || 1);

export function valueColour({ low, top, high }: ValueScale, value: number): string {
  return value > top ? mixed(above, shareBetween(top, high, value)) : mixed(anchors, shareBetween(low, top, value));
}

const shares = (list: readonly string[]): Rgb[] => list.map((hex) => readHex(hex).map((v) => v / 255) as Rgb);
const [anchorShares, aboveShares] = [shares(anchors), shares(above)];

/** Colour at the fraction `share` of a list of colours, written into `out`; components from 0 to 1. */
export function mixShares(list: readonly Rgb[], share: number, out: Rgb): Rgb {
  const place = Math.min(1, Math.max(0, Number.isFinite(share) ? share : 0)) * (list.length - 1);
  const first = Math.min(list.length - 2, Math.floor(place));
  for (let k = 0; k < 3; ++k) out[k] = list[first]![k]! + (list[first + 1]![k]! - list[first]![k]!) * (place - first);
  return out;
}

/** Colour of a value as three numbers from 0 to 1, written into `out` to avoid allocations while drawing. */
export function valueShares({ low, top, high }: ValueScale, value: number, out: Rgb): Rgb {
  return value > top ? mixShares(aboveShares, shareBetween(top, high, value), out) : mixShares(anchorShares, shareBetween(low, top, value), out);
}

/** CSS background of a legend, from left to right. */
export function gradientCss(scale: ValueScale): string {
  return `linear-gradient(to right, ${gradientStops(scale).map(({ offset, colour }) => `${colour} ${(100 * offset).toFixed(1)}%`).join(', ')})`;
}

/** Colour of marks on the colour of a value. */
export function markColour({ low, top, high }: ValueScale, value: number): string {
  const dark = value > top ? shareBetween(top, high, value) > 0.25 : shareBetween(low, top, value) < 0.55;
  return dark ? '#fff' : '#1b2733';
}

/** Stops of a gradient along the scale. */
export function gradientStops({ low, top, high }: ValueScale): { offset: number; colour: string }[] {
  const part = shareBetween(low, high, top);
  const stops = (list: readonly string[], from: number, to: number) =>
    list.map((colour, k) => ({ offset: from + (to - from) * k / (list.length - 1), colour }));
  return [...(part > 0 ? stops(anchors, 0, part) : []), ...(part < 1 ? stops(above, part, 1) : [])];
}
