// A moored vessel for figures, in world axes: x east, y north, z above the water.
import type { Vector } from './painter';

export interface MooringLineData {
  name: string;
  /** Tension at the fairlead. */
  tension: number;
  slack: boolean;
  parted: boolean;
  /** Length on the seabed. */
  on_bed: number;
  /** Horizontal distance from the fairlead to touchdown. */
  touchdown: number;
  fairlead: Vector;
  anchor: Vector;
  shape: Vector[];
}

/** Offsets of the vessel from its nominal pose. */
export interface MooredState { name: string; surge: number; sway: number; yaw: number; lines: MooringLineData[] }

export interface PullAheadStep {
  advance: number;
  tensions: number[];
  lengths: number[];
  pipe: Record<PipeAtStep, number | null> | null;
}

export type PipeAtStep = 'tension' | 'overbend' | 'sagbend' | 'clearance';

export interface MooringSpread {
  length: number;
  beam: number;
  /** Azimuths clockwise from north. */
  heading: number;
  /** Azimuth of each group of waves. */
  waves_from: number[];
  current_to: number | null;
  pipe: Vector[];
  touchdown: Vector | null;
  objects: { name: string; points: Vector[] }[];
  steps: PullAheadStep[];
  /** The equilibrium, then the stages of an operation. */
  states: MooredState[];
}

export type Place = readonly [number, number];

export const flat = (p: Vector): Place => [p[0], p[1]];

export const distance = (a: Vector, b: Vector): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** Offset of the hull ahead and to port, in world axes. */
export function offsetInWorld({ heading }: MooringSpread, ahead: number, port: number): Place {
  const [s, c] = [Math.sin(heading), Math.cos(heading)];
  return [ahead * s - port * c, ahead * c + port * s];
}

/** Outline of the hull at its pose, with a rounded bow. */
export function hullOutline(spread: MooringSpread, state: MooredState): Place[] {
  const [east, north] = offsetInWorld(spread, state.surge, state.sway);
  const turn = Math.PI / 2 - spread.heading + state.yaw;
  const [l, b] = [spread.length / 2, spread.beam / 2];
  const corners: Place[] = [[-l, -b], [0.8 * l, -b], [l, -0.35 * b], [l, 0.35 * b], [0.8 * l, b], [-l, b]];
  return corners.map(([x, y]) => [east + x * Math.cos(turn) - y * Math.sin(turn), north + x * Math.sin(turn) + y * Math.cos(turn)]);
}

/** Suspended part, from the fairlead, and laid part, from touchdown on. */
export function suspendedAndLaid(line: MooringLineData): [Vector[], Vector[]] {
  const touch = line.shape.findIndex((p) => distance(p, line.fairlead) >= line.touchdown - 0.5);
  return touch < 0 || line.on_bed <= 0 ? [line.shape, []] : [line.shape.slice(0, touch + 1), line.shape.slice(touch)];
}

/** Groups of lines whose profiles coincide within the stroke width. */
export function groupAlike(lines: MooringLineData[]): MooringLineData[][] {
  const reach = (line: MooringLineData): number => distance(line.anchor, line.fairlead);
  const groups: MooringLineData[][] = [];
  for (const line of lines) {
    const same = groups.find(([first]) => Math.abs(first!.touchdown - line.touchdown) < 0.5 && Math.abs(reach(first!) - reach(line)) < 0.5);
    if (same) same.push(line); else groups.push([line]);
  }
  return groups;
}

export const lineColours = { suspended: '#00785a', laid: '#8fcbb6', slack: '#c77700', parted: '#b3261e' };
