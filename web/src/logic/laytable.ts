// What a lay table asks for and how its curves are drawn; the program makes the table.
import type { LayTableCurves, LayTableVary } from '../api/types';

export interface LayTableWish { vary: LayTableVary; from: string; to: string; steps: string }

const number = (text: string): number | null => { const value = Number.parseFloat(text); return Number.isFinite(value) ? value : null; };

/** "200 kN..400 kN/20", as the program takes it. */
export const rangeOf = (wish: LayTableWish): string => `${wish.from.trim()}..${wish.to.trim()}/${wish.steps.trim()}`;

export function wishFault(wish: LayTableWish): string | null {
  const steps = Number(wish.steps);
  if (number(wish.from) === null || number(wish.to) === null) return 'from and to are numbers with their units';
  if (!/[a-zA-Z]/.test(wish.to)) return 'the unit is missing: 400 kN, 120 m';
  return Number.isInteger(steps) && steps >= 1 && steps <= 1000 ? null : 'steps are a whole number from 1 to 1000';
}

/** What a table over it usually covers, from the lay that is shown: SI values. */
export function usualRange(vary: LayTableVary, lay: { top_tension: number; lay_back: number } | null, depth: number | null): LayTableWish {
  const span = (value: number | null | undefined, less: number, more: number, unit: string, factor: number): [string, string] =>
    (value ? [`${Number((less * value * factor).toPrecision(3))} ${unit}`, `${Number((more * value * factor).toPrecision(3))} ${unit}`] : ['', '']);
  const [from, to] = vary === 'tension' ? span(lay?.top_tension, 0.8, 1.6, 'kN', 1e-3) : vary === 'lay_back' ? span(lay?.lay_back, 0.9, 1.2, 'm', 1) : span(depth, 0.8, 1.2, 'm', 1);
  return { vary, from, to, steps: '16' };
}

/** Bounds of a panel, a little wider than its curves. */
export function bounds(panel: LayTableCurves['panels'][number]): { x: [number, number]; y: [number, number] } {
  const points = panel.series.flatMap((s) => s.points);
  const xs = points.map((p) => p[0]), ys = points.map((p) => p[1]).concat(panel.limit === null ? [] : [panel.limit]);
  const [y0, y1] = [Math.min(...ys), Math.max(...ys)], room = 0.08 * (y1 - y0) || 0.08 * Math.abs(y1) || 1;
  const [x0, x1] = [Math.min(...xs), Math.max(...xs)];
  return { x: x0 === x1 ? [x0 - 0.5, x1 + 0.5] : [x0, x1], y: [y0 >= 0 ? Math.max(0, y0 - room) : y0 - room, y1 + room] };
}
