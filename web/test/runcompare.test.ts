import { describe, expect, test } from 'vitest';
import { change, differenceTable, envelopeChart, historyChart, modelDifferences, resultRows, resultTable } from '../src/logic/runCompare';
import { matches, nextRunOrder, noFilter, orderedRuns, runTable } from '../src/logic/runTable';
import type { Envelopes, Run } from '../src/api/types';

const run = (part: Partial<Run>): Run => ({ id: 'a', title: 'lay', kind: 'dynamic', state: 'done', progress: 1, started: 100, message: '', name: '', note: '', changed: '', has_results: true, ...part });
const name = (r: Run): string => r.name || r.title;

describe('the list of runs', () => {
  const list = [
    run({ id: '1', name: 'storm 10', started: 300, utilisation: 0.7, verdict: { kind: 'passed', words: 'PASSED' } }),
    run({ id: '2', name: 'storm 2', started: 100, utilisation: 1.2, verdict: { kind: 'exceeded', words: 'EXCEEDED 1.2, overbend' }, note: 'for the client' }),
    run({ id: '3', name: 'at rest', kind: 'static', state: 'failed', started: 200 }),
  ];
  const ids = (runs: Run[]): string => runs.map((r) => r.id).join('');
  test('is filtered by text, kind and state', () => {
    const found = (filter: object): string => ids(list.filter((r) => matches(r, name(r), { ...noFilter, ...filter })));
    expect(found({})).toBe('123');
    expect(found({ text: 'CLIENT storm' })).toBe('2');
    expect(found({ text: 'overbend' })).toBe('2');
    expect(found({ kind: 'static' })).toBe('3');
    expect(found({ state: 'done', text: 'rest' })).toBe('');
  });
  test('is ordered by any column, runs without a value last', () => {
    const ordered = (column: 'name' | 'started' | 'utilisation' | 'verdict' | 'state', descending: boolean): string => ids(orderedRuns(list, { column, descending }, name));
    expect(ordered('name', false)).toBe('321');
    expect(ordered('started', true)).toBe('132');
    expect(ordered('utilisation', true)).toBe('213');
    expect(ordered('utilisation', false)).toBe('123');
    expect(ordered('verdict', false)).toBe('213');
    expect(ordered('state', false)).toBe('312');
  });
  test('begins with the latest and the largest, and turns round', () => {
    expect(nextRunOrder({ column: 'name', descending: false }, 'utilisation')).toEqual({ column: 'utilisation', descending: true });
    expect(nextRunOrder({ column: 'utilisation', descending: true }, 'utilisation')).toEqual({ column: 'utilisation', descending: false });
    expect(nextRunOrder({ column: 'utilisation', descending: true }, 'name')).toEqual({ column: 'name', descending: false });
  });
  test('goes to a spreadsheet with its verdicts', () => expect(runTable(list, name).rows[1]).toEqual(['storm 2', 'dynamic', 'done', '1970-01-01T00:01:40.000Z', 'EXCEEDED 1.2, overbend', null, 1.2, 'for the client']));
});

describe('runs next to each other', () => {
  const field = (path: string, value: string, si: number | null = null) => ({ path, kind: 'quantity' as const, value, si, given: true });
  test('differ in keys whose values differ, however they are written', () => {
    const first = [field('title', 'a'), field('tensioner.tension', '250 kN', 250e3), field('environment.water_depth', '89 m', 89), field('pipe.wall', '11 mm', 0.011)];
    const second = [field('title', 'b'), field('tensioner.tension', '0.25 MN', 250e3), field('environment.water_depth', '95 m', 95), field('vessel.name', 'BGL-1')];
    expect(modelDifferences([first, second])).toEqual([
      { path: 'environment.water_depth', values: ['89 m', '95 m'] }, { path: 'pipe.wall', values: ['11 mm', null] }, { path: 'vessel.name', values: [null, 'BGL-1'] },
    ]);
    expect(differenceTable(['a', 'b'], modelDifferences([first, second])).rows[1]).toEqual(['pipe.wall', '11 mm', 'not given']);
  });
  test('a group or key that is not given is not a difference', () => expect(modelDifferences([[{ ...field('a', 'x'), given: false }], []])).toEqual([]));
  const summary = (tension: number, used: number) => ({ static: { top_tension: tension, overbend: { max_von_mises: 300e6 } }, checks: { list: [], worst: { utilisation: used } } }) as never;
  test('have the results of all runs, with differences from the first', () => {
    const rows = resultRows([summary(250e3, 0.7), summary(275e3, 0.77), null]);
    expect(rows.map((r) => r.name)).toEqual(['utilisation', 'static top tension', 'static overbend von Mises']);
    expect(rows[1]!.values).toEqual([250e3, 275e3, null]);
    expect(change(250e3, 275e3)).toBeCloseTo(10, 9);
    expect([change(0, 1), change(null, 1), change(1, null)]).toEqual([null, null, null]);
    expect(change(-2, -1)).toBe(50);
    expect(resultTable(['a', 'b', 'c'], rows).rows[1]).toEqual(['static top tension', 'kN', 250, 275, expect.closeTo(10, 9), null, null]);
  });
  test('have envelopes in one diagram, also where their stations differ', () => {
    const band = (values: number[]) => ({ static: values, min: values.map((v) => v / 2), max: values });
    const envelopes = (s: number[], values: number[]): Envelopes => ({ s, x: s, z: s, effective_tension: band(values), bending_moment: band(values), bending_stress: band(values), von_mises: band(values), strain: band(values) });
    const chart = envelopeChart('von_mises', [{ name: 'a', colour: 'red', data: envelopes([0, 10], [100e6, 200e6]) }, { name: 'b', colour: 'blue', data: envelopes([0, 5, 20], [1e6, 2e6, 3e6]) }, { name: 'c', colour: 'green', data: null }]);
    expect(chart.x).toEqual([0, 5, 10, 20]);
    expect(chart.lines.map((l) => l.name)).toEqual(['a', 'a, min', 'b', 'b, min']);
    expect(chart.lines[0]!.values).toEqual([100, 150, 200, null]);
    expect(chart.lines[2]!.values.map((v) => Number(v!.toFixed(6)))).toEqual([1, 2, 2.333333, 3]);
  });
  test('have histories in one diagram', () => {
    const chart = historyChart('Top tension', 'N', [{ name: 'a', colour: 'red', data: { t: [0, 1, 2], min: [1e3, 2e3, 3e3], max: [1e3, 2e3, 3e3] } }, { name: 'b', colour: 'blue', data: { t: [0, 2], min: [0, 0], max: [4e3, 4e3] } }]);
    expect(chart.lines.map((l) => l.name)).toEqual(['a', 'b', 'b, min']);
    expect(chart.lines[1]!.values).toEqual([4, 4, 4]);
    expect(chart.yName).toBe('top tension [kN]');
  });
});
