// What lies under the pointer: looked for on the screen, so that thin things can be hit.
import * as THREE from 'three';
import type { RollerRef } from './rollers';

export type Picked = { kind: 'station'; index: number } | { kind: 'roller'; roller: RollerRef } | null;

export interface Target {
  camera: THREE.PerspectiveCamera;
  width: number; height: number;
  /** Places of the pipe's stations, three numbers each. */
  points: ArrayLike<number>;
  rollers: RollerRef[];
  /** Where the vessel has moved to. */
  afloat: THREE.Matrix4;
}

const reach = 14; // px
const farthest = 60; // m: rollers farther away are too small to be meant

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
  return best;
}

/** A click is a press that did not drag; moving tells at most some thirty times a second. */
export function followPointer(canvas: HTMLElement, click: (x: number, y: number) => void, move: (x: number, y: number) => void, leave: () => void): void {
  let down: [number, number] | null = null;
  let last = 0;
  const local = (e: PointerEvent): [number, number] => { const r = canvas.getBoundingClientRect(); return [e.clientX - r.left, e.clientY - r.top]; };
  canvas.addEventListener('pointerdown', (e) => { down = local(e); });
  canvas.addEventListener('pointerup', (e) => {
    const at = local(e);
    if (down && Math.hypot(at[0] - down[0], at[1] - down[1]) < 4) click(...at);
    down = null;
  });
  canvas.addEventListener('pointermove', (e) => {
    if (e.buttons || performance.now() - last < 30) return;
    last = performance.now();
    move(...local(e));
  });
  canvas.addEventListener('pointerleave', leave);
}
