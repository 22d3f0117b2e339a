// Colouring of the picture: values, scale and limit, shared by the 3-D view, the drawings and the legend.
import { pictureScale, quantityLimit } from '../../logic/colour';
import type { ValueScale } from '../../components/colourScale';
import { quantity, type Shown } from '../../logic/show';
import type { Lay } from '../../api/types';
import { shown as frame } from '../../state/animation';
import { colourBy, type ColourBy } from '../../state/look';
import { envelopes } from '../../state/runs';

/** Quantities stored in the frames of a run. */
export const inFrames = (key: ColourBy): boolean => key === 'effective_tension' || key === 'von_mises';
export const colouredBy = (animated: boolean): ColourBy => (animated && !inFrames(colourBy.value) ? 'von_mises' : colourBy.value);

export interface Colours { key: ColourBy; shown: Shown; scale: ValueScale; limit: { value: number; name: string } | null }

/** In the shown unit; over the whole run if there is one, so that the scale is constant from frame to frame. */
export function pipeColours(lay: Lay | null, animated: boolean): Colours {
  const key = colouredBy(animated), shown = quantity(key)!;
  const band = key === 'utilisation' || key === 'checks' ? null : envelopes.value?.[key];
  const list = animated && band?.max ? [...band.max, ...(band.min ?? [])] : (lay?.pipe[key] as number[] | undefined) ?? [];
  let low = Infinity, high = -Infinity;
  for (const v of list) { low = Math.min(low, v); high = Math.max(high, v); }
  if (low > high) [low, high] = [0, 1 / shown.factor];
  const limit = quantityLimit(key, lay);
  const shownLimit = limit && { ...limit, value: limit.value * shown.factor };
  return { key, shown, limit: shownLimit, scale: pictureScale((key === 'effective_tension' ? low : 0) * shown.factor, high * shown.factor, shownLimit?.value ?? null) };
}

/** Scale for values in SI. */
export function inSi({ low, top, high }: ValueScale, { factor }: Shown): ValueScale {
  return { low: low / factor, top: top / factor, high: high / factor };
}

/** Values along the pipe; null if unknown. */
export function colourValues(lay: Lay, key: ColourBy): ArrayLike<number> | null {
  const f = frame.value;
  if (f) return key === 'effective_tension' ? f.effective_tension : f.von_mises;
  return (lay.pipe[key] as number[] | undefined) ?? null;
}
