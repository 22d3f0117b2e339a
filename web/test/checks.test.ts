import { describe, expect, test } from 'vitest';
import { governing, level, ranked } from '../src/logic/checks';
import type { Check } from '../src/api/types';

const check = (id: string, region: Check['region'], utilisation: number | undefined, more: Partial<Check> = {}): Check => ({
  id, name: id, code: '', clause: '', region, governing: true, remark: '',
  status: utilisation === undefined ? 'not done' : utilisation > 1 ? 'exceeded' : 'passed', utilisation, ...more,
});

describe('code checks', () => {
  const all = [
    check('collapse', 'line', 0.2),
    check('propagation', 'line', 3, { governing: false }),
    check('load', 'sagbend', 0.4), check('stress', 'sagbend', 0.9), check('api', 'sagbend', 1.2, { status: 'outside validity' }),
    check('strain', 'overbend', 1.1), check('second', 'overbend', undefined),
  ];
  test('the most used of those that decide stands for its region, tensioner first', () => {
    expect(governing(all).map((c) => c.id)).toEqual(['strain', 'stress', 'collapse']);
    expect(governing([])).toEqual([]);
  });
  test('information and what could not be judged come last', () => {
    expect(ranked(all).map((c) => c.id)).toEqual(['strain', 'stress', 'load', 'collapse', 'propagation', 'api', 'second']);
  });
  test('only what decides is good or bad', () => {
    expect(all.map(level)).toEqual(['good', 'open', 'good', 'near', 'open', 'over', 'open']);
  });
});
