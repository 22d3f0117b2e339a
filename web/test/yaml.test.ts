import { describe, expect, test } from 'vitest';
import { placeAt } from '../src/logic/yamlPlace';
import { keyOffers, valueOffers, type Schema } from '../src/logic/schema';

const findPlace = (text: string): ReturnType<typeof placeAt> => { const offset = text.indexOf('|'); return placeAt(text.replace('|', ''), offset); };

describe('cursor position', () => {
  test('top level', () => expect(findPlace('overbend: 1\nten|')).toMatchObject({ path: [], typed: 'ten', kind: 'key' }));
  test('a key in a group', () => expect(findPlace('tensioner:\n  x: 1 m\n  ten|')).toMatchObject({ path: ['tensioner'], typed: 'ten', kind: 'key' }));
  test('a value', () => expect(findPlace('tensioner:\n  mode: con|')).toMatchObject({ path: ['tensioner', 'mode'], typed: 'con', kind: 'value' }));
  test('in braces', () => expect(findPlace('environment:\n  waves: {type: jonswap, h|')).toMatchObject({ path: ['environment', 'waves'], typed: 'h', kind: 'key' }));
  test('a value in braces', () => expect(findPlace('environment:\n  waves: {type: j|')).toMatchObject({ path: ['environment', 'waves', 'type'], typed: 'j', kind: 'value' }));
  test('in a list with braces', () => expect(findPlace('supports:\n  ramp:\n    rows: 3\n    boxes:\n      - {name: a, x: 1 m}\n      - {na|')).toMatchObject({ path: ['supports', 'ramp', 'boxes', '[]'], typed: 'na', kind: 'key' }));
  test('second line of a list item', () => expect(findPlace('pipe:\n  coatings:\n    - name: a\n      thi|')).toMatchObject({ path: ['pipe', 'coatings', '[]'], typed: 'thi', kind: 'key' }));
  test('comments between are skipped', () => expect(findPlace('pipe:\n  # steel\n  steel:\n    # more\n    out|')).toMatchObject({ path: ['pipe', 'steel'], kind: 'key' }));
});

describe('permitted keys', () => {
  const schema: Schema = {
    type: 'object',
    properties: {
      tensioner: { type: 'object', description: 'Where.', properties: { mode: { enum: ['controlled', 'locked'] }, x: { type: 'string', 'x-unit': 'm', examples: ['1 m'] } } },
      rollers: { additionalProperties: { properties: { friction: { anyOf: [{ type: 'number', default: 0 }, { properties: { axial: { type: 'number' } } }] } } } },
    },
  };
  test('keys', () => expect(keyOffers(schema, ['tensioner']).map((o) => [o.label, o.detail])).toEqual([['mode', ''], ['x', 'm']]));
  test('groups are distinguished from values', () => expect(keyOffers(schema, []).every((o) => o.group)).toBe(true));
  test('choices', () => expect(valueOffers(schema, ['tensioner', 'mode']).map((o) => o.label)).toEqual(['controlled', 'locked']));
  test('names of one\'s own and either-or', () => {
    expect(keyOffers(schema, ['rollers', 'mine', 'friction']).map((o) => o.label)).toEqual(['axial']);
    expect(valueOffers(schema, ['rollers', 'mine', 'friction']).map((o) => o.label)).toEqual(['0']);
  });
  test('nowhere', () => expect(keyOffers(schema, ['nonsense'])).toEqual([]));
});
