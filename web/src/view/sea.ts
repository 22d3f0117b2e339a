// Water, seabed and current.
import * as THREE from 'three';
import type { Lay, Scene } from '../api/types';
import { bedHeight } from '../logic/bed';
import { surface } from '../logic/waves';
import { currentArrows } from './arrows';
import { axes } from './cameras';
import { dispose, vec } from './members';

const cells = 72;
const grain = 20; // m: whole cells, so that the water does not creep during a drag

/** Corners of the visible part of the sea: from ahead of the bow to slightly beyond touchdown. */
export function seaCorners(scene: Scene, solution: Lay): [THREE.Vector2, THREE.Vector2] {
  const touch = solution.touchdown?.s ?? Infinity;
  const { vessel } = scene;
  const points = vessel ? [0.62, -0.62].slice(0, solution.pipe.s.length ? 1 : 2).map((k) => vec(vessel.pose).addScaledVector(axes(vessel).forward, k * vessel.length)) : [];
  for (const line of solution.lines) points.push(...line.shape.map((p) => vec(p)));
  solution.pipe.s.forEach((s, i) => { if (s <= touch + 80) points.push(new THREE.Vector3(solution.pipe.x[i], solution.pipe.y[i], 0)); });
  const box = new THREE.Box3().setFromPoints(points);
  const wide = Math.max(1.6 * (vessel?.beam ?? 0), 0.13 * box.getSize(new THREE.Vector3()).length());
  return [
    new THREE.Vector2(Math.floor((box.min.x - wide) / grain) * grain, Math.floor((box.min.y - wide) / grain) * grain),
    new THREE.Vector2(Math.ceil((box.max.x + wide) / grain) * grain, Math.ceil((box.max.y + wide) / grain) * grain),
  ];
}

/** The same with room for mooring lines. */
export function widerCorners([low, high]: [THREE.Vector2, THREE.Vector2], solution: Lay): [THREE.Vector2, THREE.Vector2] {
  const anchors = solution.moorings?.rest.moorings.map((l) => vec(l.anchor)) ?? [];
  if (anchors.length === 0) return [low, high];
  const box = new THREE.Box3().setFromPoints(anchors);
  const wide = 0.05 * box.getSize(new THREE.Vector3()).length();
  const down = (a: number, b: number): number => Math.floor(Math.min(a, b - wide) / grain) * grain, up = (a: number, b: number): number => Math.ceil(Math.max(a, b + wide) / grain) * grain;
  return [new THREE.Vector2(down(low.x, box.min.x), down(low.y, box.min.y)), new THREE.Vector2(up(high.x, box.max.x), up(high.y, box.max.y))];
}

/** Grid lines of the water, densest at the vessel. */
export function waterGrid(low: number, high: number, from: number, to: number): number[] {
  if (high - low < 1.5 * (to - from)) return Array.from({ length: cells + 1 }, (_, i) => low + ((high - low) * i) / cells);
  const outer = low < from && high > to ? cells / 6 : cells / 3;
  const before = low < from ? outer : 0, behind = high > to ? outer : 0, inner = cells - before - behind;
  const out: number[] = [];
  for (let i = 0; i < before; ++i) out.push(low + ((from - low) * i) / before);
  for (let i = 0; i <= inner; ++i) out.push(Math.max(low, from) + ((Math.min(high, to) - Math.max(low, from)) * i) / inner);
  for (let i = 1; i <= behind; ++i) out.push(to + ((high - to) * i) / behind);
  return out;
}

export class SeaView {
  readonly group = new THREE.Group();
  private readonly bed = new THREE.Group();
  private readonly arrows = new THREE.Group();
  private readonly water: THREE.Mesh;
  // Only the far walls of the body of water are visible: they separate water from air behind the objects.
  private readonly body = new THREE.Mesh(new THREE.BoxGeometry(1, 1, 1), new THREE.MeshBasicMaterial({ color: '#3f8fbf', transparent: true, opacity: 0.16, side: THREE.BackSide, depthWrite: false }));
  private xs: number[] = [];
  private ys: number[] = [];
  private heights = new Float32Array((cells + 1) ** 2);
  private waves: Scene['waves'] = [];

