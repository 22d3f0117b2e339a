// Hull and mooring lines in equilibrium: offset of the hull, colours of the lines, table of lines.
import type { Cell, Column, RowMark, TableData } from '../components/document';
import { pageUnits } from './show';
import type { Lay, MooredState, MooringLine, Moorings, Scene, Vector, VesselOffset, MooringInTime } from '../api/types';

/** Pose of the hull at an offset from its nominal pose: twelve numbers, as in a scene. */
export function poseAt(drawn: readonly number[], offset: VesselOffset): number[] {
  const heading = Math.atan2(drawn[6]!, drawn[3]!), c = Math.cos(heading), s = Math.sin(heading);
  // nominal heel and trim add to roll and pitch
  const roll = offset.roll + Math.atan2(drawn[10]!, drawn[11]!), pitch = offset.pitch - Math.asin(Math.max(-1, Math.min(1, drawn[9]!)));
  const [cr, sr, cp, sp, cy, sy] = [Math.cos(roll), Math.sin(roll), Math.cos(pitch), Math.sin(pitch), Math.cos(offset.yaw), Math.sin(offset.yaw)];
  // Rz(yaw) Ry(pitch) Rx(roll), about the level axes along the nominal heading
  const turn = [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr, sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr, -sp, cp * sr, cp * cr];
  const out = [drawn[0]! + c * offset.surge - s * offset.sway, drawn[1]! + s * offset.surge + c * offset.sway, drawn[2]! + offset.heave];
  for (let k = 0; k < 3; ++k) out[3 + k] = c * turn[k]! - s * turn[3 + k]!;
  for (let k = 0; k < 3; ++k) out[6 + k] = s * turn[k]! + c * turn[3 + k]!;
  for (let k = 0; k < 3; ++k) out[9 + k] = turn[6 + k]!;
  return out;
}

/** A point that moves with the vessel from one pose to another. */
export function carried(from: readonly number[], to: readonly number[], p: Vector): Vector {
  const d = [p[0] - from[0]!, p[1] - from[1]!, p[2] - from[2]!];
  const local = [0, 1, 2].map((k) => from[3 + k]! * d[0]! + from[6 + k]! * d[1]! + from[9 + k]! * d[2]!);
  return [0, 1, 2].map((k) => to[k]! + to[3 + 3 * k]! * local[0]! + to[4 + 3 * k]! * local[1]! + to[5 + 3 * k]! * local[2]!) as Vector;
}

/** The scene with the vessel and its structures in another pose. */
export function sceneAt(scene: Scene, pose: number[]): Scene {
  if (!scene.vessel) return scene;
  const from = scene.vessel.pose, move = (p: Vector): Vector => carried(from, pose, p);
  const origin = move([0, 0, 0]);
  const along = (d: Vector): Vector => { const end = move(d); return [end[0] - origin[0], end[1] - origin[1], end[2] - origin[2]]; };
  const boxes = (list: Scene['ramp']): Scene['ramp'] => list.map((b) => ({ ...b, place: move(b.place), direction: along(b.direction) }));
  return {
    ...scene, vessel: { ...scene.vessel, pose }, ramp: boxes(scene.ramp), stinger: boxes(scene.stinger),
    stern_shoe: scene.stern_shoe && move(scene.stern_shoe), tensioner: scene.tensioner && move(scene.tensioner),
  };
}

/** The scene with the vessel at its static offset on the moorings. */
export function settled(scene: Scene | null, lay: Lay | null): Scene | null {
  if (!scene?.vessel || !lay?.moorings) return scene;
  return sceneAt(scene, poseAt(scene.vessel.pose, lay.moorings.rest.vessel));
}

/** A stage of the operation by its index from 0, otherwise the equilibrium. */
export const mooredStateAt = (m: Moorings, stage: number): MooredState => m.stages[stage] ?? m.rest;

export type LineLevel = 'good' | 'near' | 'over' | 'unknown' | 'gone';

/** Usual safety factors of an intact mooring spread: static and dynamic (API RP 2SK), of a drag anchor (assumed). The checks use those of the model. */
const usualFactors = { rest: 2, inTime: 1.67, anchor: 1.5 };

