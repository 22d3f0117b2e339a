// The study file that the page writes, and where its cases lie in a chart.
import { expect, test } from 'vitest';
import type { Matrix, MatrixCase } from '../src/api/types';
import { axisYaml, caseCount, cellsOver, spreadAxes, studyFault, studyYaml, tally, worstValue, type StudyWish } from '../src/logic/studies';

const wish: StudyWish = { analysis: 'static', axes: [{ key: 'tensioner.tension', values: '200 kN..400 kN/21' }, { key: 'environment.water_depth', values: '80, 89, 100 m' }], seeds: '', duration: '', gather: '', limit: '' };
const units = (key: string): string => (key === 'tensioner.tension' ? 'kN' : 'm');

test('axes are ranges or lists, and numbers take the unit of their key', () => {
  expect(axisYaml(wish.axes[0]!, 'kN')).toBe('{key: tensioner.tension, from: 200 kN, to: 400 kN, steps: 21}');
  expect(axisYaml(wish.axes[1]!, 'm')).toBe('{key: environment.water_depth, values: [80 m, 89 m, 100 m]}');
  expect(axisYaml({ key: 'environment.waves.type', values: 'jonswap, pierson_moskowitz' }, '')).toBe('{key: environment.waves.type, values: [jonswap, pierson_moskowitz]}');
  expect(axisYaml({ key: 'tensioner.tension', values: 'much..more/3' }, 'kN')).toBeNull();
  expect(axisYaml({ key: 'supports.stinger.boxes[stinger 3].z', values: '1 m' }, 'm')).toContain('"supports.stinger.boxes[stinger 3].z"');
});

test('every combination is a case, with every seed in time', () => {
  expect(caseCount(wish)).toBe(63);
  expect(caseCount({ ...wish, seeds: '1-5' })).toBe(63);
  expect(caseCount({ ...wish, analysis: 'dynamic', seeds: '1-5' })).toBe(315);
});

test('the file has what the form says', () => {
  const text = studyYaml({ ...wish, analysis: 'dynamic', seeds: '1-2', duration: '60 s', gather: 'dynamic.top_tension.max', limit: 'environment.water_depth' }, 'lay.yaml', units);
  expect(text).toContain('analysis: dynamic\nduration: 60 s\naxes:\n  - {key: tensioner.tension');
  expect(text).toContain('seeds: [1, 2]\ngather: [dynamic.top_tension.max]\noperability: {over: environment.water_depth, criterion: checks}\n');
});

test('what cannot be asked for is said before it is sent', () => {
  expect(studyFault(wish, units)).toBeNull();
  expect(studyFault({ ...wish, axes: [] }, units)).toMatch(/choose a key/);
  expect(studyFault({ ...wish, axes: [{ key: 'tensioner.tension', values: '' }] }, units)).toMatch(/values like/);
  expect(studyFault({ ...wish, axes: [wish.axes[0]!, wish.axes[0]!] }, units)).toMatch(/once/);
  expect(studyFault({ ...wish, limit: 'vessel.trim' }, units)).toMatch(/not one/);
});

const one = (number: number, at: number[], value: number | null, more: Partial<MatrixCase> = {}): MatrixCase =>
  ({ number, at, words: [], inputs: [], seed: null, state: value === null ? 'failed' : 'done', values: [value], passed: value !== null && value < 10, verdict: value === null ? 'not judged' : value < 10 ? 'passed' : 'exceeded', obstacle: '', governing: '', utilisation: null, reason: '', ...more });
const axis = (key: string, words: string[], more = {}) => ({ key, unit: '', with: '', sampled: false, words, values: words.map(Number), ...more });
const matrix = (cases: MatrixCase[]): Matrix => ({ title: '', analysis: 'static', inputs: [axis('a', ['1', '2']), axis('b', ['1', '2', '3']), axis('c', ['1', '2'], { with: 'a' })], outputs: [{ name: 'x.max', unit: '' }], cases, operability: null, findings: [] });

test('cells lie where their values are, and tell of what failed', () => {
  const m = matrix([one(0, [0, 0, 0], 1), one(1, [0, 1, 0], 20), one(2, [0, 2, 0], null), one(3, [1, 0, 1], 4), one(4, [1, 1, 1], 5, { state: 'open' })]);
  expect(spreadAxes(m)).toEqual([0, 1]);
  const cells = cellsOver(m, [0, 1], {}, 0);
  expect(cells.map((row) => row.map((c) => c.state))).toEqual([['passed', 'passed'], ['exceeded', 'open'], ['failed', 'open']]);
  expect(cells[1]![0]!.value).toBe(20);
  expect(cellsOver(m, [1], { 0: 1 }, 0)[0]!.map((c) => c.value)).toEqual([4, 5, null]);
  expect(tally(m)).toBe('5 cases: 2 pass, 1 exceed a check, 1 have no solution, 1 still to come');
});

test('a case with a serious finding passes with reservations, one that nothing judges does not pass', () => {
  const m = matrix([one(0, [0, 0, 0], 1, { verdict: 'reserved', passed: false, obstacle: 'pipe-off-rollers' }), one(1, [0, 1, 0], 1, { verdict: 'not judged', passed: false }), one(2, [0, 2, 0], 1)]);
  expect(tally(m)).toBe('3 cases: 1 pass, 1 pass with reservations, 1 solved, not judged');
  expect(cellsOver(m, [0, 1], {}, 0).map((row) => row[0]!.state)).toEqual(['reserved', 'not judged', 'passed']);
});

test('of several seeds the one farther out counts', () => {
  const seeds = [one(0, [], 3), one(1, [], 5), one(2, [], null)];
  expect(worstValue(seeds, 0, 'dynamic.top_tension.max')).toBe(5);
  expect(worstValue(seeds, 0, 'dynamic.top_tension.min')).toBe(3);
  expect(worstValue([one(0, [], null)], 0, 'x')).toBeNull();
});
