import { expect, test } from 'vitest';
import { listedNames, newerList, parseSeeds } from '../src/logic/runs';
import type { Run } from '../src/api/types';

const run = (id: string, state: Run['state']): Run => ({ id, state, title: '', kind: 'dynamic', progress: 0, started: 0 }) as Run;

test('a late list does not restart an ended run', () => {
  const list = newerList([run('a', 'cancelled'), run('b', 'running')], [run('b', 'done'), run('a', 'running')]);
  expect(list.map((r) => [r.id, r.state])).toEqual([['b', 'done'], ['a', 'cancelled']]);
});

test('runs that are new or gone follow the list', () => {
  expect(newerList([run('old', 'done')], [run('new', 'queued')]).map((r) => r.id)).toEqual(['new']);
});

test('seeds are read as they are written', () => {
  expect(parseSeeds('1-5')).toEqual([1, 2, 3, 4, 5]);
  expect(parseSeeds(' 3, 7 to 9 ,12')).toEqual([3, 7, 8, 9, 12]);
  for (const wrong of ['', 'five', '1, 1', '1-3, 2', '5-1', '-1', '1-99999']) expect(parseSeeds(wrong)).toBeNull();
});

test('runs of the same name are distinguished by number and by changed keys', () => {
  const makeRun = (id: string, started: number, part: Partial<Run> = {}): Run => ({ ...run(id, 'done'), title: 'BGL-1', started, ...part });
  const names = listedNames([makeRun('c', 30, { changed: 'tensioner.tension 255 kN' }), makeRun('b', 20), makeRun('a', 10, { name: 'base' }), makeRun('d', 5), makeRun('d~seed-1', 5, { parent: 'd' })]);
  expect(Object.fromEntries(names)).toEqual({ a: 'base', b: 'BGL-1 (2)', c: 'BGL-1 (3: tensioner.tension 255 kN)', d: 'BGL-1 (1)', 'd~seed-1': 'BGL-1' });
  expect(listedNames([makeRun('a', 10, { changed: 'x 1' })]).get('a')).toBe('BGL-1');
});