/** Colour by tension over breaking load with the usual safety factor; `inTime`: maximum of a run. */
export function lineLevel(line: MooringLine, inTime = false): LineLevel {
  if (line.parted) return 'gone';
  if (line.utilisation === null && line.anchor_utilisation === null) return 'unknown';
  const factor = inTime ? usualFactors.inTime : usualFactors.rest;
  const used = Math.max(factor * (line.utilisation ?? 0), usualFactors.anchor * (line.anchor_utilisation ?? 0));
  return used > 1 ? 'over' : used > 0.87 ? 'near' : 'good';
}

/** The lines with the maximum tensions of a run instead of the static ones. */
export function largestOfRun(lines: readonly MooringLine[], inTime: readonly MooringInTime[]): MooringLine[] {
  return lines.map((line) => {
    const run = inTime.find((m) => m.name === line.name);
    return run ? { ...line, fairlead_tension: run.fairlead_tension.max, anchor_tension: run.anchor_tension.max, utilisation: run.utilisation, anchor_utilisation: run.anchor_utilisation ?? null } : line;
  });
}

export const levelColours: Record<LineLevel, string> = { good: '#2e9e57', near: '#e08a00', over: '#c3271b', unknown: '#5b6b7a', gone: '#a0a8b0' };

export interface LineColumn extends Column { key: keyof MooringLine; name: string; factor: number }

/** `si`: SI unit of the values, which are shown in the unit of the page; `digits`: decimals of metric values. */
function column(key: keyof MooringLine, title: string, name: string, si: string, digits: number, description: string): LineColumn {
  const { name: unit, factor, more } = pageUnits.unit(si);
  return { key, title, name, unit, factor: si === '%' ? 100 : factor, digits: Math.max(0, digits + more), description };
}

const lineColumns: readonly LineColumn[] = [
  column('fairlead_tension', 'fairlead', 'tension, fairlead', 'N', 1, 'Tension at the fairlead'),
  column('anchor_tension', 'anchor', 'tension, anchor', 'N', 1, 'Tension at the anchor'),
  column('utilisation', 'of MBL', 'of breaking load', '%', 1, 'Fairlead tension over minimum breaking load'),
  column('anchor_utilisation', 'of anchor', 'of holding capacity', '%', 1, 'Anchor tension over holding capacity'),
  column('first_segment_length', 'out', 'paid out', 'm', 1, 'Unstressed length of the first segment (paid out by the winch)'),
  column('on_bed', 'on seabed', 'on the seabed', 'm', 1, 'Unstressed length on the seabed'),
  column('declination', 'down', 'below horizontal', 'rad', 1, 'Angle of the line below horizontal at the fairlead'),
  column('anchor_uplift', 'uplift', 'anchor uplift', 'N', 1, 'Vertical force on the anchor'),
  column('clearance', 'clear', 'clearance', 'm', 1, 'Minimum clearance to objects on the seabed'),
];

/** Columns that carry information for these lines. */
export const columnsFor = (lines: readonly MooringLine[]): LineColumn[] =>
  lineColumns.filter((c) => lines.some((l) => (c.key === 'anchor_uplift' ? l.anchor_uplift > 0 : l[c.key] !== null)));

/** A value as shown; a parted line has none. */
export function lineCell(line: MooringLine, { key, factor }: LineColumn): Cell {
  const value = line[key];
  return line.parted || typeof value !== 'number' ? '-' : value * factor;
}

const marks: Record<LineLevel, RowMark> = { good: '', near: '', over: 'over', unknown: '', gone: 'soft' };

/** `keys`: columns of the short table next to the picture. */
export function lineTable(lines: readonly MooringLine[], inTime: boolean, keys?: readonly string[]): TableData {
  const columns = columnsFor(lines).filter((c) => keys?.includes(c.key) ?? true);
  return {
    title: keys ? '' : 'Mooring lines',
    look: 'moorings',
    columns: [{ title: 'line', words: true }, ...columns],
    rows: lines.map((line) => [line.name, ...columns.map((c) => lineCell(line, c))]),
    marks: lines.map((line) => marks[lineLevel(line, inTime)]),
  };
}
