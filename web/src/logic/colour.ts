// Colours of the picture: the scale of what is shown along the pipe, with its limit, and that of the rollers' loads.
import { mixShares, readHex, type Rgb, type ValueScale } from '../components/colourScale';
import type { Lay } from '../api/types';

/** Loads of rollers, from little to much: browns, of which the scale of the pipe has none. */
const loadAnchors = ['#fff1dc', '#f7b96b', '#d9791e', '#8a4a0c', '#4d2806'] as const;
const loadList = loadAnchors.map((hex) => readHex(hex).map((v) => v / 255) as Rgb);

/** Colour of a load from 0 to 1 of the largest, as three numbers from 0 to 1 written into `out`. */
export const loadShares = (t: number, out: Rgb = [0, 0, 0]): Rgb => mixShares(loadList, t, out);

export const loadCss = `linear-gradient(to right, ${loadAnchors.join(', ')})`;

/** A range with round ends for a legend, so that it does not flicker while a value is dragged. */
export function niceRange(low: number, high: number): [number, number] {
  if (!(high > low)) return [low - 0.5, low + 0.5];
  const step = 10 ** Math.floor(Math.log10((high - low) / 2));
  const part = (high - low) / step > 10 ? 2 * step : step;
  return [Math.floor(low / part) * part, Math.ceil(high / part) * part];
}

/** A limit of a quantity along the pipe, in its SI unit, and its name in the legend. */
export interface Limit { value: number; name: string }

/** Utilisations have the limit 1, stresses the yield stress, where the model has it. */
export function quantityLimit(key: string, lay: Lay | null): Limit | null {
  if (key === 'utilisation') return { value: 1, name: 'yield' };
  if (key === 'checks') return { value: 1, name: 'allowable' };
  if (key !== 'von_mises' && key !== 'bending_stress') return null;
  const region = lay?.key?.overbend ?? lay?.key?.tower ?? lay?.key?.sagbend;
  return region && region.utilisation > 0 ? { value: region.von_mises / region.utilisation, name: 'yield' } : null;
}

/** Share of the limit from which on the scale ends there; what is far below it would all look alike. */
const nearLimit = 0.5;

/** Scale for a range of values in shown units: to the limit where the values come near it, beyond it in reds where they exceed it. */
export function pictureScale(low: number, high: number, limit: number | null): ValueScale {
  const [from, to] = niceRange(low, high);
  if (limit === null || high < nearLimit * limit) return { low: from, top: to, high: to };
  return { low: Math.min(from, 0), top: limit, high: high > limit ? Math.max(to, 1.05 * limit) : limit };
}
