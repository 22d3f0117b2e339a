// Cross-sections of the picture: rollers of a box around the pipe, row by row, or the pipe alone. View from astern, port on the left.
import type { Lay, Roller, Scene, Support, Vector } from '../api/types';
import { rollerRows } from './elevation';
import { nearest } from './series';
import { shipAxes } from './shipAxes';

/** Layers from the bore outwards [m]: outer radius of each. */
export interface PipeLayer { name: string; radius: number; colour: string }

export interface SectionRoller { x: number; y: number; turn: number; radius: number; face: number; position: Roller['position']; reaction: number; separation: number }
/** `pipe`: its axis in the plane of the section [m], from the centre of the bottom roller. */
export interface SectionRow { rollers: SectionRoller[]; pipe: readonly [number, number]; s: number }

const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a: Vector, b: Vector): Vector => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
function unit(v: Vector): Vector { const size = Math.hypot(...v) || 1; return [v[0] / size, v[1] / size, v[2] / size]; }

const station = ({ pipe }: Lay, i: number): Vector => [pipe.x[i]!, pipe.y[i]!, pipe.z[i]!];

/** Axes of the plane normal to a direction: to starboard, and upwards as far as possible. */
function planeAcross(along: Vector, port: Vector): { right: Vector; up: Vector } {
  const right = unit(minus(port.map((v) => -v) as Vector, along.map((v) => v * -dot(port, along)) as Vector));
  const up = unit(cross(right, along));
  return { right, up: up[2] < 0 ? [-up[0], -up[1], -up[2]] : up };
}

/** Intersection of the pipe with the plane through a point, with direction and arc length there. */
function pipeNear(lay: Lay, point: Vector, s: number): { place: Vector; along: Vector; s: number } {
  const { pipe } = lay;
  const from = Math.max(0, nearest(pipe.s, s) - 12), to = Math.min(pipe.s.length - 2, nearest(pipe.s, s) + 12);
  let best = { place: station(lay, from), along: unit(minus(station(lay, from + 1), station(lay, from))), s: pipe.s[from]! }, closest = Infinity;
  for (let i = from; i <= to; ++i) {
    const a = station(lay, i), span = minus(station(lay, i + 1), a), length = Math.hypot(...span) || 1;
    const t = Math.min(1, Math.max(0, dot(minus(point, a), span) / length ** 2));
    const place: Vector = [a[0] + t * span[0], a[1] + t * span[1], a[2] + t * span[2]], away = Math.hypot(...minus(point, place));
    if (away < closest) { closest = away; best = { place, along: unit(span), s: pipe.s[i]! + t * length }; }
  }
  return best;
}

export function boxSection(lay: Lay, scene: Scene, box: Support): SectionRow[] {
  const axes = shipAxes(scene, lay), port: Vector = [axes.port[0], axes.port[1], 0];
  return rollerRows(box).map((row) => {
    const middle = row[0]!.center, crossing = pipeNear(lay, middle, box.s);
    const { right, up } = planeAcross(crossing.along, port);
    const flat = (p: Vector): [number, number] => { const d = minus(p, middle); return [dot(d, right), dot(d, up)]; };
    const rollers = row.map((roller): SectionRoller => {
      const [x, y] = flat(roller.center);
      const turn = Math.atan2(dot(roller.axis, up), dot(roller.axis, right));
      return { x, y, turn, radius: roller.radius, face: roller.face, position: roller.position, reaction: roller.reaction, separation: roller.separation };
    });
    return { rollers, pipe: flat(crossing.place), s: crossing.s };
  });
}

interface Field { si: number | null; value?: unknown }

/** From the fields of the model, as far as they describe the pipe. */
export function pipeLayers(field: (path: string) => Field | undefined, outer: number): PipeLayer[] {
  const diameter = field('pipe.steel.outside_diameter')?.si ?? null, wall = field('pipe.steel.wall_thickness')?.si ?? null;
  if (diameter === null || wall === null || diameter / 2 > outer + 1e-6) return [{ name: 'pipe', radius: outer, colour: '#7b8794' }];
  const layers: PipeLayer[] = [
    { name: 'bore', radius: diameter / 2 - wall, colour: 'var(--paper)' },
    { name: 'steel', radius: diameter / 2, colour: '#4f6272' },
  ];
  const coats = ['#c9a227', '#b9bec4', '#8fb3a8', '#d7c4a3'];
  for (let i = 0, radius = diameter / 2; ; ++i) {
    const coat = `pipe.coatings[${i}]`, thickness = field(`${coat}.thickness`)?.si ?? null;
    if (thickness === null) break;
    radius += thickness;
    layers.push({ name: String(field(`${coat}.name`)?.value ?? 'coating'), radius, colour: coats[i % coats.length]! });
  }
  return layers;
}

/** Default box: the one with the largest reaction. */
export const heaviestBox = (lay: Lay): Support | null => lay.supports.reduce<Support | null>((a, b) => (!a || b.reaction > a.reaction ? b : a), null);
