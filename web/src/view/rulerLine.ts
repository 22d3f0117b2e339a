// The ruler in the 3-D view: two points and the straight line between them, drawn over everything.
import * as THREE from 'three';
import type { Vector } from '../api/types';

const colour = '#d6247f';

export class RulerLine {
  readonly group = new THREE.Group();
  private readonly ends: THREE.Mesh[] = [];
  private readonly line: THREE.Line;

  constructor() {
    const ball = new THREE.SphereGeometry(1, 14, 10);
    for (let k = 0; k < 2; ++k) this.ends.push(new THREE.Mesh(ball, new THREE.MeshBasicMaterial({ color: colour, depthTest: false, transparent: true })));
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(6), 3));
    this.line = new THREE.Line(geometry, new THREE.LineBasicMaterial({ color: colour, depthTest: false, transparent: true }));
    this.line.frustumCulled = false;
    for (const part of [...this.ends, this.line]) { part.renderOrder = 11; this.group.add(part); }
    this.set([]);
  }

  set(points: readonly Vector[]): void {
    const attribute = this.line.geometry.getAttribute('position') as THREE.BufferAttribute;
    points.forEach((p, k) => { attribute.setXYZ(k, ...p); this.ends[k]!.position.set(...p); });
    attribute.needsUpdate = true;
    this.ends.forEach((end, k) => { end.visible = k < points.length; });
    this.line.visible = points.length === 2;
  }

  /** `pixel`: world size of a pixel at unit distance. */
  face(camera: THREE.Camera, pixel: number): void {
    for (const end of this.ends) end.scale.setScalar(4 * pixel * camera.position.distanceTo(end.position));
  }
}
