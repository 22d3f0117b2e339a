// Visible part of the elevation, and its scales. The bow is on the right, as in the 3-D view.

export interface Window { x0: number; x1: number; z0: number; z1: number }
export interface Size { width: number; height: number }

/** Margins for axis numbers, buttons and caption [px]. */
const edge = { left: 52, right: 18, top: 46, bottom: 56 };
const legendWidth = 205;
const mostExaggerated = 20;

/** In a flat picture the legend is next to the drawing, in a tall one above it. */
const sideLegendWidth = ({ width, height }: Size): number => (height < 430 && width > 640 ? legendWidth : 0);

export const plotSize = (size: Size): Size => ({
  width: Math.max(40, size.width - edge.left - edge.right - sideLegendWidth(size)),
  height: Math.max(40, size.height - edge.top - edge.bottom),
});
export const plotEdges = (size: Size) => {
  const plot = plotSize(size);
  return { left: edge.left, right: edge.left + plot.width, top: edge.top, bottom: edge.top + plot.height };
};

/** Vertical exaggeration: 1 is true to scale. */
export const exaggeration = (shown: Window, plot: Size): number => (plot.height / (shown.z1 - shown.z0)) / (plot.width / (shown.x1 - shown.x0));

/** `below`: fraction of the added height that is added below. */
function widen(low: number, high: number, wanted: number, below = 0.5): [number, number] {
  const more = Math.max(0, wanted - (high - low));
  return [low - below * more, high + (1 - below) * more];
}

const belowSeabed = 0.3; // room for names above

/** All of `seen`: true to scale, or with exaggerated heights, at most twenty times. */
export function fitWindow(seen: Window, plot: Size, trueScale: boolean): Window {
  const margin = 0.03 * Math.max(seen.x1 - seen.x0, 1);
  let [x0, x1] = [seen.x0 - margin, seen.x1 + margin];
  const rise = Math.max(seen.z1 - seen.z0, 0.01 * (x1 - x0), 0.5);
  let [z0, z1] = [seen.z0 - 0.06 * rise, seen.z1 + 0.1 * rise];
  const current = exaggeration({ x0, x1, z0, z1 }, plot);
  if (current < 1) [x0, x1] = widen(x0, x1, (x1 - x0) / current);
  else if (trueScale) [z0, z1] = widen(z0, z1, (z1 - z0) * current, belowSeabed);
  else if (current > mostExaggerated) [z0, z1] = widen(z0, z1, ((z1 - z0) * current) / mostExaggerated, belowSeabed);
  return { x0, x1, z0, z1 };
}

/** Zooms in (factor below 1) or out, about a point. */
export function zoomWindow(w: Window, x: number, z: number, factor: number): Window {
  return { x0: x + (w.x0 - x) * factor, x1: x + (w.x1 - x) * factor, z0: z + (w.z0 - z) * factor, z1: z + (w.z1 - z) * factor };
}

export const shiftWindow = (w: Window, dx: number, dz: number): Window => ({ x0: w.x0 + dx, x1: w.x1 + dx, z0: w.z0 + dz, z1: w.z1 + dz });

/** Bounding box of points, each [x, z]. */
export function around(places: readonly (readonly [number, number])[]): Window {
  const w: Window = { x0: Infinity, x1: -Infinity, z0: Infinity, z1: -Infinity };
  for (const [x, z] of places) { w.x0 = Math.min(w.x0, x); w.x1 = Math.max(w.x1, x); w.z0 = Math.min(w.z0, z); w.z1 = Math.max(w.z1, z); }
  return w.x0 > w.x1 ? { x0: -10, x1: 10, z0: -5, z1: 5 } : w;
}

export const scaleText = (factor: number): string => (Math.abs(factor - 1) < 0.02 ? 'true to scale' : `heights × ${factor < 10 ? factor.toFixed(1) : Math.round(factor)}`);
