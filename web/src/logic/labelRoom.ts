// Where a name that stands upright in a diagram covers none of the curves.

/** In px downwards. `curves`: what they take up beside the name, null without any. Null where the name has no room. */
export function upright(length: number, plot: { top: number; bottom: number }, curves: [number, number] | null): 'low' | 'high' | null {
  if (plot.bottom - plot.top < length) return null;
  if (!curves || curves[1] < plot.bottom - length) return 'low';
  return curves[0] > plot.top + length ? 'high' : null;
}
