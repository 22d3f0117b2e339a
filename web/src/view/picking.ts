// Objects under the pointer: found on the screen, so that thin objects can be hit.
import * as THREE from 'three';
import type { RollerRef } from './rollers';

export type Picked = { kind: 'station'; index: number } | { kind: 'roller'; roller: RollerRef } | { kind: 'line'; name: string } | null;

export interface Target {
  camera: THREE.PerspectiveCamera;
  width: number; height: number;
  /** Positions of the pipe stations, three numbers each. */
  points: ArrayLike<number>;
  rollers: RollerRef[];
  /** Mooring lines and other lines. */
  lines: readonly { name: string; points: ArrayLike<number> }[];
  /** Pose of the moved vessel. */
  afloat: THREE.Matrix4;
}

const reach = 14; // px
const lineReach = 8; // px: lines are long, and pass other objects
const farthest = 60; // m: more distant rollers are too small to be selected

export function pick(t: Target, x: number, y: number): Picked {
  const p = new THREE.Vector3();
  let best: Picked = null;
  let closest = reach;
  const away = (): number => { p.project(t.camera); return p.z < 1 ? Math.hypot(((p.x + 1) / 2) * t.width - x, ((1 - p.y) / 2) * t.height - y) : Infinity; };
  for (const roller of t.rollers) {
    p.copy(roller.center).applyMatrix4(t.afloat);
    if (t.camera.position.distanceTo(p) > farthest) continue;
    const d = away();
    if (d < closest) { closest = d; best = { kind: 'roller', roller }; }
  }
  for (let i = 0; i + 2 < t.points.length; i += 3) {
    p.set(t.points[i]!, t.points[i + 1]!, t.points[i + 2]!);
    const d = away();
    if (d < closest - (best?.kind === 'roller' ? 3 : 0)) { closest = d; best = { kind: 'station', index: i / 3 }; }
  }
  if (best === null) best = pickLine(t, x, y);
  return best;
}

/** World position of a click: on a roller or the pipe, otherwise on a vertical plane through the pipe or lines, otherwise on the water. */
export function placeUnder(t: Target, x: number, y: number, plane: { point: THREE.Vector3; normal: THREE.Vector3 } | null): THREE.Vector3 | null {
  const hit = pick(t, x, y);
  if (hit?.kind === 'roller') return hit.roller.center.clone().applyMatrix4(t.afloat);
  if (hit?.kind === 'station') return new THREE.Vector3(t.points[3 * hit.index], t.points[3 * hit.index + 1], t.points[3 * hit.index + 2]);
  const ray = new THREE.Raycaster();
  ray.setFromCamera(new THREE.Vector2((2 * x) / t.width - 1, 1 - (2 * y) / t.height), t.camera);
  const far = 20 * Math.max(100, t.camera.position.length());
  const upright = plane && Math.abs(plane.normal.dot(ray.ray.direction)) > 0.12 ? new THREE.Plane().setFromNormalAndCoplanarPoint(plane.normal, plane.point) : null;
  for (const surface of [upright, new THREE.Plane(new THREE.Vector3(0, 0, 1), 0)]) {
    const crossing = surface && ray.ray.intersectPlane(surface, new THREE.Vector3());
    if (crossing && crossing.distanceTo(t.camera.position) < far) return crossing;
  }
  return null;
}

/** Lines have few, distant points: the segments between them count as well. */
function pickLine(t: Target, x: number, y: number): Picked {
  const p = new THREE.Vector3();
  let best: Picked = null;
  let closest = lineReach;
  for (const line of t.lines) {
    let before: [number, number] | null = null;
    for (let i = 0; i + 2 < line.points.length; i += 3) {
      p.set(line.points[i]!, line.points[i + 1]!, line.points[i + 2]!).project(t.camera);
      const projected: [number, number] | null = p.z < 1 ? [((p.x + 1) / 2) * t.width, ((1 - p.y) / 2) * t.height] : null;
      if (projected && before) {
        const d = toSegment([x, y], before, projected);
        if (d < closest) { closest = d; best = { kind: 'line', name: line.name }; }
      }
      before = projected;
    }
  }
  return best;
}

/** Distance of a point from a segment. */
export function toSegment(p: readonly [number, number], a: readonly [number, number], b: readonly [number, number]): number {
  const ux = b[0] - a[0], uy = b[1] - a[1], size = ux * ux + uy * uy;
  const f = size > 0 ? Math.min(1, Math.max(0, ((p[0] - a[0]) * ux + (p[1] - a[1]) * uy) / size)) : 0;
  return Math.hypot(a[0] + f * ux - p[0], a[1] + f * uy - p[1]);
}

/** A click is a press without a drag; moves are reported at most about thirty times a second. */
export function followPointer(canvas: HTMLElement, click: (x: number, y: number) => void, move: (x: number, y: number) => void, leave: () => void): void {
  let down: [number, number] | null = null;
  let last = 0;
  const local = (e: PointerEvent): [number, number] => { const r = canvas.getBoundingClientRect(); return [e.clientX - r.left, e.clientY - r.top]; };
  canvas.addEventListener('pointerdown', (e) => { down = local(e); });
  canvas.addEventListener('pointerup', (e) => {
    const released = local(e);
    if (down && Math.hypot(released[0] - down[0], released[1] - down[1]) < 4) click(...released);
    down = null;
  });
  canvas.addEventListener('pointermove', (e) => {
    if (e.buttons || performance.now() - last < 30) return;
    last = performance.now();
    move(...local(e));
  });
  canvas.addEventListener('pointerleave', leave);
}
