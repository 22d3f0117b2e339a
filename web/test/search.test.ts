import { describe, expect, test } from 'vitest';
import { findEntries, prepare, type SearchEntry } from '../src/logic/search';

const entry = (name: string, more = '', kind: SearchEntry['kind'] = 'key', weight = 0): SearchEntry => ({ id: `${kind} ${name} ${more}`, name, more, kind, weight });
const list = prepare([
  entry('Save', '', 'command', 6), entry('Save as …', '', 'command', 6), entry('Undo', '', 'command', 6), entry('Dark or light colours', 'theme mode', 'command', 6),
  entry('Tensioner', 'tensioner', 'object', 8), entry('stinger 3', 'supports.stinger.boxes[2]', 'object', 8),
  entry('tension', 'tensioner.tension', 'key', 5), entry('stinger 3 z', 'supports.stinger.boxes[2].z', 'key', 5),
  entry('wall thickness', 'pipe.steel.wall_thickness', 'key', 5), entry('thickness', 'pipe.coatings[0].thickness'), entry('tension', 'moorings.lines[0].tension'),
]);
const names = (query: string): string[] => findEntries(list, query, 10).map((e) => e.name);

describe('search', () => {
  test('a whole name comes first, keys of the model before others', () => {
    expect(findEntries(list, 'tension', 3).map((e) => e.more)).toEqual(['tensioner.tension', 'moorings.lines[0].tension', 'tensioner']);
    expect(names('stinger 3')[0]).toBe('stinger 3');
    expect(names('stinger 3 z')[0]).toBe('stinger 3 z');
  });
  test('every word has to be found, in any order', () => {
    expect(names('thickness wall')).toEqual(['wall thickness']);
    expect(names('wall friction')).toEqual([]);
  });
  test('beginnings and synonyms are enough', () => {
    expect(names('th')[0]).toBe('thickness');
    expect(names('theme')).toEqual(['Dark or light colours']);
    expect(names('sa')[0]).toBe('Save');
  });
  test('a path finds its key', () => expect(names('pipe.steel.wall_thickness')[0]).toBe('wall thickness'));
  test('an omitted letter still matches', () => expect(names('tnsion')).toContain('tension'));
  test('without a query the most important entries are listed', () => {
    expect(names('')[0]).toBe('Save');
    expect(findEntries(list, '', 10).every((e) => e.weight! > 0)).toBe(true);
  });
});
