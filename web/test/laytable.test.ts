// Request of a lay table, and the layout of its curves.
import { expect, test } from 'vitest';
import type { LayTable } from '../src/api/types';
import { valueRange } from '../src/components/LayTableCharts';
import { layRowKeys, layRows, rangeText, usualRange, findLayTableError } from '../src/logic/laytable';

test('a range is requested as on the command line', () => {
  expect(rangeText({ vary: 'tension', from: ' 200 kN', to: '400 kN ', steps: '20' })).toBe('200 kN..400 kN/20');
});

test('the default range is about the lay shown', () => {
  expect(usualRange('tension', { top_tension: 250e3, lay_back: 330 }, 89)).toEqual({ vary: 'tension', from: '200 kN', to: '400 kN', steps: '16' });
  expect(usualRange('lay_back', { top_tension: 250e3, lay_back: 330 }, 89).to).toBe('396 m');
  expect(usualRange('depth', null, 89).from).toBe('71.2 m');
  expect(findLayTableError(usualRange('tension', null, null))).not.toBeNull();
});

test('an invalid request is reported before it is sent', () => {
  const good = { vary: 'tension', from: '200', to: '400 kN', steps: '20' } as const;
  expect(findLayTableError(good)).toBeNull();
  expect(findLayTableError({ ...good, to: '400' })).toMatch(/unit/);
  expect(findLayTableError({ ...good, steps: '0' })).toMatch(/steps/);
  expect(findLayTableError({ ...good, from: 'much' })).toMatch(/numbers/);
});

test('a panel holds its curves and the limit', () => {
  const [low, high] = valueRange({ title: '', limit: 1, series: [{ name: 'a', points: [[200, 0.4], [400, 0.8]] }] });
  expect(high).toBeGreaterThan(1);
  expect(low).toBeGreaterThanOrEqual(0);
  expect(low).toBeLessThan(0.4);
});

test('rows have their units in the heads; limits and failed rows are highlighted', () => {
  const step = { kind: 'step', verdict: 'exceeded', cells: ['step', 200, null] } as const, limit = { kind: 'least', verdict: 'passed', cells: ['least', 210, 0.98] } as const;
  const columns = [{ heading: 'row', digits: 0 }, { heading: 'tension [kN]', digits: 1 }, { heading: 'checks', digits: 6 }];
  const table = layRows({ columns, rows: [step, limit] } as unknown as LayTable);
  expect(table.columns).toMatchObject([{ title: 'row', words: true }, { title: 'tension', unit: 'kN', digits: 1, words: false }, { title: 'checks', digits: 4 }]);
  expect(table.rows[0]).toEqual(['1', 200, '-']);
  expect(layRowKeys({ columns: [{ heading: 'row' }, { heading: 'top tension [kN]' }, { heading: 'depth [m]' }], rows: [{ kind: 'step', cells: ['step', 250.0002, 40] }] } as unknown as LayTable, 0))
    .toEqual([{ key: 'tensioner.tension', text: '250 kN' }, { key: 'environment.water_depth', text: '40 m' }]);
  expect(table.marks).toEqual(['over', 'limit']);
});
