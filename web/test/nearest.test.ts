import { describe, expect, it } from 'vitest';
import { differing, nearestSolved } from '../src/logic/nearest';

describe('the nearest solved state', () => {
  it('is found between the solved and the unsolved state', async () => {
    const asked: number[] = [];
    const found = await nearestSolved({ tension: 250, depth: 89 }, { tension: 50, depth: 89 }, (s) => { asked.push(s.tension!); return Promise.resolve(s.tension! >= 123); });
    expect(found.depth).toBe(89);
    expect(found.tension).toBeGreaterThanOrEqual(123);
    expect(found.tension).toBeLessThan(123 + 200 / 100);
    expect(asked.length).toBeLessThan(10);
  });
  it('is the solved state if nothing else solves', async () => {
    expect(await nearestSolved({ a: 1 }, { a: 2 }, () => Promise.resolve(false))).toEqual({ a: 1 });
  });
});

describe('differences', () => {
  it('is named', () => { expect(differing({ a: 1, b: 2 }, { a: 1, b: 3 })).toEqual(['b']); });
  it('is unknown if one state lacks a key of the other', () => { expect(differing({ a: 1 }, { a: 1, b: 3 })).toBeNull(); });
});
