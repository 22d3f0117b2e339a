// Colours of the picture: scale of the quantity along the pipe, with its limit, and scale of roller loads.
import { mixShares, readHex, type Rgb, type ValueScale } from '../components/colourScale';
import type { Lay } from '../api/types';

/** Colours of roller loads, from low to high: browns, which the scale of the pipe does not contain. */
const loadAnchors = ['#fff1dc', '#f7b96b', '#d9791e', '#8a4a0c', '#4d2806'] as const;
const loadList = loadAnchors.map((hex) => readHex(hex).map((v) => v / 255) as Rgb);

/** Colour of a load from 0 to 1 of the maximum, as three numbers from 0 to 1 written into `out`. */
export const loadShares = (t: number, out: Rgb = [0, 0, 0]): Rgb => mixShares(loadList, t, out);

export const loadCss = `linear-gradient(to right, ${loadAnchors.join(', ')})`;

/** A range with round ends for a legend, so that it does not flicker during a drag. */
export function niceRange(low: number, high: number): [number, number] {
  if (!(high > low)) return [low - 0.5, low + 0.5];
  const step = 10 ** Math.floor(Math.log10((high - low) / 2));
  const part = (high - low) / step > 10 ? 2 * step : step;
  return [Math.floor(low / part) * part, Math.ceil(high / part) * part];
}

/** Limit of a quantity along the pipe, in its SI unit, and its name in the legend. */
export interface Limit { value: number; name: string }

/** Utilisations have the limit 1, stresses the yield stress, if the model gives it. */
export function quantityLimit(key: string, lay: Lay | null): Limit | null {
  if (key === 'utilisation') return { value: 1, name: 'yield' };
  if (key === 'checks') return { value: 1, name: 'allowable' };
  if (key !== 'von_mises' && key !== 'bending_stress') return null;
  const region = lay?.key?.overbend ?? lay?.key?.tower ?? lay?.key?.sagbend;
  return region && region.utilisation > 0 ? { value: region.von_mises / region.utilisation, name: 'yield' } : null;
}

/** Fraction of the limit above which the scale ends at the limit; far below it all colours would look alike. */
const nearLimit = 0.5;

/** Scale for a range of values in shown units: up to the limit if values approach it, with reds beyond it. */
export function pictureScale(low: number, high: number, limit: number | null): ValueScale {
  const [from, to] = niceRange(low, high);
  if (limit === null || high < nearLimit * limit) return { low: from, top: to, high: to };
  return { low: Math.min(from, 0), top: limit, high: high > limit ? Math.max(to, 1.05 * limit) : limit };
}
