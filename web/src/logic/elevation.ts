// The elevation for figures: static results, scene and an instant of a run in ship axes.
import type { LayData, RollerData, RowData, SupportData } from '../components/lay';
import type { Lay, MooredState, Roller, Scene, Support, Vector } from '../api/types';
import { bedHeight } from './bed';
import { carried } from './moorings';
import { nearest } from './series';
import { shipAxes, toShip, toWorld, turnToShip, type ShipAxes } from './shipAxes';

/** An instant of a run: vessel pose, positions of pipe stations and line points, reactions of the boxes. */
export interface DrawnMoment { pose: number[]; places: ArrayLike<number>; lines: ReadonlyMap<string, ArrayLike<number>> | null; reactions: ReadonlyMap<string, number> }

export interface SideLine { name: string; points: [number, number][]; parted: boolean; moored: boolean }

export interface Elevation {
  axes: ShipAxes;
  lay: LayData;
  lines: SideLine[];
  bed: (astern: number) => number;
  hull: { lower: number; upper: number } | null;
}

const triples = (list: ArrayLike<number>): Vector[] => Array.from({ length: Math.floor(list.length / 3) }, (_, i) => [list[3 * i]!, list[3 * i + 1]!, list[3 * i + 2]!]);

/** During a change of run, an instant may belong to a line with other stations. */
const belongs = (moment: DrawnMoment | null, lay: Lay): boolean => moment?.places.length === 3 * lay.pipe.s.length;

/** Positions of the stations in world axes. */
export const pipePlaces = (lay: Lay, moment: DrawnMoment | null): Vector[] =>
  (moment && belongs(moment, lay) ? triples(moment.places) : lay.pipe.s.map((_, i): Vector => [lay.pipe.x[i]!, lay.pipe.y[i]!, lay.pipe.z[i]!]));

/** Rows of a box: each begins with its bottom roller. */
export function rollerRows(support: Support): Roller[][] {
  const rows: Roller[][] = [];
  for (const roller of support.rollers) {
    if (roller.position === 'bottom' || rows.length === 0) rows.push([]);
    rows.at(-1)!.push(roller);
  }
  return rows;
}

const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** From the centre of a roller to the pipe, perpendicular to the roller axis. */
function rollerNormal(center: Vector, axis: Vector, pipe: Vector): Vector {
  const away = minus(pipe, center), along = dot(away, axis);
  const across: Vector = [away[0] - along * axis[0], 0, away[2] - along * axis[2]], size = Math.hypot(...across);
  return size > 1e-9 ? [across[0] / size, 0, across[2] / size] : [0, 0, 1];
}

/** `astern`: x of the stations, ascending except for round-off. */
interface Placing { axes: ShipAxes; move: (p: Vector) => Vector; pipe: Vector[]; astern: number[]; reactions: ReadonlyMap<string, number> | null }

function rollerData(roller: Roller, support: Support, on: Placing): RollerData {
  const center = toShip(on.axes, on.move(roller.center));
  const axis = turnToShip(on.axes, roller.axis);
  const near = on.pipe[nearest(on.astern, center[0])] ?? center;
  const normal = rollerNormal(center, axis, near);
  const known = on.reactions?.get(support.name);
  const reaction = on.reactions ? (roller.position === 'bottom' ? known ?? 0 : 0) : roller.reaction;
  const p: Vector = [center[0] + roller.radius * normal[0], center[1], center[2] + roller.radius * normal[2]];
  return { position: roller.position, p, axis, normal, radius: roller.radius, face: roller.face, reaction, separation: roller.separation, passed: false };
}

