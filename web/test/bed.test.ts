import { describe, expect, test } from 'vitest';
import { bedHeight } from '../src/logic/bed';

describe('height of the seabed', () => {
  test('of a plane follows its normal', () => expect(bedHeight({ normal: [0.1, 0, 1], point: [0, 0, -50] }, 10, 3)).toBeCloseTo(-51, 12));
  const profile = { normal: [0, 0, 1] as [number, number, number], point: [0, 0, -50] as [number, number, number],
    shape: { x: [0, 10, 30], z: [-50, -48, -49], origin: [5, 0] as [number, number], along: [-1, 0] as [number, number] } };
  test('of a profile is linear along it and level beyond', () => {
    expect(bedHeight(profile, 0, 7)).toBe(-49);
    expect(bedHeight(profile, 5, -3)).toBe(-50);
    expect(bedHeight(profile, 100, 0)).toBe(-50);
    expect(bedHeight(profile, -100, 0)).toBe(-49);
  });
  test('of a grid is bilinear between its knots', () => {
    const shape = { x: [0, 10], y: [0, 20], z: [-50, -52, -54, -56] };
    expect(bedHeight({ normal: [0, 0, 1], point: [0, 0, -50], shape }, 5, 10)).toBe(-53);
    expect(bedHeight({ normal: [0, 0, 1], point: [0, 0, -50], shape }, 99, 99)).toBe(-56);
  });
});
