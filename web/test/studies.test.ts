// The study file of the page, and the layout of its cases in tables and charts.
import { expect, test } from 'vitest';
import type { Matrix, MatrixCase } from '../src/api/types';
import { depthLimits, findGridError, gridYaml, usualLimits } from '../src/logic/layGrid';
import { baseCase, cellsOver, governingChecks, gridAxes, kUtilisation, findShape, spreadAxes, swings, tally, worstValue } from '../src/logic/studies';
import { axisValues, axisYaml, caseCount, emptyAxis, roundRange, findStudyError, studyYaml, type AxisRequest, type ModelKeys, type StudyRequest } from '../src/logic/studyFile';
import { casesTable, decimals, studySheets, tensionTable } from '../src/logic/studyTables';

const tension: AxisRequest = { key: 'tensioner.tension', from: '200 kN', to: '400', count: '21', list: '' };
const depth: AxisRequest = { ...emptyAxis('environment.water_depth'), list: '80, 89, 100 m' };
const request: StudyRequest = { analysis: 'static', axes: [tension, depth], seeds: '', duration: '', gather: '', over: '', resolution: '' };
const model: ModelKeys = { unit: (key) => (key === 'tensioner.tension' ? 'kN' : 'm'), value: (key) => (key === 'tensioner.tension' ? '250 kN' : '89 m') };

test('axes are ranges or lists, and numbers take the unit of their key', () => {
  expect(axisYaml(tension, 'kN')).toBe('{key: tensioner.tension, from: 200 kN, to: 400 kN, steps: 21}');
  expect(axisYaml(depth, 'm')).toBe('{key: environment.water_depth, values: [80 m, 89 m, 100 m]}');
  expect(axisYaml({ ...emptyAxis('tensioner.tension'), list: '200 kN..400 kN/21' }, 'kN')).toBe(axisYaml(tension, 'kN'));
  expect(axisYaml({ ...emptyAxis('environment.waves.type'), list: 'jonswap, pierson_moskowitz' }, '')).toBe('{key: environment.waves.type, values: [jonswap, pierson_moskowitz]}');
  expect(axisYaml({ ...tension, from: 'much' }, 'kN')).toBeNull();
  expect(axisYaml({ ...emptyAxis('supports.stinger.boxes[stinger 3].z'), list: '1 m' }, 'm')).toContain('"supports.stinger.boxes[stinger 3].z"');
  expect(axisValues({ ...tension, to: '0.4 MN', count: '3' }, 'kN')).toEqual(['200 kN', '300 kN', '400 kN']);
});

test('every combination is a case, with every seed in time, and one at a time a case for each value', () => {
  expect(caseCount('study', request)).toBe(63);
  expect(caseCount('study', { ...request, seeds: '1-5' })).toBe(63);
  expect(caseCount('study', { ...request, analysis: 'dynamic', seeds: '1-5' })).toBe(315);
  expect(caseCount('operability', { ...request, over: 'tensioner.tension' })).toBe(3);
  expect(caseCount('each', request)).toBe(25);
});

test('the file has the values of the fields', () => {
  const text = studyYaml('study', { ...request, analysis: 'dynamic', seeds: '1-2', duration: '60 s', gather: 'dynamic.top_tension.max' }, 'lay.yaml', model);
  expect(text).toContain('analysis: dynamic\nduration: 60 s\naxes:\n  - {key: tensioner.tension');
  expect(text).toContain('seeds: [1, 2]\ngather: [dynamic.top_tension.max]\n');
  expect(studyYaml('operability', { ...request, over: 'environment.water_depth', resolution: '5' }, 'lay.yaml', model))
    .toContain('operability: {over: environment.water_depth, resolution: 5 m, criterion: checks}\n');
});

test('one at a time starts from the case of the model and changes one key in each case', () => {
  const axes = [{ ...tension, list: '240, 260' }, { ...depth, list: '80' }];
  const text = studyYaml('each', { ...request, axes }, 'lay.yaml', model);
  expect(text).toContain('{key: tensioner.tension, values: [250 kN, 240 kN, 260 kN, 250 kN]}');
  expect(text).toContain('{key: environment.water_depth, values: [89 m, 89 m, 89 m, 80 m], with: tensioner.tension}');
});

