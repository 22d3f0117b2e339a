// Camera positions of the view buttons.
import * as THREE from 'three';
import type { Lay, Scene, Vessel } from '../api/types';
import { onLines, type ViewName } from '../logic/views';
import { vec } from './members';

export interface Shot { eye: THREE.Vector3; target: THREE.Vector3 }

export function axes(vessel: Vessel): { forward: THREE.Vector3; port: THREE.Vector3 } {
  const p = vessel.pose;
  return { forward: new THREE.Vector3(p[3], p[6], 0).normalize(), port: new THREE.Vector3(p[4], p[7], 0).normalize() };
}

/** Camera position for a set of points: far enough to show all of them from a direction. */
function around(points: THREE.Vector3[], from: THREE.Vector3, camera: THREE.PerspectiveCamera, margin = 1.08): Shot {
  const box = new THREE.Box3().setFromPoints(points);
  const target = box.getCenter(new THREE.Vector3());
  const back = from.clone().normalize();
  const right = new THREE.Vector3(0, 0, 1).cross(back).normalize();
  const up = back.clone().cross(right);
  const tv = Math.tan((camera.fov * Math.PI) / 360), th = tv * camera.aspect;
  let distance = 4;
  // near points look larger than far ones, so the centre of the picture is found iteratively
  for (let round = 0; round < 6; ++round) {
    distance = 4;
    for (const p of points) {
      const d = p.clone().sub(target);
      const depth = d.dot(back);
      distance = Math.max(distance, depth + (margin * Math.abs(d.dot(right))) / th, depth + (margin * Math.abs(d.dot(up))) / tv);
    }
    const span = [Infinity, -Infinity, Infinity, -Infinity];
    for (const p of points) {
      const d = p.clone().sub(target);
      const away = distance - d.dot(back);
      const u = d.dot(right) / away, v = d.dot(up) / away;
      span[0] = Math.min(span[0]!, u); span[1] = Math.max(span[1]!, u); span[2] = Math.min(span[2]!, v); span[3] = Math.max(span[3]!, v);
    }
    target.addScaledVector(right, (distance * (span[0]! + span[1]!)) / 2).addScaledVector(up, (distance * (span[2]! + span[3]!)) / 2);
  }
  return { eye: target.clone().addScaledVector(back, distance), target };
}

function along(s: Lay, from: number, to: number): THREE.Vector3[] {
  const { pipe } = s;
  const out: THREE.Vector3[] = [];
  for (let i = 0; i < pipe.s.length; ++i) if (pipe.s[i]! >= from && pipe.s[i]! <= to) out.push(new THREE.Vector3(pipe.x[i], pipe.y[i], pipe.z[i]));
  return out.length ? out : [new THREE.Vector3(pipe.x[0], pipe.y[0], pipe.z[0])];
}

const places = (points: readonly ArrayLike<number>[]): THREE.Vector3[] => points.map((p) => vec(p));

function vesselShot(vessel: Vessel, camera: THREE.PerspectiveCamera): Shot {
  const { forward, port } = axes(vessel);
  const origin = vec(vessel.pose), up = new THREE.Vector3(0, 0, vessel.height);
  const ends = [-0.5, 0.5].flatMap((k) => [-0.5, 0.5].map((m) => origin.clone().addScaledVector(forward, k * vessel.length).addScaledVector(port, m * vessel.beam)));
  return around([...ends, ...ends.map((p) => p.clone().add(up))], port.clone().negate().addScaledVector(forward, 0.5).addScaledVector(up, 0.45 / vessel.height), camera, 1.15);
}

/** Null if there is nothing to show: a scene without a vessel may arrive before its solution. */
export function shot(name: ViewName, s: Lay, scene: Scene, camera: THREE.PerspectiveCamera): Shot | null {
  const { vessel } = scene;
  if (name === 'lines' || !vessel) {
    const all = places(s.lines.flatMap((l) => l.shape));
    if (!all.length) return null;
    const box = new THREE.Box3().setFromPoints(all), size = box.getSize(new THREE.Vector3());
    // across their direction, slightly from above
    const across = size.x >= size.y ? new THREE.Vector3(0, -1, 0) : new THREE.Vector3(1, 0, 0);
    return around(all, across.add(new THREE.Vector3(-0.2, -0.05, 0.3)), camera, 1.25);
  }
  if (name === 'moorings' && s.moorings && onLines(s)) {
    const { forward, port } = axes(vessel);
    const all = places(s.moorings.rest.moorings.flatMap((l) => [l.anchor, l.fairlead]));
    return around(all, port.clone().negate().addScaledVector(forward, -0.35).add(new THREE.Vector3(0, 0, 1.1)), camera, 1.08);
  }
  if (s.pipe.s.length === 0) return vesselShot(vessel, camera);
  return layShot(name, s, scene, vessel, camera);
}

function layShot(name: ViewName, s: Lay, scene: Scene, vessel: Vessel, camera: THREE.PerspectiveCamera): Shot {
  const { forward, port } = axes(vessel);
  const starboard = port.clone().negate();
  const side = (ahead: number, up: number): THREE.Vector3 => starboard.clone().addScaledVector(forward, ahead).add(new THREE.Vector3(0, 0, up));
  const end = s.touchdown?.s ?? s.pipe.s[s.pipe.s.length - 1]!;
  const boxes = (structure?: string): THREE.Vector3[] => s.supports.filter((b) => !structure || b.structure === structure).map((b) => vec(b.place));
  const origin = vec(vessel.pose);
  switch (name) {
    case 'whole': {
      const bow = origin.clone().addScaledVector(forward, vessel.length / 2);
      const points = [...along(s, 0, end + 12), bow, bow.clone().add(new THREE.Vector3(0, 0, vessel.height + 4 + 0.07 * scene.water_depth))]; // with room for the buttons
      return around(points, side(-0.28, 0.3), camera, 1.1);
    }
    case 'overbend': {
      const list = boxes();
      const points = list.length && s.tensioner ? [...list, vec(s.tensioner.place)] : along(s, 0, 0.2 * end);
      return around(points, side(-0.4, 0.48), camera, 1.16);
    }
    case 'stinger': {
      const list = boxes('stinger');
      return around(list.length ? list : along(s, 0, 0.2 * end), side(-0.6, 0.3), camera, 1.2);
    }
    case 'sagbend': {
      const top = s.supports.filter((b) => b.contact).at(-1)?.s ?? 0;
      return around(along(s, top + 0.35 * (end - top), end + 15), side(-0.25, 0.25), camera, 1.1);
    }
    case 'touchdown': return around(along(s, end - 45, end + 25), side(0.5, 0.35), camera, 1.05);
    case 'from the pipe': {
      const tip = s.supports.filter((b) => b.structure === 'stinger').at(-1)?.s ?? 0;
      const place = along(s, tip + 0.14 * (end - tip), end)[0]!;
      const look = along(s, tip * 0.7, end)[0]!;
      return { eye: place.clone().addScaledVector(starboard, 2.2).add(new THREE.Vector3(0, 0, 2.6)), target: look };
    }
    default: return vesselShot(vessel, camera);
  }
}
