import { describe, expect, test } from 'vitest';
import { governing, level, ranked, sheetTitle, sheetValue } from '../src/logic/checks';
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
  test('information and what could not be judged come last', () => {
    expect(ranked(all).map((c) => c.id)).toEqual(['strain', 'stress', 'load', 'collapse', 'propagation', 'api', 'second']);
  });
  test('only what decides is good or bad', () => {
    expect(all.map(level)).toEqual(['good', 'open', 'good', 'near', 'open', 'over', 'open']);
  });
});

describe('a line of a calculation sheet', () => {
  const line = (more: Partial<SheetLine>): SheetLine => ({
    symbol: 'f_y', meaning: '', formula: 'alpha_U SMYS', value: 430.08e6, units: 'Pa', origin: '5.3.3', confirmation: 'one source', sources: 'RigidPipe', ...more,
  });
  test('has its value in the units of the trade, with six digits', () => {
    expect(sheetValue(line({}))).toBe('430.08 MPa');
    expect(sheetValue(line({ value: 0.0111251234, units: 'm' }))).toBe('11.1251 mm');
    expect(sheetValue(line({ value: 1.15, units: '1' }))).toBe('1.15');
    expect(sheetValue(line({ value: 2, units: '1/s' }))).toBe('2 1/s');
  });
  test('says what confirms it, and what nobody could', () => {
    expect(sheetTitle(line({}))).toBe('Confirmed by one source: RigidPipe');
    expect(sheetTitle(line({ confirmation: 'unconfirmed', sources: '' }))).toBe('Recalled, not confirmed by a public text');
    expect(sheetTitle(line({ confirmation: 'not needed' }))).toBe('5.3.3');
  });
});
