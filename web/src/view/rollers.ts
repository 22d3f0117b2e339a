// Rollers at their true positions: solid and coloured by the reaction if in contact, an outline if clear.
import * as THREE from 'three';
import type { Support } from '../api/types';
import { loadShares } from '../logic/colour';
import { vec } from './members';

const shape = new THREE.CylinderGeometry(1, 1, 1, 20, 1);
const up = new THREE.Vector3(0, 1, 0);

/** Lines of a hollow roller: two rings and four lines between, for unit radius and length along y. */
function outline(): THREE.Vector3[] {
  const out: THREE.Vector3[] = [];
  const n = 14;
  const vertex = (k: number, y: number): THREE.Vector3 => new THREE.Vector3(Math.cos((2 * Math.PI * k) / n), y, Math.sin((2 * Math.PI * k) / n));
  for (const y of [-0.5, 0.5]) for (let k = 0; k < n; ++k) out.push(vertex(k, y), vertex(k + 1, y));
  for (let k = 0; k < 4; ++k) { const a = (k * n) / 4; out.push(vertex(a, -0.5), vertex(a, 0.5)); }
  return out;
}
const lines = outline();
const nothing = new THREE.Matrix4().makeScale(0, 0, 0);

export interface RollerRef { support: Support; row: number; position: string; reaction: number; separation: number; center: THREE.Vector3; matrix: THREE.Matrix4 }

export class RollersView {
  readonly group = new THREE.Group();
  list: RollerRef[] = [];
  private solid: THREE.InstancedMesh | null = null;
  private readonly clear = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: '#3f5d78' }));
  private readonly material = new THREE.MeshStandardMaterial({ roughness: 0.5, metalness: 0.1 });
  private readonly faint = new THREE.MeshStandardMaterial({ color: '#9fb2c2', transparent: true, opacity: 0.22, depthWrite: false });
  private ghost: THREE.InstancedMesh | null = null;
  private places = new Float32Array(0);
  private readonly chosen = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: '#0b66c2', depthTest: false, transparent: true }));
  private chosenName: string | null = null;
  private shownReactions: Map<string, number> | null = null;

  constructor() {
    this.clear.frustumCulled = false;
    this.chosen.frustumCulled = false;
    this.chosen.renderOrder = 9;
    this.group.add(this.clear, this.chosen);
  }

  /** Outline of the rollers of the selected box, over everything. */
  choose(name: string | null): void {
    this.chosenName = name;
    this.outlineChosen();
  }

  private outlineChosen(): void {
    const corner = new THREE.Vector3();
    const grown = new THREE.Matrix4().makeScale(1.12, 1.06, 1.12);
    const points = this.list.filter((r) => r.support.name === this.chosenName).flatMap((r) => {
      const matrix = r.matrix.clone().multiply(grown);
      return lines.flatMap((p) => corner.copy(p).applyMatrix4(matrix).toArray());
    });
    this.chosen.visible = points.length > 0;
    if (points.length === 0) return;
    const had = this.chosen.geometry.getAttribute('position') as THREE.BufferAttribute | undefined;
    if (had?.array.length === points.length) { had.set(points); had.needsUpdate = true; return; }
    this.chosen.geometry.dispose();
    this.chosen.geometry = new THREE.BufferGeometry();
    this.chosen.geometry.setAttribute('position', new THREE.Float32BufferAttribute(points, 3));
  }

  set(supports: Support[], largest: number): void {
    const all = supports.flatMap((s) => s.rollers.map((r) => ({ s, r })));
    if (!this.solid || this.solid.instanceMatrix.count < all.length) {
      for (const old of [this.solid, this.ghost]) if (old) { this.group.remove(old); old.dispose(); }
      this.solid = new THREE.InstancedMesh(shape, this.material, Math.max(1, all.length));
      this.ghost = new THREE.InstancedMesh(shape, this.faint, Math.max(1, all.length));
      for (const mesh of [this.solid, this.ghost]) { mesh.frustumCulled = false; this.group.add(mesh); }
      this.places = new Float32Array(3 * lines.length * Math.max(1, all.length));
      this.clear.geometry.dispose();
      this.clear.geometry = new THREE.BufferGeometry();
      this.clear.geometry.setAttribute('position', new THREE.BufferAttribute(this.places, 3));
    }
    let lined = 0;
    const matrix = new THREE.Matrix4();
    const turn = new THREE.Quaternion();
    const corner = new THREE.Vector3();
    const colour = new THREE.Color();
    let clear = 0;
    this.list = [];
    const nextRow = new Map<Support, number>();
    all.forEach(({ s, r }, i) => {
      turn.setFromUnitVectors(up, vec(r.axis).normalize());
      matrix.compose(vec(r.center), turn, new THREE.Vector3(r.radius, r.face, r.radius));
      const touches = r.reaction > 0;
      // an instance of zero size is invisible: contact decides which of the two is drawn
      this.solid!.setMatrixAt(i, matrix);
      if (!touches) {
        this.ghost!.setMatrixAt(clear++, matrix);
        for (const p of lines) { corner.copy(p).applyMatrix4(matrix).toArray(this.places, lined); lined += 3; }
        this.solid!.setMatrixAt(i, nothing);
      }
      colour.setRGB(...loadShares(r.reaction / (largest || 1)), THREE.SRGBColorSpace);
      this.solid!.setColorAt(i, colour);
      if (r.position === 'bottom') nextRow.set(s, (nextRow.get(s) ?? -1) + 1);
      this.list.push({ support: s, row: nextRow.get(s) ?? 0, position: r.position, reaction: r.reaction, separation: r.separation, center: vec(r.center), matrix: matrix.clone() });
    });
    this.solid!.count = all.length;
    this.ghost!.count = clear;
    this.solid!.instanceMatrix.needsUpdate = true;
    this.ghost!.instanceMatrix.needsUpdate = true;
    if (this.solid!.instanceColor) this.solid!.instanceColor.needsUpdate = true;
    this.clear.geometry.getAttribute('position').needsUpdate = true;
    this.clear.geometry.setDrawRange(0, lined / 3);
    if (this.chosenName !== null) this.outlineChosen();
    if (this.shownReactions) this.setReactions(this.shownReactions, this.largestShown);
  }

  private largestShown = 1;

  /** In an animation: each box in the colour of its present reaction, grey if unknown. */
  setReactions(of: Map<string, number>, largest: number): void {
    if (!this.solid) return;
    this.shownReactions = of;
    this.largestShown = largest;
    const colour = new THREE.Color();
    this.list.forEach((r, i) => {
      const value = of.get(r.support.name);
      if (value === undefined) colour.setRGB(0.5, 0.53, 0.56, THREE.SRGBColorSpace);
      else if (value <= 0) colour.setRGB(0.75, 0.79, 0.82, THREE.SRGBColorSpace);
      else colour.setRGB(...loadShares(value / (largest || 1)), THREE.SRGBColorSpace);
      this.solid!.setColorAt(i, colour);
      this.solid!.setMatrixAt(i, r.matrix);
    });
    this.solid.instanceMatrix.needsUpdate = true;
    if (this.solid.instanceColor) this.solid.instanceColor.needsUpdate = true;
    this.ghost!.visible = this.clear.visible = false;
  }

  /** Returns to the static reactions; `set` follows. */
  endReactions(): void {
    this.shownReactions = null;
    if (this.ghost) this.ghost.visible = true;
    this.clear.visible = true;
  }
}
