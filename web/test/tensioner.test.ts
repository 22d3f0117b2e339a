import { describe, expect, test } from 'vitest';
import { LatestGate } from '../src/logic/gate';
import { liveScene } from '../src/logic/liveScene';
import { columnName, tensionerState } from '../src/logic/tensioner';
import { tube } from '../src/logic/tube';
import type { Scene } from '../src/api/types';

describe('the tensioner', () => {
  test('its states have labels', () => {
    expect([0, 1, 2, 3, 4].map((v) => tensionerState(v)?.label)).toEqual(['holds', 'in delay', 'pays out', 'hauls in', 'at its limit']);
    expect(tensionerState(null)).toBeNull();
    expect(tensionerState(7)).toBeNull();
  });
  test('histories have names that differ', () => {
    const names = ['tensioner/tension', 'tensioner/travel', 'support/stinger 8/reaction', 'support/stinger 9/reaction', 'support/stinger 8/separation', 'overbend_von_mises', 'overbend_von_mises_peak'].map(columnName);
    expect(new Set(names).size).toBe(names.length);
    expect(columnName('support/stinger 8/reaction')).toBe('stinger 8: reaction');
    expect(columnName('overbend_von_mises_peak')).toBe('Overbend von Mises, peak');
  });
});

test('the next request is sent before the last answer is processed', async () => {
  const order: string[] = [];
  const gate = new LatestGate<number, number>(async (r) => { order.push(`ask ${r}`); await Promise.resolve(); return r; }, (a) => { order.push(`take ${a}`); }, () => order.push('failed'));
  gate.submit(1);
  gate.submit(2);
  gate.submit(3);
  await new Promise((done) => setTimeout(done, 5));
  expect(order).toEqual(['ask 1', 'ask 3', 'take 1', 'take 3']);
  expect(gate.inFlight).toBe(false);
});

describe('the fixed scene', () => {
  const scene = { water_depth: 90, seabed: { normal: [0, 0, 1], point: [1, 2, -90] }, vessel: { pose: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1] } } as unknown as Scene;
  test('is the same without trial values', () => expect(liveScene(scene, undefined, undefined, 0)).toBe(scene));
  test('the seabed goes down with the depth', () => expect(liveScene(scene, 100, undefined, 0)).toMatchObject({ water_depth: 100, seabed: { point: [1, 2, -100] } }));
  test('a trim lifts the bow', () => {
    const { pose } = liveScene(scene, undefined, 0.1, 0).vessel!;
    expect(pose[9]).toBeCloseTo(Math.sin(0.1)); // z of the forward axis
    expect(pose[5]).toBeCloseTo(-Math.sin(0.1));
    expect(pose[3]).toBeCloseTo(Math.cos(0.1));
  });
});

test('a tube is made within what is there when it is large enough', () => {
  const large = tube(new Float32Array(30), 6);
  const small = tube([0, 0, 0, 1, 0, 0, 2, 0, 0], 6, large);
  expect(small).toBe(large);
  expect(small.stations).toBe(3);
  expect(small.centres[2 * 18]).toBe(2);
});
