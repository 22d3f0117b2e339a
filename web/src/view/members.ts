// Straight round members (chords, braces, posts) as one instanced cylinder.
import * as THREE from 'three';

export type Member = [THREE.Vector3, THREE.Vector3, number];

const cylinder = new THREE.CylinderGeometry(1, 1, 1, 8, 1, false);
const up = new THREE.Vector3(0, 1, 0);

export function members(list: Member[], material: THREE.Material): THREE.InstancedMesh {
  const mesh = new THREE.InstancedMesh(cylinder, material, list.length);
  const matrix = new THREE.Matrix4();
  const turn = new THREE.Quaternion();
  const along = new THREE.Vector3();
  const middle = new THREE.Vector3();
  list.forEach(([a, b, radius], i) => {
    along.subVectors(b, a);
    const length = along.length() || 1e-6;
    turn.setFromUnitVectors(up, along.divideScalar(length));
    matrix.compose(middle.addVectors(a, b).multiplyScalar(0.5), turn, new THREE.Vector3(radius, length, radius));
    mesh.setMatrixAt(i, matrix);
  });
  mesh.frustumCulled = false;
  return mesh;
}

export function dispose(group: THREE.Object3D): void {
  group.traverse((o) => {
    const mesh = o as THREE.Mesh;
    if (mesh.geometry && mesh.geometry !== cylinder) mesh.geometry.dispose();
  });
  group.clear();
}

export const vec = (p: ArrayLike<number>): THREE.Vector3 => new THREE.Vector3(p[0], p[1], p[2]);