  constructor() {
    const material = new THREE.MeshLambertMaterial({ color: '#4d9cc9', transparent: true, opacity: 0.36, side: THREE.DoubleSide, depthWrite: false });
    this.water = new THREE.Mesh(new THREE.PlaneGeometry(1, 1, cells, cells), material);
    this.water.frustumCulled = false;
    this.water.renderOrder = 5;
    this.body.renderOrder = -5;
    this.group.add(this.body, this.bed, this.arrows, this.water);
  }

  /** `low`, `high`: corners of the visible part of the sea; `core`: those of its part about vessel and pipe. */
  set(scene: Scene, low: THREE.Vector2, high: THREE.Vector2, core: [THREE.Vector2, THREE.Vector2], dark: boolean): void {
    this.waves = scene.waves;
    this.xs = waterGrid(low.x, high.x, core[0].x, core[1].x);
    this.ys = waterGrid(low.y, high.y, core[0].y, core[1].y);
    const place = this.water.geometry.getAttribute('position') as THREE.BufferAttribute;
    for (let j = 0; j <= cells; ++j) for (let i = 0; i <= cells; ++i) place.setXYZ(j * (cells + 1) + i, this.xs[i]!, this.ys[j]!, 0);
    this.setTime(null);
    this.body.scale.set(high.x - low.x, high.y - low.y, scene.water_depth);
    this.body.position.set((low.x + high.x) / 2, (low.y + high.y) / 2, -scene.water_depth / 2);
    this.drawBed(scene, low, high, dark);
    dispose(this.arrows);
    for (const arrow of currentArrows(scene, ...core)) this.arrows.add(arrow);
  }

  /** Waves at a time; null is the still water of statics. */
  setTime(t: number | null): void {
    if (t === null || this.waves.length === 0) this.heights.fill(0);
    else surface(this.waves, this.xs, this.ys, t, this.heights);
    const place = this.water.geometry.getAttribute('position') as THREE.BufferAttribute;
    for (let k = 0; k < this.heights.length; ++k) place.setZ(k, this.heights[k]!);
    place.needsUpdate = true;
    this.water.geometry.computeVertexNormals();
  }

  private drawBed(scene: Scene, low: THREE.Vector2, high: THREE.Vector2, dark: boolean): void {
    dispose(this.bed);
    const z = (x: number, y: number): number => bedHeight(scene.seabed, x, y);
    const parts = scene.seabed.shape ? 200 : 1;
    const geometry = new THREE.PlaneGeometry(1, 1, parts, parts);
    const place = geometry.getAttribute('position') as THREE.BufferAttribute;
    for (let j = 0; j <= parts; ++j) for (let i = 0; i <= parts; ++i) {
      const x = low.x + ((high.x - low.x) * i) / parts, y = low.y + ((high.y - low.y) * j) / parts;
      place.setXYZ(j * (parts + 1) + i, x, y, z(x, y));
    }
    geometry.computeVertexNormals();
    const ground = new THREE.MeshStandardMaterial({ color: dark ? '#6d6249' : '#d8c9a0', roughness: 1, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2 });
    this.bed.add(new THREE.Mesh(geometry, ground));
    const lines: number[] = [];
    const step = Math.max(high.x - low.x, high.y - low.y) > 1500 ? 100 : 20;
    const line = (x0: number, y0: number, x1: number, y1: number): void => {
      const pointAt = (k: number): [number, number] => [x0 + ((x1 - x0) * k) / parts, y0 + ((y1 - y0) * k) / parts];
      for (let k = 0; k < parts; ++k) {
        const [a, b] = pointAt(k), [c, d] = pointAt(k + 1);
        lines.push(a, b, z(a, b), c, d, z(c, d));
      }
    };
    for (let x = Math.ceil(low.x / step) * step; x <= high.x; x += step) line(x, low.y, x, high.y);
    for (let y = Math.ceil(low.y / step) * step; y <= high.y; y += step) line(low.x, y, high.x, y);
    const grid = new THREE.BufferGeometry();
    grid.setAttribute('position', new THREE.Float32BufferAttribute(lines, 3));
    this.bed.add(new THREE.LineSegments(grid, new THREE.LineBasicMaterial({ color: dark ? '#8d8160' : '#b5a374' })));
  }
}
