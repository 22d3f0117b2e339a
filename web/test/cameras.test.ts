import * as THREE from 'three';
import { describe, expect, test } from 'vitest';
import { shot } from '../src/view/cameras';
import type { Lay, Scene } from '../src/api/types';

const camera = (): THREE.PerspectiveCamera => new THREE.PerspectiveCamera(32, 1.6, 0.2, 5000);
const pipe = { s: [0, 50, 100], x: [0, 50, 100], y: [0, 0, 0], z: [-80, -40, 4] };
const lay = { pipe, lines: [], supports: [], moorings: null, tensioner: null, touchdown: null } as unknown as Lay;
const line = { ...lay, pipe: { s: [], x: [], y: [], z: [] }, lines: [{ shape: [[0, 0, -10], [40, 0, -2]] }] } as unknown as Lay;
const noVessel = { vessel: null } as unknown as Scene;

describe('camera position', () => {
  test('before lines by themselves, their ends within the picture', () => {
    const to = shot('lines', line, noVessel, camera())!;
    expect([...to.eye.toArray(), ...to.target.toArray()].every(Number.isFinite)).toBe(true);
    expect(to.target.x).toBeGreaterThan(0);
    expect(to.target.x).toBeLessThan(40);
  });
  test('before the hull where thrusters hold it and there are no lines to look at', () => {
    const positioned = { ...line, lines: [], moorings: { rest: { moorings: [] } } } as unknown as Lay;
    const scene = { vessel: { pose: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], length: 120, beam: 30, height: 9 } } as unknown as Scene;
    for (const view of ['moorings', 'vessel'] as const) {
      const to = shot(view, positioned, scene, camera())!;
      expect([...to.eye.toArray(), ...to.target.toArray()].every(Number.isFinite)).toBe(true);
      expect(to.target.length()).toBeLessThan(30);
    }
  });
  test('nowhere while scene and solution are of different models', () => expect(shot('whole', lay, noVessel, camera())).toBeNull());
});