test('an invalid request is reported before it is sent', () => {
  expect(findStudyError('study', request, model)).toBeNull();
  expect(findStudyError('study', { ...request, axes: [] }, model)).toMatch(/add a key/);
  expect(findStudyError('study', { ...request, axes: [emptyAxis('tensioner.tension')] }, model)).toMatch(/enter from, to/);
  expect(findStudyError('study', { ...request, axes: [tension, tension] }, model)).toMatch(/once/);
  expect(findStudyError('operability', { ...request, over: 'vessel.trim' }, model)).toMatch(/select the key/);
});

test('ranges about the value of a model are round', () => {
  expect(roundRange(71.2, 111, 5)).toEqual([70, 110]);
  expect(roundRange(200, 375, 8)).toEqual([200, 375]);
  expect(roundRange(0.08, 0.16, 9)).toEqual([0.08, 0.16]);
});

test('a lay table of depths by tensions is a study of both', () => {
  const grid = { rows: { ...emptyAxis(), from: '70 m', to: '110 m' }, columns: tension };
  expect(gridYaml(grid, 'lay.yaml', model)).toContain('- {key: environment.water_depth, from: 70 m, to: 110 m, steps: 5}\n  - {key: tensioner.tension, from: 200 kN');
  expect(findGridError(grid, model)).toBeNull();
  expect(findGridError({ ...grid, rows: { ...grid.rows, to: '' } }, model)).toMatch(/depths/);
});

const makeCase = (number: number, place: number[], value: number | null, more: Partial<MatrixCase> = {}): MatrixCase =>
  ({ number, at: place, words: [], inputs: [], seed: null, state: value === null ? 'failed' : 'done', values: [value], passed: value !== null && value < 10, verdict: value === null ? 'not judged' : value < 10 ? 'passed' : 'exceeded', obstacle: '', governing: '', utilisation: null, reason: '', ...more });
const axis = (key: string, labels: string[], more = {}) => ({ key, unit: '', with: '', sampled: false, words: labels, values: labels.map(Number), ...more });
const matrix = (cases: MatrixCase[]): Matrix => ({ title: '', analysis: 'static', inputs: [axis('a', ['1', '2']), axis('b', ['1', '2', '3']), axis('c', ['1', '2'], { with: 'a' })], outputs: [{ name: 'x.max', unit: '' }], cases, operability: null, findings: [] });

test('cells lie at their values, and report failed cases', () => {
  const m = matrix([makeCase(0, [0, 0, 0], 1), makeCase(1, [0, 1, 0], 20), makeCase(2, [0, 2, 0], null), makeCase(3, [1, 0, 1], 4), makeCase(4, [1, 1, 1], 5, { state: 'open' })]);
  expect(spreadAxes(m)).toEqual([0, 1]);
  const cells = cellsOver(m, [0, 1], {}, 0);
  expect(cells.map((row) => row.map((c) => c.state))).toEqual([['passed', 'passed'], ['exceeded', 'open'], ['failed', 'open']]);
  expect(cells[1]![0]!.value).toBe(20);
  expect(cellsOver(m, [1], { 0: 1 }, 0)[0]!.map((c) => c.value)).toEqual([4, 5, null]);
  expect(tally(m)).toBe('5 cases: 2 pass, 1 exceed a check, 1 have no solution, 1 pending');
});

test('a case with a serious finding passes with reservations, one without checks does not pass', () => {
  const m = matrix([makeCase(0, [0, 0, 0], 1, { verdict: 'reserved', passed: false, obstacle: 'pipe-off-rollers' }), makeCase(1, [0, 1, 0], 1, { verdict: 'not judged', passed: false }), makeCase(2, [0, 2, 0], 1)]);
  expect(tally(m)).toBe('3 cases: 1 pass, 1 pass with reservations, 1 solved, not judged');
  expect(cellsOver(m, [0, 1], {}, 0).map((row) => row[0]!.state)).toEqual(['reserved', 'not judged', 'passed']);
});

test('of several seeds the more extreme value counts', () => {
  const seeds = [makeCase(0, [], 3), makeCase(1, [], 5), makeCase(2, [], null)];
  expect(worstValue(seeds, 0, 'dynamic.top_tension.max')).toBe(5);
  expect(worstValue(seeds, 0, 'dynamic.top_tension.min')).toBe(3);
  expect(worstValue([makeCase(0, [], null)], 0, 'x')).toBeNull();
});

