// Axonometric pictures: pieces are painted from the farthest to the nearest, in layers.
import { shade } from './colourScale';

export type Vector = readonly [number, number, number];

export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vector, b: Vector): Vector => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const add = (a: Vector, b: Vector, k = 1): Vector => [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]];
export const scale = (a: Vector, k: number): Vector => [k * a[0], k * a[1], k * a[2]];
export const unit = (a: Vector): Vector => scale(a, 1 / (Math.hypot(...a) || 1));

/** Ship axes (astern, port, up) are left-handed, pictures use (astern, starboard, up). */
export const toPicture = (p: Vector): Vector => [p[0], -p[1], p[2]];

/** Azimuth from astern towards starboard, elevation above the horizon [rad]. */
export class Camera {
  readonly towardsEye: Vector;
  readonly right: Vector;
  readonly up: Vector;

  constructor(azimuth: number, elevation: number) {
    const c = Math.cos(elevation);
    this.towardsEye = [c * Math.cos(azimuth), c * Math.sin(azimuth), Math.sin(elevation)];
    this.right = [-Math.sin(azimuth), Math.cos(azimuth), 0];
    this.up = cross(this.towardsEye, this.right);
  }

  /** Components to the right, downwards, and towards the eye. */
  project(p: Vector): Vector {
    return [dot(this.right, p), -dot(this.up, p), dot(this.towardsEye, p)];
  }
}

export interface Look {
  fill?: string;
  'fill-opacity'?: number;
  stroke?: string;
  'stroke-width'?: number;
  'stroke-dasharray'?: string;
  'stroke-linecap'?: 'round';
  'stroke-linejoin'?: 'round';
}

export interface Piece { layer: number; depth: number; seen: Vector[]; closed: boolean; look: Look }

export interface Label {
  seen: Vector;
  text: string;
  dx: number;
  dy: number;
  anchor: 'start' | 'middle' | 'end';
  /** It may be moved along its leader, or left out, to avoid overlaps. */
  movable: boolean;
}

export class Painter {
  readonly labels: Label[] = [];
  private readonly pieces: Piece[] = [];
  private readonly light: Vector;

  constructor(readonly camera: Camera) {
    this.light = unit(add(add(scale(camera.right, 0.25), camera.up, 0.6), camera.towardsEye));
  }

  /** `nearer`: moves it forward within its layer [m]. */
  addFace(layer: number, points: Vector[], look: Look, nearer = 0): void {
    this.addPiece(layer, points, look, true, nearer);
  }

  addLine(layer: number, points: Vector[], look: Look, nearer = 0): void {
    this.addPiece(layer, points, { fill: 'none', ...look }, false, nearer);
  }

  /** A face of a solid: drawn only if it faces the eye, brighter towards the light. */
  addShaded(layer: number, points: Vector[], normal: Vector, colour: string): void {
    if (dot(normal, this.camera.towardsEye) <= 0) return;
    const shaded = shade(colour, 0.45 + 0.65 * Math.max(0, dot(normal, this.light)));
    this.addFace(layer, points, { fill: shaded, stroke: shaded, 'stroke-width': 0.4 });
  }

  addLabel(point: Vector, text: string, dx: number, dy: number, anchor: Label['anchor'] = 'middle', movable = false): void {
    this.labels.push({ seen: this.camera.project(point), text, dx, dy, anchor, movable });
  }

  /** In painting order. */
  sortedPieces(): Piece[] {
    return this.pieces.sort((a, b) => a.layer - b.layer || a.depth - b.depth);
  }

  private addPiece(layer: number, points: Vector[], look: Look, closed: boolean, nearer: number): void {
    const seen = points.map((p) => this.camera.project(p));
    const depth = seen.reduce((sum, p) => sum + p[2], 0) / seen.length + nearer;
    this.pieces.push({ layer, depth, seen, closed, look });
  }
}

/** Position of projected points in a picture [px]. */
export type Place = (seen: Vector) => [number, number];

export interface Room { left: number; right: number; top: number; bottom: number }

/** Scales the visible extent to the room within the margins, centred. */
export function fitInto(seen: Vector[], width: number, height: number, margin: Room): Place {
  const [x0, x1] = [Math.min(...seen.map((p) => p[0])), Math.max(...seen.map((p) => p[0]))];
  const [y0, y1] = [Math.min(...seen.map((p) => p[1])), Math.max(...seen.map((p) => p[1]))];
  const wide = width - margin.left - margin.right;
  const high = height - margin.top - margin.bottom;
  const size = Math.min(wide / (x1 - x0), high / (y1 - y0));
  const dx = margin.left + (wide - size * (x0 + x1)) / 2;
  const dy = margin.top + (high - size * (y0 + y1)) / 2;
  return (p) => [dx + size * p[0], dy + size * p[1]];
}

export interface PlacedLabel { label: Label; x: number; y: number; dy: number }

interface Box { x0: number; x1: number; y0: number; y1: number }

const overlap = (a: Box, b: Box): boolean => a.x1 >= b.x0 && a.x0 <= b.x1 && a.y1 >= b.y0 && a.y0 <= b.y1;

/** Labels that fit. Moved labels stay above `lowest`, the position of the colour scale. */
export function placeLabels(labels: Label[], place: Place, width: (text: string) => number, lowest: number): PlacedLabel[] {
  const taken: Box[] = [];
  const placed: PlacedLabel[] = [];
  for (const label of labels) {
    const [x, y] = place(label.seen);
    const wide = width(label.text);
    const left = x + label.dx - { start: 0, middle: wide / 2, end: wide }[label.anchor];
    for (let step = 0; step < (label.movable ? 4 : 1); ++step) {
      const dy = label.dy + 17 * step * Math.sign(label.dy);
      const box = { x0: left - 2, x1: left + wide + 2, y0: y + dy - 8, y1: y + dy + 7 };
      if (step > 0 && box.y1 > lowest) break;
      if (label.movable && taken.some((occupied) => overlap(box, occupied))) continue;
      taken.push(box);
      placed.push({ label, x, y, dy });
      break;
    }
  }
  return placed;
}
