// The barge: its profile extruded over the beam, with a slot aft in which the ramp is lower than the deck.
// The model gives main dimensions only; bow rake, house and crane show the forward direction.
import * as THREE from 'three';
import type { Scene, Vessel } from '../api/types';
import { vec } from './members';

type Point = [number, number]; // x forward, z above water

/** Part of a closed outline above (or below) the water line. */
export function clip(outline: Point[], above: boolean): Point[] {
  const out: Point[] = [];
  const inside = (p: Point): boolean => (above ? p[1] >= 0 : p[1] <= 0);
  outline.forEach((p, i) => {
    const q = outline[(i + 1) % outline.length]!;
    if (inside(p)) out.push(p);
    if (inside(p) !== inside(q)) { const f = p[1] / (p[1] - q[1]); out.push([p[0] + f * (q[0] - p[0]), 0]); }
  });
  return out;
}

function strip(outline: Point[], from: number, to: number, material: THREE.Material): THREE.Mesh | null {
  if (outline.length < 3 || to - from < 1e-3) return null;
  const shape = new THREE.Shape(outline.map(([x, z]) => new THREE.Vector2(x, z)));
  const geometry = new THREE.ExtrudeGeometry(shape, { depth: to - from, bevelEnabled: false });
  // the outline lies in the x-z plane and is extruded to port (+y)
  geometry.applyMatrix4(new THREE.Matrix4().set(1, 0, 0, 0, 0, 0, -1, -from, 0, 1, 0, 0, 0, 0, 0, 1));
  return new THREE.Mesh(geometry, material);
}

const paint = {
  side: new THREE.MeshStandardMaterial({ color: '#2f4f6b', roughness: 0.8, side: THREE.DoubleSide }),
  bottom: new THREE.MeshStandardMaterial({ color: '#8a3a2e', roughness: 0.9, side: THREE.DoubleSide }),
  house: new THREE.MeshStandardMaterial({ color: '#e8ecef', roughness: 0.8 }),
  glass: new THREE.MeshStandardMaterial({ color: '#24323f', roughness: 0.3 }),
  crane: new THREE.MeshStandardMaterial({ color: '#e0a526', roughness: 0.7 }),
  edge: new THREE.LineBasicMaterial({ color: '#1b2f41', transparent: true, opacity: 0.55 }),
};

/** At close range the hull is transparent, to show ramp and rollers in its slot. */
export function seeThrough(on: boolean): boolean {
  if (paint.side.transparent === on) return false;
  for (const m of [paint.side, paint.bottom]) { m.transparent = on; m.opacity = on ? 0.3 : 1; m.depthWrite = !on; m.needsUpdate = true; }
  return true;
}

/** In the vessel frame. `lowest`: for x forward, the maximum height of the middle of the deck below the pipe, or null. */
export function hull(vessel: Vessel, lowest: (x: number) => number | null): THREE.Group {
  const group = new THREE.Group();
  const { length, beam, height, draught } = vessel;
  const deck = height - draught;
  const stern = -length / 2;
  const under: Point[] = [[stern, -0.35 * draught], [stern + 0.05 * length, -draught], [length / 2 - 0.13 * length, -draught], [length / 2, 0.1 * draught], [length / 2, deck]];
  const outline: Point[] = [[stern, deck], ...under];

  const slotDeck: Point[] = [];
  const count = 48;
  for (let i = 0; i <= count; ++i) {
    const x = stern + (0.75 * length * i) / count;
    const z = lowest(x);
    slotDeck.push([x, Math.max(-0.2 * draught, z === null ? deck : Math.min(deck, z))]);
  }
  const slotted = slotDeck.some((p) => p[1] < deck - 0.05);
  const middle: Point[] = [...slotDeck.reverse(), ...under.map((p, i): Point => (i === 0 ? [p[0], Math.min(p[1], slotDeck[slotDeck.length - 1]![1] - 0.1)] : p))];
  const slot = slotted ? Math.min(2.2, beam / 6) : 0;

  const strips: [Point[], number, number][] = [[outline, -beam / 2, -slot], [outline, slot, beam / 2]];
  if (slotted) strips.push([middle, -slot, slot]);
  for (const [profile, from, to] of strips) {
    for (const above of [true, false]) {
      const mesh = strip(clip(profile, above), from, to, above ? paint.side : paint.bottom);
      if (!mesh) continue;
      group.add(mesh);
      if (above) group.add(new THREE.LineSegments(new THREE.EdgesGeometry(mesh.geometry, 30), paint.edge));
    }
  }

  const box = (sx: number, sy: number, sz: number, x: number, y: number, z: number, material: THREE.Material): void => {
    const mesh = new THREE.Mesh(new THREE.BoxGeometry(sx, sy, sz), material);
    mesh.position.set(x, y, z + sz / 2);
    group.add(mesh);
  };
  const u = Math.min(1, length / 100);
  const front = length / 2 - 0.17 * length;
  box(0.11 * length, 0.7 * beam, 5 * u, front, 0, deck, paint.house);
  box(0.08 * length, 0.55 * beam, 3 * u, front, 0, deck + 5 * u, paint.house);
  box(0.05 * length, 0.6 * beam, 2.6 * u, front + 0.01 * length, 0, deck + 8 * u, paint.house);
  box(0.051 * length, 0.56 * beam, 1.1 * u, front + 0.0115 * length, 0, deck + 9 * u, paint.glass);
  const crane = { x: 0.08 * length, y: 0.36 * beam };
  box(3 * u, 3 * u, 8 * u, crane.x, crane.y, deck, paint.crane);
  const boom = new THREE.Mesh(new THREE.BoxGeometry(0.3 * length, 1.2 * u, 1.2 * u), paint.crane);
  boom.position.set(crane.x + 0.13 * length, crane.y, deck + 9.5 * u + 0.045 * length);
  boom.rotation.y = -0.3;
  group.add(boom);
  return group;
}

/** Maximum deck height below the pipe at a position along the vessel: just over a metre below the rollers. */
export function slotDepth(scene: Scene, restPose: THREE.Matrix4): (x: number) => number | null {
  const inverse = restPose.clone().invert();
  const list = [...(scene.tensioner ? [scene.tensioner] : []), ...scene.ramp.map((b) => b.place), ...scene.stinger.slice(0, 1).map((b) => b.place)]
    .map((p) => vec(p).applyMatrix4(inverse)).sort((a, b) => a.x - b.x);
  return (x) => {
    if (!list.length || x > list[list.length - 1]!.x) return null;
    const i = Math.max(1, list.findIndex((p) => p.x >= x));
    const a = list[i - 1]!, b = list[i] ?? a;
    const f = b.x === a.x ? 0 : (x - a.x) / (b.x - a.x);
    return a.z + f * (b.z - a.z) - 1.1;
  };
}
