import { describe, expect, test } from 'vitest';
import { drawnSheet, governing, level, ranked } from '../src/logic/checks';
import type { Check, SheetLine } from '../src/api/types';

const check = (id: string, region: Check['region'], utilisation: number | undefined, more: Partial<Check> = {}): Check => ({
  id, name: id, code: '', clause: '', region, governing: true, remark: '', line: '', sheet: [],
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
  test('checks for information and those not evaluated come last', () => {
    expect(ranked(all).map((c) => c.id)).toEqual(['strain', 'stress', 'load', 'collapse', 'propagation', 'api', 'second']);
  });
  test('only governing checks are good or bad', () => {
    expect(all.map(level)).toEqual(['good', 'open', 'good', 'near', 'open', 'over', 'open']);
  });
});

describe('a line of a calculation sheet', () => {
  const line = (more: Partial<SheetLine>): SheetLine => ({
    symbol: 'f_y', meaning: '', formula: 'alpha_U SMYS', value: 430.08e6, units: 'Pa', origin: '5.3.3', confirmation: 'one source', sources: 'RigidPipe', ...more,
  });
  const drawn = (more: Partial<SheetLine>) => drawnSheet([line(more)])[0]!;
  test('has its value in engineering units, with six digits', () => {
    expect(drawn({}).value).toBe('430.08 MPa');
    expect(drawn({ value: 0.0111251234, units: 'm' }).value).toBe('11.1251 mm');
    expect(drawn({ value: 1.15, units: '1' }).value).toBe('1.15');
    expect(drawn({ value: 2, units: '1/s' }).value).toBe('2 1/s');
  });
  test('names its confirmation, or that there is none', () => {
    expect(drawn({}).confirmed).toBe('Confirmed by one source: RigidPipe');
    expect(drawn({ confirmation: 'unconfirmed', sources: '' })).toMatchObject({ confirmed: 'Recalled, not confirmed by a public text', soft: true });
    expect(drawn({ confirmation: 'not needed' })).toMatchObject({ origin: '5.3.3', confirmed: '' });
  });
});
