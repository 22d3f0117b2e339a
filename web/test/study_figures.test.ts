import { expect, test } from 'vitest';
import { gradientStops, valueColour, valueScale } from '../src/components/colourScale';
import { stateLabels } from '../src/components/HeatMap';
import { axisPlaces, nameEnd, roomAround, wholeRange } from '../src/components/keyAxis';
import { passEdges } from '../src/components/passEdges';
import { isClosed } from '../src/components/Rose';
import type { SeekData, StudyData, StudyGroupData } from '../src/report/data';
import { pathPoints } from '../src/report/figures/seek';
import { describeGroup, groupsWith, mapLayout } from '../src/report/figures/study_cases';

const group = (place: number[], value: number | null, more: Partial<StudyGroupData> = {}): StudyGroupData => ({
  at: place, x: [], words: place.map(String), mean: [value], low: [value], high: [value], state: value === null ? 'failed' : 'passed', governing: '', utilisation: null,
  case: 0, ...more });
const axis = (name: string, values: number[]) => ({ name, words: values.map(String), values, sampled: false });
const study = (groups: StudyGroupData[]): StudyData => ({
  shape: 'maps', inputs: [axis('a [m]', [1, 2]), axis('b', [1, 2]), axis('c', [1, 2, 3])], outputs: [{ name: 'out', at: 0 }], groups, axes: [0, 1, 2] });

test('the scale of colours runs from the smallest to the largest value, above a limit in reds', () => {
  expect(valueScale([2, 5, 3])).toEqual({ low: 2, top: 5, high: 5 });
  expect(valueScale([4, 4])).toEqual({ low: 2, top: 6, high: 6 });
  expect(valueScale([0.5, 1.5], 1)).toEqual({ low: 0.5, top: 1, high: 1.5 });
  expect(valueScale([0.5, 0.9], 1)).toEqual({ low: 0.5, top: 0.9, high: 0.9 });
  expect(valueColour(valueScale([0, 1]), 0)).toBe('#440154');
  expect(valueColour(valueScale([0, 2], 1), 1)).toBe('#fde725');
  expect(valueColour(valueScale([0, 2], 1), 2)).toBe('#8f0b26');
});

test('the gradient of a scale changes to reds at the limit', () => {
  const stops = gradientStops({ low: 0, top: 1, high: 4 });
  expect(stops.map((stop) => stop.offset).filter((offset) => offset === 0.25)).toHaveLength(2);
  expect(gradientStops({ low: 1, top: 1, high: 4 })[0]!.colour).toBe('#f0937c');
  expect(gradientStops({ low: 0, top: 4, high: 4 }).at(-1)).toEqual({ offset: 1, colour: '#fde725' });
});

test('the border runs between cells that pass and their neighbours that do not', () => {
  const [yes, no] = [{ state: 'passed' }, { state: 'exceeded' }];
  expect(passEdges([[yes, no], [yes, yes]])).toEqual([[1, 0, 0, 1], [1, 1, 1, 0]]);
  expect(passEdges([[yes, null], [yes, yes]])).toEqual([]);
});

test('marks of cells are explained where they occur', () => {
  expect(stateLabels(['passed'])).toBe('');
  expect(stateLabels(['passed', 'exceeded', 'failed'])).toBe('struck through: a check is exceeded; hatched: no result');
  expect(stateLabels(['not judged'])).toBe('');
});

test('a rose is closed where directions go all the way round', () => {
  expect(isClosed([0, 90, 180, 270])).toBe(true);
  expect(isClosed([0, 45, 90])).toBe(false);
  expect(isClosed([0, 180])).toBe(false);
});

test('the two keys with most values span a map, the others distinguish the maps', () => {
  const { x, y, facets } = mapLayout(study([group([0, 0, 0], 1), group([0, 0, 1], 1), group([0, 1, 0], 1)]));
  expect([x, y]).toEqual([2, 0]);
  expect(facets.map((facet) => [facet.title, facet.groups.length])).toEqual([['b 0', 2], ['b 1', 1]]);
});

test('every solved case has a result, also if it is not judged', () => {
  const all = [group([0, 0, 0], 1, { state: 'reserved' }), group([0, 0, 1], 2, { state: 'not judged' }), group([0, 1, 0], null), group([1, 0, 0], null, { state: 'passed' })];
  expect(groupsWith(study(all), 0).map((g) => g.mean[0])).toEqual([1, 2]);
  expect(describeGroup(study(all), all[0]!)).toBe('case 0\na: 0\nb: 0\nc: 0\npassed with reservations');
});

test('a key without numbers has its values side by side', () => {
  expect(axisPlaces(axis('a', [2, 4])).places).toEqual([2, 4]);
  expect(axisPlaces({ name: 'a', words: ['x', 'y'], values: [null, null] })).toEqual({ places: [0, 1], labels: ['x', 'y'], numeric: false });
});

test('ranges have room, but not across zero', () => {
  expect(roomAround([1, 101], 0.08)).toEqual([0, 109]);
  expect(roomAround([-50, -1], 0.1)).toEqual([-54.9, 0]);
  expect(roomAround([0, 0], 0.1)).toEqual([0, 1]);
  expect(wholeRange([3, 3])).toEqual([2.5, 3.5]);
  expect(nameEnd('runs/of/a/long/path', 8)).toBe('\u2026ng/path');
});

test('the path of a goal seek is sorted by its one key, with several keys in the order of the search', () => {
  const goal = { name: 'u', unit: '', factor: 1, wanted: 1, reached: 1 };
  const key = { name: 'k', unit: 'kN', factor: 1e-3, answer: 2000 };
  const path = [{ values: [3000], results: [5] }, { values: [1000], results: [7] }];
  expect(pathPoints({ keys: [key], goals: [goal], path } as SeekData, goal)).toEqual([[1, 7], [3, 5]]);
  expect(pathPoints({ keys: [key, key], goals: [goal], path } as SeekData, goal)).toEqual([[1, 5], [2, 7]]);
});