function supportData(support: Support, scene: Scene, on: Placing): SupportData {
  const fixedBox = [...scene.ramp, ...scene.stinger].find((box) => box.name === support.name);
  const direction = fixedBox ? turnToShip(on.axes, fixedBox.direction) : [1, 0, 0] as const;
  const rows = rollerRows(support).map((rollers): RowData => {
    const data = rollers.map((roller) => rollerData(roller, support, on));
    return { p: data[0]!.p, reaction: data.reduce((sum, r) => sum + r.reaction, 0), rollers: data };
  });
  return {
    name: support.name, stinger: support.structure === 'stinger', s: support.s, p: toShip(on.axes, on.move(support.place)),
    length: fixedBox?.length || 1, inclination: Math.atan2(-direction[2], direction[0]), rows,
  };
}

function vesselData(scene: Scene, axes: ShipAxes, pose: number[] | undefined): LayData['vessel'] {
  const { vessel } = scene;
  if (!vessel || !pose) return { name: '', length: 0, beam: 0, depth: 0, draught: 0, origin: [0, 0, 0], axes: [[-1, 0, 0], [0, 1, 0], [0, 0, 1]] };
  const column = (k: number): Vector => turnToShip(axes, [pose[3 + k]!, pose[6 + k]!, pose[9 + k]!]);
  return {
    name: vessel.name, length: vessel.length, beam: vessel.beam, depth: vessel.height, draught: vessel.draught,
    origin: toShip(axes, pose), axes: [column(0), column(1), column(2)],
  };
}

function sideLines(lay: Lay, state: MooredState | null, axes: ShipAxes, moment: DrawnMoment | null): SideLine[] {
  const seen = (points: readonly ArrayLike<number>[]): [number, number][] => points.map((p) => { const q = toShip(axes, p); return [q[0], q[2]]; });
  const places = (name: string, fixed: Vector[]): readonly ArrayLike<number>[] => { const recorded = moment?.lines?.get(name); return recorded ? triples(recorded) : fixed; };
  return [
    ...(state?.moorings ?? []).map((l) => ({ name: l.name, points: seen(places(l.name, l.shape.length > 1 ? l.shape : [l.fairlead, l.anchor])), parted: l.parted, moored: true })),
    ...lay.lines.map((l) => ({ name: l.name, points: seen(places(l.name, l.shape)), parted: false, moored: false })),
  ];
}

/** `scene`: with the vessel at its static pose; `state`: moored state that is shown. */
export function elevation(lay: Lay, scene: Scene, state: MooredState | null, shown: DrawnMoment | null, steel: number | null): Elevation {
  const moment = belongs(shown, lay) ? shown : null;
  const axes = shipAxes(scene, lay);
  const pose = scene.vessel?.pose;
  const move = (p: Vector): Vector => (moment && pose ? carried(pose, moment.pose, p) : p);
  const pipe = pipePlaces(lay, moment).map((p) => toShip(axes, p));
  const column = (k: 0 | 1 | 2): number[] => pipe.map((p) => p[k]);
  const on: Placing = { axes, move, pipe, astern: column(0), reactions: moment?.reactions ?? null };
  const diameter = 2 * scene.pipe.outer_radius;
  const touch = lay.touchdown;
  const data: LayData = {
    stations: { s: lay.pipe.s, x: on.astern, y: column(1), z: column(2), von_mises: [], yield_stress: [] },
    supports: lay.supports.map((support) => supportData(support, scene, on)),
    vessel: vesselData(scene, axes, moment?.pose ?? pose),
    tensioner: lay.tensioner ? toShip(axes, move(lay.tensioner.place)) : [0, 0, 0],
    touchdown: touch ? { s: touch.s, p: toShip(axes, touch.place) } : { s: lay.pipe.s.at(-1) ?? 0, p: pipe.at(-1) ?? [0, 0, 0] },
    water_depth: scene.water_depth, pipe_outer_diameter: diameter, steel_outer_diameter: steel ?? 0.9 * diameter,
  };
  const { vessel } = scene;
  return {
    axes, lay: data, lines: sideLines(lay, state, axes, moment),
    bed: (astern) => { const p = toWorld(axes, [astern, 0, 0]); return bedHeight(scene.seabed, p[0], p[1]); },
    hull: vessel ? { lower: -vessel.draught, upper: vessel.height - vessel.draught } : null,
  };
}
