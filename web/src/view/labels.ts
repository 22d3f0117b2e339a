// Names over the picture. A label that would cover another one is left out.
import * as THREE from 'three';
import type { Lay, Scene } from '../api/types';
import { axes } from './cameras';
import { vec } from './members';

export interface Label { text: string; place: THREE.Vector3; weight: number }

export class Labels {
  private pool: HTMLSpanElement[] = [];
  constructor(private readonly box: HTMLElement) {}

  draw(list: Label[], camera: THREE.Camera, width: number, height: number): void {
    const taken: [number, number, number, number][] = [];
    const p = new THREE.Vector3();
    let used = 0;
    for (const label of [...list].sort((a, b) => b.weight - a.weight)) {
      p.copy(label.place).project(camera);
      if (p.z > 1 || Math.abs(p.x) > 0.98 || Math.abs(p.y) > 0.97) continue;
      const w = 7 * label.text.length + 12;
      // whole within the picture
      const x = Math.min(Math.max(((p.x + 1) / 2) * width, w / 2 + 2), width - w / 2 - 2), y = ((1 - p.y) / 2) * height;
      const rect: [number, number, number, number] = [x - w / 2, y - 40, x + w / 2, y - 18];
      if (taken.some((t) => rect[0] < t[2] && rect[2] > t[0] && rect[1] < t[3] && rect[3] > t[1])) continue;
      taken.push(rect);
      const span = this.pool[used] ?? this.grow();
      ++used;
      if (span.textContent !== label.text) span.textContent = label.text;
      span.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px) translate(-50%, -38px)`;
      span.hidden = false;
    }
    for (let i = used; i < this.pool.length; ++i) this.pool[i]!.hidden = true;
  }

  private grow(): HTMLSpanElement {
    const span = document.createElement('span');
    span.className = 'label3d';
    this.box.append(span);
    this.pool.push(span);
    return span;
  }
}

/** Names of what is in the picture; where they collide the heavier one stays. */
export function labelsOf(scene: Scene, solution: Lay): Label[] {
  const list: Label[] = [];
  if (solution.tensioner) list.push({ text: 'tensioner', place: vec(solution.tensioner.place), weight: 5 });
  if (solution.touchdown) list.push({ text: 'touchdown', place: vec(solution.touchdown.place), weight: 6 });
  for (const s of solution.supports) list.push({ text: s.name, place: vec(s.place).add(new THREE.Vector3(0, 0, 0.6)), weight: s.reaction / 1e9 });
  const { vessel } = scene;
  if (vessel) {
    const bow = vec(vessel.pose).addScaledVector(axes(vessel).forward, 0.33 * vessel.length);
    list.push({ text: vessel.name, place: bow.add(new THREE.Vector3(0, 0, vessel.height - vessel.draught + 11)), weight: 7 });
  }
  return list;
}