const laid = (number: number, place: [number, number], tensionHere: number, utilisation: number | null, governing = 'A'): MatrixCase => (
  { ...makeCase(number, place, utilisation), words: [`${70 + 10 * place[0]} m`, `${tensionHere} kN`], inputs: [70 + 10 * place[0], tensionHere], utilisation, governing,
    verdict: utilisation === null ? 'not judged' : utilisation > 1 ? 'exceeded' : 'passed', values: [300 + place[1]] });
const layGrid = (cases: MatrixCase[]): Matrix => (
  { ...matrix(cases), inputs: [axis('environment.water_depth', ['70', '80']), axis('tensioner.tension', ['200', '300', '400'], { unit: 'kN' })],
    outputs: [{ name: 'static.lay_back', unit: 'm' }] });
const solvedGrid = layGrid([laid(0, [0, 0], 200, 1.2), laid(1, [0, 1], 300, 0.8), laid(2, [0, 2], 400, 0.9), laid(3, [1, 0], 200, null), laid(4, [1, 1], 300, 0.7, 'B'), laid(5, [1, 2], 400, 1.3)]);

test('each depth has the tensions that keep the limit, between two of them where one check governs at both', () => {
  expect(gridAxes(solvedGrid)).toEqual([1, 0]);
  const [first, second] = depthLimits(solvedGrid, 1, 0, {}, usualLimits);
  expect(first!.least).toMatchObject({ tension: 250, open: false, because: 'A', layBack: 301 });
  expect(first!.most).toMatchObject({ tension: 400, open: true });
  expect(second!.least).toMatchObject({ tension: 300, because: 'no solution' });
  expect(second!.most).toMatchObject({ tension: 300, because: 'A' });
  expect(depthLimits(solvedGrid, 1, 0, {}, { ...usualLimits, utilisation: 0.6 })[0]).toMatchObject({ least: null, most: null });
  const table = tensionTable(solvedGrid, [1, 0], [first!, second!]);
  expect(table.rows[0]).toEqual([70, '250', '≥ 400', 301, 302, 'A', '']);
});

test('a workbook has the table, governing checks, tensions and all cases', () => {
  const tables = studySheets(solvedGrid, [1, 0], {}, depthLimits(solvedGrid, 1, 0, {}, usualLimits));
  expect(tables.map(({ title }) => title)).toEqual(['Utilisation', 'Governing check', 'Tensions', 'Cases']);
  expect(tables[0]!.rows[0]).toEqual(['70', 1.2, 0.8, 0.9]);
  expect(tables[0]!.columns.map(({ title }) => title)).toEqual(['water depth', '200 kN', '300 kN', '400 kN']);
  expect(casesTable(solvedGrid).rows).toHaveLength(6);
  expect(governingChecks(solvedGrid).map(({ name, count }) => [name, count])).toEqual([['A', 4], ['B', 1]]);
});

test('one key at a time is recognised by its cases, and each key has its range', () => {
  const cases = [laid(0, [0, 0], 250, 0.8), laid(1, [0, 1], 240, 0.9), laid(2, [0, 2], 260, 0.7), { ...laid(3, [1, 0], 250, 0.95), words: ['80 m', '250 kN'] }];
  const each: Matrix = { ...layGrid(cases), inputs: [axis('environment.water_depth', ['70', '70', '70', '80']), axis('tensioner.tension', ['250', '240', '260', '250'], { with: 'environment.water_depth' })] };
  expect(findShape(each)).toBe('each');
  expect(swings(each, baseCase(each)!, kUtilisation).map(({ key, low, high }) => [key, low, high])).toEqual([['tensioner.tension', 0.7, 0.9], ['environment.water_depth', 0.8, 0.95]]);
  expect(baseCase(solvedGrid)).toBeNull();
});

test('numbers have the decimals that they need', () => {
  expect(decimals([70, 80])).toBe(0);
  expect(decimals([1.5, 2])).toBe(1);
  expect(decimals([0.123456, 0.2])).toBe(4);
  expect(decimals([331.467])).toBe(1);
});
