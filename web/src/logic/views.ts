// The buttons of the 3-D view: which views a model has, and the key of each.
import type { Lay } from '../api/types';

export const layViews = ['whole', 'overbend', 'stinger', 'sagbend', 'touchdown', 'from the pipe'] as const;
export type ViewName = (typeof layViews)[number] | 'vessel' | 'moorings' | 'lines';

/** Whether lines hold the vessel; thrusters alone may as well. */
export const onLines = (s: Lay): boolean => (s.moorings?.rest.moorings.length ?? 0) > 0;

/** Those that show something of a model; of a lay before it is known. */
export function viewsOf(s: Lay | null): ViewName[] {
  if (!s) return [...layViews];
  const laid: ViewName[] = s.pipe.s.length ? [...layViews] : s.moorings ? ['vessel'] : [];
  return [...laid, ...(onLines(s) ? ['moorings' as const] : []), ...(s.lines.length ? ['lines' as const] : [])];
}

export const shownViews = (s: Lay | null): [ViewName, string][] => viewsOf(s).map((name, i) => [name, String(i + 1)]);

/** What is looked at first. */
export const firstView = (s: Lay): ViewName => (s.pipe.s.length ? 'whole' : onLines(s) ? 'moorings' : s.moorings ? 'vessel' : 'lines');
