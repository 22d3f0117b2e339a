// Every roller at its true place: solid and coloured by its reaction where the pipe rests on it, an outline where it is clear.
import * as THREE from 'three';
import type { Support } from '../api/types';
import { colourAt } from '../logic/colour';
import { vec } from './members';

const shape = new THREE.CylinderGeometry(1, 1, 1, 20, 1);
const up = new THREE.Vector3(0, 1, 0);

/** Lines of a hollow roller: two rings and four lines between, for unit radius and length along y. */
function outline(): THREE.Vector3[] {
  const out: THREE.Vector3[] = [];
  const n = 14;
  const at = (k: number, y: number): THREE.Vector3 => new THREE.Vector3(Math.cos((2 * Math.PI * k) / n), y, Math.sin((2 * Math.PI * k) / n));
  for (const y of [-0.5, 0.5]) for (let k = 0; k < n; ++k) out.push(at(k, y), at(k + 1, y));
  for (let k = 0; k < 4; ++k) { const a = (k * n) / 4; out.push(at(a, -0.5), at(a, 0.5)); }
  return out;
}
const lines = outline();

export interface RollerRef { support: Support; row: number; position: string; reaction: number; separation: number; center: THREE.Vector3 }

export class RollersView {
  readonly group = new THREE.Group();
  list: RollerRef[] = [];
  private solid: THREE.InstancedMesh | null = null;
  private readonly clear = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: '#3f5d78' }));
  private readonly material = new THREE.MeshStandardMaterial({ roughness: 0.5, metalness: 0.1 });
  private readonly faint = new THREE.MeshStandardMaterial({ color: '#9fb2c2', transparent: true, opacity: 0.22, depthWrite: false });
  private ghost: THREE.InstancedMesh | null = null;
  private base: THREE.Color[] = [];

  constructor() {
    this.clear.frustumCulled = false;
    this.group.add(this.clear);
  }

  set(supports: Support[], largest: number): void {
    const all = supports.flatMap((s) => s.rollers.map((r) => ({ s, r })));
    if (!this.solid || this.solid.instanceMatrix.count < all.length) {
      for (const old of [this.solid, this.ghost]) if (old) { this.group.remove(old); old.dispose(); }
      this.solid = new THREE.InstancedMesh(shape, this.material, Math.max(1, all.length));
      this.ghost = new THREE.InstancedMesh(shape, this.faint, Math.max(1, all.length));
      for (const mesh of [this.solid, this.ghost]) { mesh.frustumCulled = false; this.group.add(mesh); }
    }
    const places: number[] = [];
    const matrix = new THREE.Matrix4();
    const turn = new THREE.Quaternion();
    const corner = new THREE.Vector3();
    const colour = new THREE.Color();
    let clear = 0;
    this.list = [];
    this.base = [];
    const rowOf = new Map<Support, number>();
    all.forEach(({ s, r }, i) => {
      turn.setFromUnitVectors(up, vec(r.axis).normalize());
      matrix.compose(vec(r.center), turn, new THREE.Vector3(r.radius, r.face, r.radius));
      const touches = r.reaction > 0;
      // an instance of no size is not seen: contact decides which of the two is drawn
      this.solid!.setMatrixAt(i, matrix);
      if (!touches) {
        this.ghost!.setMatrixAt(clear++, matrix);
        for (const p of lines) places.push(...corner.copy(p).applyMatrix4(matrix).toArray());
        this.solid!.setMatrixAt(i, new THREE.Matrix4().makeScale(0, 0, 0));
      }
      colour.setRGB(...colourAt('load', r.reaction / (largest || 1)), THREE.SRGBColorSpace);
      this.base.push(colour.clone());
      this.solid!.setColorAt(i, colour);
      if (r.position === 'bottom') rowOf.set(s, (rowOf.get(s) ?? -1) + 1);
      this.list.push({ support: s, row: rowOf.get(s) ?? 0, position: r.position, reaction: r.reaction, separation: r.separation, center: vec(r.center) });
    });
    this.solid!.count = all.length;
    this.ghost!.count = clear;
    this.solid!.instanceMatrix.needsUpdate = true;
    this.ghost!.instanceMatrix.needsUpdate = true;
    if (this.solid!.instanceColor) this.solid!.instanceColor.needsUpdate = true;
    this.clear.geometry.dispose();
    this.clear.geometry = new THREE.BufferGeometry();
    this.clear.geometry.setAttribute('position', new THREE.Float32BufferAttribute(places, 3));
  }
}
