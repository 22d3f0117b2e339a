// Visible part of the elevation: fitted to all, to the boxes or to touchdown, or set by the user.
import { computed, signal } from '@preact/signals';
import type { Elevation } from '../../../logic/elevation';
import { wholeEnd, hullCorner } from '../../../components/lay';
import { around, type Window } from '../../../logic/sideFrame';

export type Fit = 'whole' | 'boxes' | 'touchdown';
export const fit = signal<Fit>('whole');
export const trueScale = signal(true);
/** Zoomed or panned by the user; null: fitted. */
export const userWindow = signal<Window | null>(null);
export const fitted = computed(() => userWindow.value === null);

type Place = [number, number];

function hullPlaces({ lay, hull }: Elevation): Place[] {
  if (!hull) return [];
  return [-1, 1].flatMap((along) => [-1, 1].map((up): Place => { const p = hullCorner(lay, along, 0, up, hull.lower, hull.upper); return [p[0], p[2]]; }));
}

function pipePlaces({ lay: { stations } }: Elevation, from: number, to: number): Place[] {
  return stations.s.flatMap((s, i): Place[] => (s >= from && s <= to ? [[stations.x[i]!, stations.z[i]!]] : []));
}

const boxPlaces = ({ lay: { supports } }: Elevation): Place[] =>
  supports.flatMap(({ p, length }): Place[] => [[p[0] - 0.7 * length, p[2] - 2.5], [p[0] + 0.7 * length, p[2] + 2.5]]);

/** Fits available for a model. */
export function availableFits(side: Elevation): Fit[] {
  const laid = side.lay.stations.s.length > 0;
  return ['whole', ...(side.lay.supports.length ? ['boxes' as const] : []), ...(laid ? ['touchdown' as const] : [])];
}

export function fittedPart(side: Elevation, name: Fit): Window {
  const { lay } = side, laid = lay.stations.s.length > 0, touch = lay.touchdown.s;
  if (name === 'boxes' && lay.supports.length) return around([...boxPlaces(side), ...(lay.supports.length ? [[lay.tensioner[0], lay.tensioner[2]] as Place] : [])]);
  if (name === 'touchdown' && laid) return around(pipePlaces(side, touch - 60, touch + 30));
  const pipe = laid ? pipePlaces(side, 0, wholeEnd(lay)) : [], lines = side.lines.filter((line) => !laid || !line.moored).flatMap((line) => line.points);
  const below: Place[] = [...pipe, ...hullPlaces(side)].map(([x]) => [x, side.bed(x)]);
  return around([...pipe, ...hullPlaces(side), ...boxPlaces(side), ...lines, ...below]);
}
