// The views of the picture: which of them a model has, and the key of each. Those of the 3-D view, and drawings in a plane.
import type { Lay } from '../api/types';

export const layViews = ['whole', 'overbend', 'stinger', 'sagbend', 'touchdown', 'from the pipe'] as const;
export type ViewName = (typeof layViews)[number] | 'vessel' | 'moorings' | 'lines';
export const drawingNames = ['side', 'section', 'plan'] as const;
export type DrawingName = (typeof drawingNames)[number];

/** Whether lines hold the vessel; thrusters alone may as well. */
export const onLines = (s: Lay): boolean => (s.moorings?.rest.moorings.length ?? 0) > 0;

/** Those that show something of a model; of a lay before it is known. */
export function viewsOf(s: Lay | null): ViewName[] {
  if (!s) return [...layViews];
  const stinger = s.supports?.some((b) => b.structure === 'stinger') ?? true;
  const laid: ViewName[] = s.pipe.s.length ? layViews.filter((name) => name !== 'stinger' || stinger) : s.moorings ? ['vessel'] : [];
  return [...laid, ...(onLines(s) ? ['moorings' as const] : []), ...(s.lines.length ? ['lines' as const] : [])];
}

/** A section needs a pipe; side and plan are there for whatever is drawn. */
export function drawingsOf(s: Lay | null): DrawingName[] {
  if (!s || s.pipe.s.length) return [...drawingNames];
  return s.moorings || s.lines.length ? ['side', 'plan'] : [];
}

type Keyed<N> = [N, string];
export const shownViews = (s: Lay | null): Keyed<ViewName>[] => viewsOf(s).map((name, i) => [name, String(i + 1)]);

/** After the views of the 3-D picture, as far as there are digits. */
export function shownDrawings(s: Lay | null): Keyed<DrawingName>[] {
  const before = viewsOf(s).length;
  return drawingsOf(s).map((name, i) => [name, before + i < 9 ? String(before + i + 1) : '']);
}

/** What is looked at first. */
export const firstView = (s: Lay): ViewName => (s.pipe.s.length ? 'whole' : onLines(s) ? 'moorings' : s.moorings ? 'vessel' : 'lines');
