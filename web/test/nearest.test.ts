import { describe, expect, it } from 'vitest';
import { differing, nearestSolved } from '../src/logic/nearest';

describe('the nearest state that solves', () => {
  it('is found on the way from the one that does to the one that does not', async () => {
    const asked: number[] = [];
    const found = await nearestSolved({ tension: 250, depth: 89 }, { tension: 50, depth: 89 }, (s) => { asked.push(s.tension!); return Promise.resolve(s.tension! >= 123); });
    expect(found.depth).toBe(89);
    expect(found.tension).toBeGreaterThanOrEqual(123);
    expect(found.tension).toBeLessThan(123 + 200 / 100);
    expect(asked.length).toBeLessThan(10);
  });
  it('is the one that solves where nothing else does', async () => {
    expect(await nearestSolved({ a: 1 }, { a: 2 }, () => Promise.resolve(false))).toEqual({ a: 1 });
  });
});

describe('what differs', () => {
  it('is named', () => { expect(differing({ a: 1, b: 2 }, { a: 1, b: 3 })).toEqual(['b']); });
  it('cannot be said where one has what the other lacks', () => { expect(differing({ a: 1 }, { a: 1, b: 3 })).toBeNull(); });
});
