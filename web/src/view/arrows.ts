// Arrows: the current at its depths, and the movement of the pipe through the tensioner.
import * as THREE from 'three';
import type { Lay, Scene } from '../api/types';
import { members, vec } from './members';

const currentPaint = new THREE.MeshStandardMaterial({ color: '#1b9ab8', roughness: 0.7 });
const up = new THREE.Vector3(0, 1, 0);

/** `low`, `high`: corners of the visible part of the sea. */
export function currentArrows(scene: Scene, low: THREE.Vector2, high: THREE.Vector2): THREE.Object3D[] {
  const fastest = Math.max(0, ...scene.current.map((c) => Math.hypot(...c.velocity)));
  if (fastest === 0) return [];
  const out: THREE.Object3D[] = [];
  const size = Math.min(0.35 * scene.water_depth, 0.3 * (high.y - low.y));
  for (const c of scene.current) {
    const speed = Math.hypot(...c.velocity);
    if (speed < 1e-3 * fastest) continue;
    const direction = new THREE.Vector3(...c.velocity).divideScalar(speed);
    const length = Math.max(0.12, speed / fastest) * size;
    const from = new THREE.Vector3(low.x + 0.35 * (high.x - low.x), 0, -c.depth).addScaledVector(direction, -0.5 * size - 0.12 * (high.y - low.y));
    const head = Math.min(0.4 * length, 5);
    const neck = from.clone().addScaledVector(direction, length - head);
    const cone = new THREE.Mesh(new THREE.ConeGeometry(0.28 * head, head, 14), currentPaint);
    cone.position.copy(neck).addScaledVector(direction, head / 2);
    cone.quaternion.setFromUnitVectors(up, direction);
    out.push(members([[from, neck, 0.08 * head]], currentPaint), cone);
  }
  return out;
}

/** Tensioner state: +1 pays out, -1 hauls in, 0 holds; or at its limit. */
export interface Machine { way: number; limit: boolean; travel: number }

export class TensionerArrow {
  readonly group = new THREE.Group();
  private readonly paint = new THREE.MeshBasicMaterial({ color: '#1f6fd0' });

  constructor() {
    const shaft = new THREE.Mesh(new THREE.CylinderGeometry(0.22, 0.22, 3, 12), this.paint);
    const head = new THREE.Mesh(new THREE.ConeGeometry(0.65, 1.6, 16), this.paint);
    head.position.y = 2.3;
    this.group.add(shaft, head);
    this.group.visible = false;
  }

  /** Next to the tensioner, in the direction of the pipe movement. */
  point(machine: Machine | null, solution: Lay | null): void {
    this.group.visible = machine !== null && (machine.way !== 0 || machine.limit);
    if (!machine || !solution?.tensioner) return;
    const along = vec(solution.tensioner.direction).normalize();
    const way = machine.way || Math.sign(machine.travel) || 1;
    this.group.quaternion.setFromUnitVectors(up, along.clone().multiplyScalar(way));
    this.group.position.copy(vec(solution.tensioner.place)).addScaledVector(along, -2.2 + machine.travel).add(new THREE.Vector3(0, 0, 3));
    this.paint.color.set(machine.limit ? '#c3271b' : way > 0 ? '#1f6fd0' : '#7a3fb5');
  }
}
