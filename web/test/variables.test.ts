import { describe, expect, test } from 'vitest';
import { readBase } from '../src/logic/live';
import { findPassIntervals, passSentence, type Judgement } from '../src/logic/passRange';
import { currentFactor, findVariable, keyVariable, onStep, readBounds, roundEnds, usualVariables, variableEnds, variableName, variableStep, type NumericField } from '../src/logic/variables';

const quantity = (path: string, value: string, si: number, range = ''): NumericField => ({ path, kind: 'quantity', value, si, unit: value.split(' ')[1] ?? '', given: true, range });
const list: NumericField[] = [
  quantity('tensioner.tension', '250 kN', 250e3, 'above 0 kN and at most 100000 kN'),
  quantity('environment.water_depth', '89 m', 89),
  quantity('pipe.steel.wall_thickness', '11.1 mm', 0.0111, 'above 0 mm and at most 1000 mm'),
  quantity('supports.stinger.boxes[2].z', '-6.5 m', -6.5),
  { path: 'supports.stinger.boxes[2].name', kind: 'text', value: 'last', si: null },
  quantity('vessel.stiffness', '20 kN*s^2', 20e3),
  { path: 'friction', kind: 'number', value: null, default: '0.1', si: null, given: false },
  { path: 'title', kind: 'text', value: 'BGL-1', si: null },
];
const base = readBase(list);
const variable = (path: string) => keyVariable(base.fields.get(path), base.fields)!;

describe('a variable', () => {
  test('every numeric key is one, with its default where it is left out', () => {
    expect(variable('friction').si).toBe(0.1);
    expect(variable('title')).toBeNull();
    expect(variable('vessel.stiffness').scale).toBe(1000); // a unit that the page does not support
  });
  test('names are short and distinguish boxes', () => {
    expect(variable('tensioner.tension').name).toBe('tension');
    expect(variable('pipe.steel.wall_thickness').name).toBe('wall thickness');
    expect(variableName('supports.stinger.boxes[2].z', base.fields)).toBe('last z');
    expect(variableName('supports.stinger.boxes[1].z', base.fields)).toBe('stinger 2 z');
    expect(variableName('environment.waves.hs', base.fields)).toBe('waves Hs');
  });
  test('the step follows from size and unit', () => {
    expect(variableStep(variable('tensioner.tension'))).toBe(1);
    expect(variableStep(variable('environment.water_depth'))).toBeCloseTo(0.1, 9);
    expect(variableStep(variable('pipe.steel.wall_thickness'))).toBeCloseTo(0.1, 9);
    expect(variableStep(variable('supports.stinger.boxes[2].z'))).toBe(0.01);
    expect(variableStep(variable('friction'))).toBeCloseTo(0.001, 9);
  });
  test('values come on whole steps within the bounds of the key', () => {
    expect(onStep(variable('tensioner.tension'), 250_400, 1)).toBe(250e3);
    expect(onStep(variable('tensioner.tension'), -5e3, 1)).toBe(1e3);
    expect(onStep(variable('pipe.steel.wall_thickness'), 0.01123, 0.1)).toBeCloseTo(0.0112, 9);
  });
  test('bounds are read from the range text of the program', () => {
    expect(readBounds('above 0 m and at most 12000 m', 1)).toEqual({ min: 0, max: 12000, openMin: true, openMax: false });
    expect(readBounds('from -90 deg to 90 deg', 1)).toEqual({ min: -90, max: 90, openMin: false, openMax: false });
    expect(readBounds('', 1)).toEqual({ min: -Infinity, max: Infinity, openMin: false, openMax: false });
  });
  test('ends of its slider are round', () => {
    expect(roundEnds(250, 0.4, 2)).toEqual([100, 500]);
    expect(variableEnds(variable('tensioner.tension'))).toEqual([100e3, 650e3]);
    expect(variableEnds(variable('supports.stinger.boxes[2].z'))).toEqual([-7.5, -5.5]);
  });
});

describe('usual pins', () => {
  test('tension, depth and curvature of the overbend', () => {
    expect(usualVariables(base)).toEqual(['tensioner.tension', 'environment.water_depth']);
    const tower = readBase([...list, quantity('tensioner.incline', '70 deg', 1.22)]);
    expect(usualVariables(tower)).toEqual(['tensioner.tension', 'environment.water_depth', 'tensioner.incline']);
    expect(findVariable('tensioner.incline', tower)!.name).toBe('tower angle');
  });
  test('of a moored model without pipe depth, current and first line', () => {
    const moored = readBase([quantity('environment.water_depth', '89 m', 89), quantity('environment.current[0].speed', '0.5 m/s', 0.5), quantity('moorings.lines[0].length', '900 m', 900)]);
    expect(usualVariables(moored)).toEqual(['environment.water_depth', currentFactor, 'moorings.lines[0].length']);
  });
});

describe('the range in which every check passes', () => {
  const between = (low: number, high: number, otherwise: Judgement = 'exceeded') => (v: number): Promise<Judgement> => Promise.resolve(v >= low && v <= high ? 'passed' : otherwise);
  test('its ends are found to a thousandth of the slider', async () => {
    const found = await findPassIntervals(between(180, 340), 100, 600, 250);
    expect(found).toHaveLength(1);
    expect(found![0]!.from).toBeGreaterThanOrEqual(180);
    expect(found![0]!.from).toBeLessThan(181);
    expect(found![0]!.to).toBeGreaterThan(339);
    expect(passSentence(found!, (v) => `${Math.round(v)} kN`)).toMatch(/^every check passes from 18\d kN to 3\d\d kN$/);
  });
  test('values without an equilibrium do not pass, and a range may continue beyond the slider', async () => {
    const found = await findPassIntervals(between(180, 1e9, 'failed'), 100, 600, 250);
    expect(found).toMatchObject([{ fromOpen: false, toOpen: true }]);
    expect(passSentence(found!, String)).toMatch(/^every check passes above 18\d/);
  });
  test('reservations are reported', async () => {
    const found = await findPassIntervals((v) => Promise.resolve(v > 300 ? 'reserved' : 'passed'), 100, 600, 250);
    expect(passSentence(found!, String)).toBe('every check passes over the whole range (partly with reservations)');
  });
  test('a narrow range about the value itself is not missed', async () => {
    const found = await findPassIntervals(between(247, 253), 100, 600, 250);
    expect(found).toHaveLength(1);
  });
  test('without checks there is none, and no passing value is reported', async () => {
    expect(await findPassIntervals(() => Promise.resolve('open'), 0, 1, 0.5)).toBeNull();
    expect(passSentence((await findPassIntervals(() => Promise.resolve('exceeded'), 0, 1, 0.5))!, String)).toBe('no value of this slider passes every check');
  });
  test('values far beyond the range are not solved', async () => {
    const asked: number[] = [];
    await findPassIntervals((v) => { asked.push(v); return between(200, 300)(v); }, 100, 600, 250);
    expect(Math.max(...asked)).toBe(400);
  });
  test('values are judged from the present one outwards', async () => {
    const asked: number[] = [];
    await findPassIntervals((v) => { asked.push(v); return Promise.resolve('passed'); }, 0, 10, 4);
    expect(asked.slice(0, 4)).toEqual([4, 3, 5, 2]);
  });
});
