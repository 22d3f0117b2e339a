import { expect, test } from 'vitest';
import type { Field } from '../src/api/types';
import { findSeekErrors, seekRemarks, seekRequest, initialSeek, usualBounds, variableKeys } from '../src/logic/seek';

const field = (path: string, si: number | null, unit: string, more: Partial<Field> = {}): Field => ({ path, kind: 'quantity', value: si, si, unit, default: null, given: true, line: 1, text: '', ...more });
const tension = field('tensioner.tension', 300e3, 'kN');
const height = field('supports.stinger.boxes[0].z', -4.5, 'm');

test('the tension comes first among the keys that can vary', () => {
  const keys = variableKeys([height, field('vessel.name', null, '', { kind: 'text' }), field('checks.wall_tolerance', 1e-3, 'mm'), tension]);
  expect(keys.map((f) => f.path)).toEqual(['tensioner.tension', 'supports.stinger.boxes[0].z']);
});

test('bounds are proposed around the present value', () => {
  expect(usualBounds(tension)).toEqual({ from: '150 kN', to: '450 kN' });
  expect(usualBounds(height)).toEqual({ from: '-5.5 m', to: '-3.5 m' });
});

test('a bare number takes the unit that belongs to it', () => {
  const goal = { name: 'bending', result: 'static.sagbend.max_bending_stress', unit: 'MPa', si: 74e6 };
  const request = { ...initialSeek(goal, tension), value: '65', relation: 'at_most' as const, from: '200' };
  expect(findSeekErrors(request)).toEqual([]);
  expect(seekRequest(request, goal, 'kN')).toEqual({ vary: { key: 'tensioner.tension', from: '200 kN', to: '450 kN' }, until: { result: 'static.sagbend.max_bending_stress', at_most: '65 MPa' } });
  expect(findSeekErrors({ ...request, from: 'low' })).toEqual([{ key: 'from', text: 'enter a number with its unit' }]);
});

test('discontinuities and further solutions are reported in the units of key and result', () => {
  const found = { found: true, why: null, answer: 1, unit: 'N', evaluations: 20, slope: 1, others: [310e3], jumps: [{ at: 334e3, below: 0.368, above: 0.332, why: 'stinger 5 loses contact' }], remarks: ['a remark'], keys: [], goals: [] };
  expect(seekRemarks(found, { name: '', result: '', unit: 'deg', si: 0 }, 'kN')).toEqual(['another solution: 310 kN', 'discontinuity at 334 kN: from 21.08 to 19.02 deg; stinger 5 loses contact', 'a remark']);
});
