import { expect, test } from 'vitest';
import { newerList, parseSeeds } from '../src/logic/runs';
import type { Run } from '../src/api/types';

const run = (id: string, state: Run['state']): Run => ({ id, state, title: '', kind: 'dynamic', progress: 0, started: 0 }) as Run;

test('a list that comes late does not make an ended run go on', () => {
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
