import { describe, expect, it } from 'vitest';
import type { Field } from '../src/api/types';
import { tree } from '../src/logic/formTree';
import { absentObjects, findNode, objectOfKey, objectTitle, partsWithin, pathsAbove, summaryValue, topObjects } from '../src/logic/modelTree';
import { lineOfKey } from '../src/logic/yamlPlace';

const field = (path: string, kind: string, value: unknown = null, more: Partial<Field> = {}): Field => ({ path, kind, value, given: true, si: null, unit: '', ...more }) as Field;

const fields = [
  field('title', 'text', 'Sixteen inch'),
  field('environment', 'map'), field('environment.water_depth', 'quantity', '89 m'),
  field('environment.current', 'list', null, { count: 1 }), field('environment.current[0]', 'map'), field('environment.current[0].speed', 'quantity', '1 m/s'),
  field('pipe', 'map'), field('pipe.steel', 'map'),
  field('pipe.steel.outside_diameter', 'quantity', '406.4 mm', { si: 0.4064 }), field('pipe.steel.wall_thickness', 'quantity', '11.1 mm'),
  field('supports', 'map'), field('supports.stinger', 'map'), field('supports.stinger.boxes', 'list', null, { count: 2 }),
  field('supports.stinger.boxes[0]', 'map'), field('supports.stinger.boxes[0].name', 'text', 'first'), field('supports.stinger.boxes[0].x', 'quantity', '1 m'),
  field('supports.stinger.boxes[1]', 'map'), field('supports.stinger.boxes[1].x', 'quantity', '5 m'),
  field('moorings', 'map', null, { given: false }), field('moorings.lines', 'list', null, { given: false }),
  field('report', 'map', null, { given: false }), field('report.client', 'text', null, { given: false }),
];
const sections = tree(fields), values = new Map(fields.map((f) => [f.path, f]));
const node = (path: string) => findNode(sections, path)!;

describe('the tree of objects', () => {
  it('has the objects of the model, in the order of an installation, and the document', () => {
    expect(topObjects(sections).map((n) => objectTitle(n))).toEqual(['Site', 'Pipe', 'Supports', 'Document']);
  });
  it('offers missing objects separately', () => {
    expect(absentObjects(sections).map((n) => n.path)).toEqual(['moorings']);
  });
  it('includes items of lists, but not single values', () => {
    expect(partsWithin(node('supports.stinger.boxes')).map(objectTitle)).toEqual(['first', '2']);
    expect(partsWithin(node('supports.stinger.boxes[0]'))).toEqual([]);
  });
  it('shows a summary value of each object', () => {
    expect(['environment', 'environment.current', 'pipe', 'supports', 'supports.stinger'].map((path) => summaryValue(node(path), values)))
      .toEqual(['89 m', '1 row', '16 in × 11.1 mm', '2 boxes', '2']);
  });
  it('shows height and period of each group of waves', () => {
    const groups = [
      field('environment', 'map'), field('environment.waves', 'list', null, { count: 2 }),
      field('environment.waves[0]', 'map'), field('environment.waves[0].hs', 'quantity', '2 m'), field('environment.waves[0].tz', 'quantity', '6 s'),
      field('environment.waves[1]', 'map'), field('environment.waves[1].height', 'quantity', '1 m'), field('environment.waves[1].period', 'quantity', '13 s'),
    ];
    const summary = summaryValue(findNode(tree(groups), 'environment.waves')!, new Map(groups.map((f) => [f.path, f])));
    expect(summary).toBe('Hs 2 m, Tz 6 s; 1 m, 13 s');
    expect(partsWithin(findNode(tree(groups), 'environment.waves')!).length).toBe(2);
  });
  it('finds the object that shows a key', () => {
    expect(objectOfKey(sections, 'supports.stinger.boxes[1].x')).toBe('supports.stinger.boxes[1]');
    expect(objectOfKey(sections, 'environment.water_depth')).toBe('environment');
    expect(objectOfKey(sections, 'environment.seabed.slope')).toBe('environment');
    expect(objectOfKey(sections, 'title')).toBe('report');
    expect(objectOfKey(sections, 'nothing.like_that')).toBe('');
  });
  it('names the paths above an object', () => {
    expect(pathsAbove('supports.stinger.boxes[1]')).toEqual(['supports', 'supports.stinger', 'supports.stinger.boxes']);
  });
});

describe('the line of a key', () => {
  const text = `# a model
overbend: 1
environment:
  water_depth: 89 m
  current:
    - {depth: 0 m, speed: 1 m/s}
    - depth: 20 m
      speed: 2 m/s

supports:
  ramp:
    boxes:
      - {x: 1 m}
  stinger:
    boxes:
      - {x: 1 m}
      - {x: 5 m}
tensioner: {x: 0 m, tension: 250 kN}
`;
  it.each([
    ['environment', 3], ['environment.water_depth', 4], ['environment.current[0]', 6], ['environment.current[1].speed', 8], ['supports.stinger', 14],
    ['supports.stinger.boxes[1]', 17], ['supports.stinger.boxes[1].x', 17], ['tensioner.tension', 18], ['environment.waves', 3], ['nothing', 0],
  ])('of %s is %i', (path, line) => { expect(lineOfKey(text, path)).toBe(line); });
});
