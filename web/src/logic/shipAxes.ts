// Ship axes for drawings: astern of the stern shoe, to port, and up from the water. Without a vessel along the line drawn.
import type { Lay, Scene, Vector } from '../api/types';

type Flat = readonly [number, number];

export interface ShipAxes { origin: Flat; astern: Flat; port: Flat }

const normalised = (x: number, y: number): Flat => { const size = Math.hypot(x, y) || 1; return [x / size, y / size]; };

/** Axes along the longest distance between points of the lines. */
function alongLines(lay: Lay | null): ShipAxes {
  const points = lay?.lines.flatMap((line) => line.shape) ?? [];
  const first = points[0] ?? [0, 0, 0];
  const far = points.reduce<Vector>((a, b) => (Math.hypot(b[0] - first[0], b[1] - first[1]) > Math.hypot(a[0] - first[0], a[1] - first[1]) ? b : a), first);
  const astern = Math.hypot(far[0] - first[0], far[1] - first[1]) > 0 ? normalised(far[0] - first[0], far[1] - first[1]) : [1, 0] as const;
  return { origin: [first[0], first[1]], astern, port: [astern[1], -astern[0]] };
}

export function shipAxes(scene: Scene, lay: Lay | null): ShipAxes {
  const { vessel, stern_shoe: shoe } = scene;
  if (!vessel) return alongLines(lay);
  const p = vessel.pose, [fx, fy] = normalised(p[3]!, p[6]!);
  const origin: Flat = shoe ? [shoe[0], shoe[1]] : [p[0]!, p[1]!];
  return { origin, astern: [-fx, -fy], port: [-fy, fx] };
}

/** A world point in ship axes. */
export function toShip({ origin, astern, port }: ShipAxes, p: ArrayLike<number>): Vector {
  const [x, y] = [p[0]! - origin[0], p[1]! - origin[1]];
  return [x * astern[0] + y * astern[1], x * port[0] + y * port[1], p[2]!];
}

/** A world direction in ship axes. */
export const turnToShip = (axes: ShipAxes, d: ArrayLike<number>): Vector => toShip({ ...axes, origin: [0, 0] }, d);

/** A point in ship axes in world axes. */
export function toWorld({ origin, astern, port }: ShipAxes, [x, y, z]: Vector): Vector {
  return [origin[0] + x * astern[0] + y * port[0], origin[1] + x * astern[1] + y * port[1], z];
}

/** Change of a box's model coordinates (astern, up) for a displacement astern and up in world axes: the frame of the boxes rotates with the vessel. */
export function inBoxFrame(pose: ArrayLike<number>, axes: ShipAxes, astern: number, up: number): { x: number; z: number } {
  const move = [astern * axes.astern[0], astern * axes.astern[1], up];
  const along = (column: number): number => move.reduce((sum, v, row) => sum + v * pose[column + 3 * row]!, 0);
  return { x: -along(3), z: along(5) };
}
