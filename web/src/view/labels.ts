// Names over the picture; for their positions see logic/labelPlaces.ts.
import * as THREE from 'three';
import type { Lay, Scene } from '../api/types';
import { labelHeight, placeNames, type Rect, type Wanted } from '../logic/labelPlaces';
import { axes } from './cameras';
import { vec } from './members';

export interface Label { text: string; place: THREE.Vector3; weight: number }

/** A placed name in the picture [px]. */
export interface ShownName { text: string; x: number; middle: number; top: number; leader: number; chosen: boolean }

const heaviest = 100;

export class Labels {
  shown: ShownName[] = [];
  /** Cards over the picture [px]. */
  taken: Rect[] = [];
  chosen = '';
  private pool: HTMLSpanElement[] = [];
  constructor(private readonly box: HTMLElement) {}

  draw(list: Label[], camera: THREE.Camera, width: number, height: number): void {
    const p = new THREE.Vector3();
    const seen: Label[] = [];
    const wanted: Wanted[] = [];
    for (const label of list) {
      p.copy(label.place).project(camera);
      if (p.z > 1 || Math.abs(p.x) > 0.98 || Math.abs(p.y) > 0.97) continue;
      seen.push(label);
      const weight = label.text === this.chosen ? heaviest : label.weight;
      wanted.push({ x: ((p.x + 1) / 2) * width, y: ((1 - p.y) / 2) * height, width: 7 * label.text.length + 12, weight });
    }
    const placed = placeNames(wanted, { x0: 0, y0: 0, x1: width, y1: height }, this.taken);
    this.shown = placed.map(({ index, middle, top, leader }) => {
      const { text } = seen[index]!;
      return { text, x: wanted[index]!.x, middle, top, leader, chosen: text === this.chosen };
    });
    this.shown.forEach((name, i) => this.write(this.pool[i] ?? this.grow(), name));
    for (const span of this.pool.slice(this.shown.length)) { span.hidden = true; span.classList.remove('chosen'); }
  }

  private write(span: HTMLSpanElement, { text, x, middle, top, leader, chosen }: ShownName): void {
    if (span.textContent !== text) span.textContent = text;
    span.style.transform = `translate(${Math.round(middle)}px, ${Math.round(top)}px) translateX(-50%)`;
    span.style.setProperty('--leader', `${Math.round(leader)}px`);
    span.style.setProperty('--aside', `${Math.round(x - middle)}px`);
    span.classList.toggle('chosen', chosen);
    span.hidden = false;
  }

  private grow(): HTMLSpanElement {
    const span = document.createElement('span');
    span.className = 'label3d';
    span.style.height = `${labelHeight}px`;
    this.box.append(span);
    this.pool.push(span);
    return span;
  }
}

/** Names of objects in the picture; if names overlap, the one of higher weight is kept. */
export function makeLabels(scene: Scene, solution: Lay): Label[] {
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
