// The lay for figures: stations, boxes, hull and seabed in ship axes (astern, port, up), with heights above the water.
import { interpolate } from './chart/scale';
import type { Vector } from './painter';

/** Columns from the tensioner to the anchor, in SI; `s` is the arc length from the tensioner. */
export type Stations = Record<string, number[]> & Record<'s' | 'x' | 'y' | 'z' | 'von_mises' | 'yield_stress', number[]>;

export type Position = 'bottom' | 'port' | 'starboard';

export interface RollerData {
  position: Position;
  p: Vector;
  axis: Vector;
  normal: Vector;
  radius: number;
  face: number;
  reaction: number;
  separation: number;
  /** The pipe has left it beyond its end. */
  passed: boolean;
}

export interface RowData { p: Vector; reaction: number; rollers: RollerData[] }

export interface SupportData {
  name: string;
  stinger: boolean;
  s: number;
  p: Vector;
  length: number;
  inclination: number;
  rows: RowData[];
}

export interface VesselData {
  name: string;
  length: number;
  beam: number;
  depth: number;
  draught: number;
  origin: Vector;
  axes: [Vector, Vector, Vector];
}

export interface LayData {
  stations: Stations;
  supports: SupportData[];
  vessel: VesselData;
  tensioner: Vector;
  touchdown: { s: number; p: Vector };
  water_depth: number;
  pipe_outer_diameter: number;
  steel_outer_diameter: number;
  /** Profile of an uneven seabed. */
  bed?: { heights: { x: number; z: number }[]; spans: { s_to: number; largest_gap: number }[] };
}

/** End slightly beyond the last box, so that the pipe is seen leaving it. */
export function overbendEnd({ stations, supports }: LayData): number {
  const reach = Math.max(...supports.map((box) => box.s + box.length / 2));
  return Math.min(stations.s.at(-1)!, reach + Math.max(5, 0.12 * reach));
}

/** End of the shown part of the laid pipe, with its free spans; beyond it nothing changes. */
export function wholeEnd({ stations, touchdown, bed }: LayData): number {
  const last = (bed?.spans ?? []).filter((span) => span.largest_gap > 0.05).at(-1);
  const spanned = last ? last.s_to + 20 - touchdown.s : 0;
  return Math.min(stations.s.at(-1)!, touchdown.s + Math.max(30, 0.15 * touchdown.s, spanned));
}

/** Number of stations up to an arc length. */
export function stationsUpTo({ stations }: LayData, end: number): number[] {
  return [...stations.s.keys()].filter((i) => stations.s[i]! <= end + 1e-9);
}

/** Linear interpolation between stations. */
export const stationValue = ({ stations }: LayData, column: string, s: number): number => interpolate(stations.s, stations[column]!, s);

export const stationPoint = ({ stations }: LayData, i: number): Vector => [stations.x[i]!, stations.y[i]!, stations.z[i]!];

export const pipePoint = (lay: LayData, s: number): Vector => [stationValue(lay, 'x', s), stationValue(lay, 'y', s), stationValue(lay, 'z', s)];

/** Corner of the hull between two heights; signs: length (aft, fore), beam (starboard, port), height (lower, upper). */
export function hullCorner({ vessel }: LayData, along: number, across: number, up: number, lower: number, upper: number): Vector {
  const local = [along * vessel.length / 2, across * vessel.beam / 2, up < 0 ? lower : upper];
  const value = (k: 0 | 1 | 2): number => vessel.origin[k] + local.reduce((sum, v, i) => sum + v * vessel.axes[i]![k], 0);
  return [value(0), value(1), value(2)];
}

/** Heights of keel and deck above the water at midship. */
export const hullHeights = ({ vessel }: LayData): [number, number] => [-vessel.draught, vessel.depth - vessel.draught];

/** The two limits, and the known seabed points between them. */
export function seabedPlaces({ bed }: LayData, x0: number, x1: number): number[] {
  return [x0, ...(bed?.heights ?? []).map((height) => height.x).filter((x) => x > x0 && x < x1), x1];
}

/** Seabed height: interpolated on an uneven seabed, otherwise the plane through stern shoe and touchdown. */
export function seabedHeight(lay: LayData, x: number): number {
  if (lay.bed) {
    const { heights } = lay.bed;
    return interpolate(heights.map((height) => height.x), heights.map((height) => height.z), x);
  }
  const touch = lay.touchdown.p;
  const [z0, z1] = [-lay.water_depth, touch[2] - lay.pipe_outer_diameter / 2];
  return Math.abs(touch[0]) < 1 ? z0 : z0 + (z1 - z0) * x / touch[0];
}

/** A point below a box, along its inclination, for the schematic structure. */
export function belowBox(box: SupportData, along: number, down: number): Vector {
  const [c, s] = [Math.cos(box.inclination), Math.sin(box.inclination)];
  return [box.p[0] + along * c - down * s, box.p[1], box.p[2] - along * s - down * c];
}

/** Boxes of the ramp and of the stinger, if there are any. */
export function structures(boxes: SupportData[]): SupportData[][] {
  return [boxes.filter((box) => !box.stinger), boxes.filter((box) => box.stinger)].filter((list) => list.length > 0);
}
