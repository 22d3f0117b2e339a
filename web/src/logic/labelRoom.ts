// Free position for an upright name in a diagram, clear of the curves.

/** In px downwards. `curves`: their extent next to the name, null if there are none. Null if the name does not fit. */
export function upright(length: number, plot: { top: number; bottom: number }, curves: [number, number] | null): 'low' | 'high' | null {
  if (plot.bottom - plot.top < length) return null;
  if (!curves || curves[1] < plot.bottom - length) return 'low';
  return curves[0] > plot.top + length ? 'high' : null;
}
