// Mooring lines with their anchors and fairleads, and other lines: tubes drawn thick enough to be visible from far.
import * as THREE from 'three';
import { valueScale } from '../components/colourScale';
import type { LineAtRest, MooredState, Vector } from '../api/types';
import { levelColours, lineLevel } from '../logic/moorings';
import type { Label } from './labels';
import { dispose, vec } from './members';
import { PipeView } from './pipe';

const wire = 0.05; // m, drawn; at a distance at least a few pixels
const anchorPaint = new THREE.MeshStandardMaterial({ color: '#3a2f28', roughness: 0.7 });
const sheavePaint = new THREE.MeshStandardMaterial({ color: '#c2452d', roughness: 0.6 });

export interface DrawnLine { name: string; points: Float32Array; colour: string; values: number[] | null }

const flat = (points: readonly Vector[]): Float32Array => new Float32Array(points.flat());

/** A parted line is not drawn. */
export const ofMoorings = (state: MooredState): DrawnLine[] =>
  state.moorings.filter((l) => !l.parted && l.shape.length > 1).map((l) => ({ name: l.name, points: flat(l.shape), colour: levelColours[lineLevel(l)], values: null }));

export const ofLines = (lines: readonly LineAtRest[]): DrawnLine[] =>
  lines.map((l) => ({ name: l.name, points: flat(l.shape), colour: '#0b66c2', values: l.tension }));

/** The same lines as recorded in a run; without tensions, which are static ones. */
export function recordedLines(lines: readonly DrawnLine[], recorded: ReadonlyMap<string, Float32Array> | null): DrawnLine[] {
  return lines.flatMap((l) => {
    const points = recorded?.get(l.name);
    return points ? [{ ...l, points, values: null }] : [];
  });
}

export class MooringsView {
  readonly group = new THREE.Group();
  lines: DrawnLine[] = [];
  private readonly tubes: PipeView[] = [];
  private readonly marks = new THREE.Group();
  private anchors: THREE.Mesh[] = [];
  private pixel = 0.001;

  constructor() { this.group.add(this.marks); }

  set(lines: DrawnLine[], chosen: string | null): void {
    this.lines = lines;
    while (this.tubes.length < lines.length) {
      const tube = new PipeView();
      this.tubes.push(tube);
      this.group.add(tube.mesh);
    }
    this.tubes.forEach((tube, i) => {
      const line = lines[i];
      tube.mesh.visible = line !== undefined;
      if (!line) return;
      const picked = line.name === chosen;
      tube.setRadius(picked ? 4 * wire : wire);
      tube.setLeast(picked ? 2.6 : 1.2);
      tube.setPlaces(line.points);
      if (line.values) tube.setColours(line.values, valueScale(line.values));
      else tube.setColour(picked ? '#ff2d7a' : line.colour);
    });
    this.setPixel(this.pixel);
  }

  /** Fairleads and anchors of a mooring spread; none for other lines. */
  mark(state: MooredState | null): void {
    dispose(this.marks);
    this.anchors = [];
    for (const line of state?.moorings ?? []) {
      const anchor = new THREE.Mesh(new THREE.ConeGeometry(0.7, 1.6, 4), anchorPaint);
      anchor.position.copy(vec(line.anchor));
      anchor.rotation.x = Math.PI / 2;
      this.anchors.push(anchor);
      const sheave = new THREE.Mesh(new THREE.SphereGeometry(0.55, 12, 8), sheavePaint);
      sheave.position.copy(vec(line.fairlead));
      this.marks.add(anchor, sheave);
    }
  }

  /** World size of a pixel at unit distance. */
  setPixel(size: number): void {
    this.pixel = size;
    for (const tube of this.tubes) tube.setPixel(size);
  }

  /** Anchors are visible from afar. */
  face(camera: THREE.Camera): void {
    for (const anchor of this.anchors) anchor.scale.setScalar(Math.max(2, 7 * this.pixel * camera.position.distanceTo(anchor.position)));
  }

  labels(state: MooredState): Label[] {
    return state.moorings.map((l) => ({ text: l.parted ? `${l.name} (parted)` : l.name, place: vec(l.anchor), weight: 4 }));
  }
}
