// Views of the picture: those available for a model, and the key of each; 3-D views and plane drawings.
import type { Lay } from '../api/types';

export const layViews = ['whole', 'overbend', 'stinger', 'sagbend', 'touchdown', 'from the pipe'] as const;
export type ViewName = (typeof layViews)[number] | 'vessel' | 'moorings' | 'lines';
export const drawingNames = ['side', 'section', 'plan'] as const;
export type DrawingName = (typeof drawingNames)[number];

/** True if lines or thrusters hold the vessel. */
export const onLines = (s: Lay): boolean => (s.moorings?.rest.moorings.length ?? 0) > 0;

/** 3-D views with content for the model; those of a lay before it is known. */
export function availableViews(s: Lay | null): ViewName[] {
  if (!s) return [...layViews];
  const stinger = s.supports?.some((b) => b.structure === 'stinger') ?? true;
  const laid: ViewName[] = s.pipe.s.length ? layViews.filter((name) => name !== 'stinger' || stinger) : s.moorings ? ['vessel'] : [];
  return [...laid, ...(onLines(s) ? ['moorings' as const] : []), ...(s.lines.length ? ['lines' as const] : [])];
}

/** A section needs a pipe; elevation and plan are always available. */
export function availableDrawings(s: Lay | null): DrawingName[] {
  if (!s || s.pipe.s.length) return [...drawingNames];
  return s.moorings || s.lines.length ? ['side', 'plan'] : [];
}

type Keyed<N> = [N, string];
export const shownViews = (s: Lay | null): Keyed<ViewName>[] => availableViews(s).map((name, i) => [name, String(i + 1)]);

/** After the views of the 3-D picture, as long as there are digits. */
export function shownDrawings(s: Lay | null): Keyed<DrawingName>[] {
  const before = availableViews(s).length;
  return availableDrawings(s).map((name, i) => [name, before + i < 9 ? String(before + i + 1) : '']);
}

/** Initial view. */
export const firstView = (s: Lay): ViewName => (s.pipe.s.length ? 'whole' : onLines(s) ? 'moorings' : s.moorings ? 'vessel' : 'lines');
