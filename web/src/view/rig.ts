// Ramp, stinger and tensioner, drawn from the positions of the roller boxes: the structure between them is schematic.
import * as THREE from 'three';
import type { Lay, Scene, Support, TensionerPlace } from '../api/types';
import { members, vec, type Member } from './members';

const steel = new THREE.MeshStandardMaterial({ color: '#d8a437', roughness: 0.75, metalness: 0.1 });
const grey = new THREE.MeshStandardMaterial({ color: '#7d8a96', roughness: 0.8 });
const machine = new THREE.MeshStandardMaterial({ color: '#c2452d', roughness: 0.6 });
const dark = new THREE.MeshStandardMaterial({ color: '#2b3640', roughness: 0.7 });

interface Frame { place: THREE.Vector3; along: THREE.Vector3; side: THREE.Vector3; up: THREE.Vector3; length: number }

/** Frames of the boxes of one structure, from the bow astern. */
function frames(supports: Support[], scene: Scene, structure: 'ramp' | 'stinger'): Frame[] {
  const fixed = new Map(scene[structure].map((b) => [b.name, b]));
  const list = supports.filter((s) => s.structure === structure);
  return list.map((s, i) => {
    const place = vec(s.place);
    const before = vec((list[i - 1] ?? s).place), after = vec((list[i + 1] ?? s).place);
    const fixedBox = fixed.get(s.name);
    // a dragged box has left its position in the fixed scene: its direction then follows from its neighbours
    const moved = !fixedBox || vec(fixedBox.place).distanceTo(place) > 1e-3;
    const along = (moved && list.length > 1 ? after.clone().sub(before) : fixedBox ? vec(fixedBox.direction) : new THREE.Vector3(-1, 0, 0)).normalize();
    const side = new THREE.Vector3(0, 0, 1).cross(along).normalize();
    return { place, along, side, up: along.clone().cross(side).normalize(), length: fixed.get(s.name)?.length || 1 };
  });
}

const pointAt = (f: Frame, along: number, side: number, up: number): THREE.Vector3 =>
  f.place.clone().addScaledVector(f.along, along).addScaledVector(f.side, side).addScaledVector(f.up, up);

function truss(list: Frame[], half: number, top: number, deep: number): Member[] {
  const out: Member[] = [];
  const sections = list.flatMap((f) => [-0.5, 0.5].map((k) => {
    const a = k * f.length;
    return [pointAt(f, a, half, top), pointAt(f, a, -half, top), pointAt(f, a, half * 0.8, -deep), pointAt(f, a, -half * 0.8, -deep)];
  }));
  sections.forEach((s, i) => {
    out.push([s[0]!, s[1]!, 0.09], [s[0]!, s[2]!, 0.07], [s[1]!, s[3]!, 0.07], [s[2]!, s[3]!, 0.07]);
    const next = sections[i + 1];
    if (!next) return;
    for (let k = 0; k < 4; ++k) out.push([s[k]!, next[k]!, k < 2 ? 0.17 : 0.14]);
    out.push([s[2]!, next[0]!, 0.06], [s[3]!, next[1]!, 0.06]);
    out.push(i % 2 ? [s[2]!, next[3]!, 0.05] : [s[3]!, next[2]!, 0.05]);
  });
  return out;
}

export function rig(solution: Lay, scene: Scene): THREE.Group {
  const group = new THREE.Group();
  const deck = scene.vessel ? scene.vessel.height - scene.vessel.draught : 0;
  const stinger = frames(solution.supports, scene, 'stinger');
  if (stinger.length && scene.stern_shoe) {
    const list = truss(stinger, 0.95, -0.55, 2.1);
    group.add(members(list, steel));
    // hinge to the stern
    const first = stinger[0]!;
    const shoe = vec(scene.stern_shoe);
    const hitch: Member[] = [-1, 1].flatMap((k): Member[] => [
      [pointAt(first, -first.length / 2, 0.95 * k, -0.55), shoe.clone().addScaledVector(first.side, 1.5 * k).add(new THREE.Vector3(0, 0, -1)), 0.16],
      [pointAt(first, -first.length / 2, 0.76 * k, -2.1), shoe.clone().addScaledVector(first.side, 1.5 * k).add(new THREE.Vector3(0, 0, -3.2)), 0.13],
    ]);
    group.add(members(hitch, steel));
  }
  const posts: Member[] = [];
  for (const f of frames(solution.supports, scene, 'ramp')) {
    for (const a of [-0.5, 0.5]) {
      for (const k of [-0.75, 0.75]) {
        const head = pointAt(f, a * f.length, k, -0.45);
        const foot = head.clone();
        foot.z = Math.min(deck, head.z - 0.7);
        posts.push([head, foot, 0.11]);
      }
      posts.push([pointAt(f, a * f.length, -0.75, -0.45), pointAt(f, a * f.length, 0.75, -0.45), 0.1]);
    }
    for (const k of [-0.75, 0.75]) posts.push([pointAt(f, -f.length / 2, k, -0.45), pointAt(f, f.length / 2, k, -0.45), 0.1]);
  }
  if (posts.length) group.add(members(posts, grey));
  if (solution.tensioner) group.add(tensioner(solution.tensioner, scene, deck));
  return group;
}

/** Two tracks that grip the pipe. */
function tensioner(gripped: TensionerPlace, scene: Scene, deck: number): THREE.Group {
  const group = new THREE.Group();
  const r = scene.pipe.outer_radius;
  const along = vec(gripped.direction).normalize();
  const side = new THREE.Vector3(0, 0, 1).cross(along);
  if (side.lengthSq() < 1e-6) side.set(0, 1, 0);
  side.normalize();
  const up = along.clone().cross(side);
  const turn = new THREE.Matrix4().makeBasis(along, side, up);
  const place = vec(gripped.place).addScaledVector(along, -2.2);
  for (const k of [-1, 1]) {
    const track = new THREE.Mesh(new THREE.BoxGeometry(4.4, 0.9, 0.55), dark);
    const cover = new THREE.Mesh(new THREE.BoxGeometry(4.8, 1.2, 0.6), machine);
    for (const [mesh, off] of [[track, r + 0.3], [cover, r + 0.8]] as const) {
      mesh.setRotationFromMatrix(turn);
      mesh.position.copy(place).addScaledVector(up, k * off);
      group.add(mesh);
    }
  }
  const legs: Member[] = [];
  for (const a of [-2, 2]) for (const k of [-1, 1]) {
    const top = place.clone().addScaledVector(along, a).addScaledVector(side, k * 0.85).addScaledVector(up, r + 1.1);
    const foot = top.clone();
    foot.z = Math.min(deck, top.z - 2 * r - 2.4);
    legs.push([top, foot, 0.12]);
  }
  group.add(members(legs, machine));
  return group;
}
