import { describe, expect, test } from 'vitest';
import type { Field } from '../src/api/types';
import { headUnit, readCell, shownValue, unitLike } from '../src/logic/gridCells';
import { listColumns, shownColumns, type GridColumn } from '../src/logic/gridColumns';
import { parseTable, readHead, splitTitle, tabText } from '../src/logic/gridClipboard';
import { cellChanges, duplicated, listChanges, nextItem, removal, shifted } from '../src/logic/gridEdits';
import { arcBoxes, findArcErrors, lastIncline, rowChanges, generatedBoxes, writtenOut } from '../src/logic/gridGenerate';
import { decimalMark, readNumber } from '../src/logic/gridNumbers';
import { readPaste } from '../src/logic/gridPaste';
import { rollerRows } from '../src/logic/gridResults';
import { clamped, moved, rectangle, spotRange, tabbed } from '../src/logic/gridSelection';
import { boxLists, isList, listAround } from '../src/logic/gridTables';
import { listItems, withValue } from '../src/logic/gridValues';
import { inputColumns, isPlaced, sortedRows, viewRows, type ModelParts, type ViewColumn } from '../src/logic/gridView';
import type { Schema } from '../src/logic/schema';

const length: Schema = { type: 'string', 'x-unit': 'm' };
const box = { type: 'object', properties: { name: { type: ['string', 'number', 'boolean'] }, x: length, z: length, offset: { ...length, default: '0 m' }, rows: { type: 'integer' }, core: { type: 'string', enum: ['wire', 'fibre_rope'] } }, required: ['x', 'z'] };
const root = {
  properties: {
    supports: { properties: { stinger: { properties: { boxes: { anyOf: [{ type: 'object', properties: { count: { type: 'integer' } } }, { type: 'array', items: box }] } } } } },
    moorings: { properties: { lines: { type: 'array', items: { properties: { name: { type: ['string', 'number', 'boolean'] }, fairlead: { properties: { x: length, y: length, z: length }, required: ['x', 'y', 'z'] }, segments: { type: 'array', items: box } }, required: ['fairlead'] } } } },
    seeds: { type: 'array', items: { type: 'integer' } },
  },
} as unknown as Schema;
const list = 'supports.stinger.boxes';
const columns = listColumns(root, list);
const named = (key: string): GridColumn => columns.find((c) => c.key === key)!;

const field = (path: string, kind: Field['kind'], value: string | number | null, more: Partial<Field> = {}): Field =>
  ({ path, kind, value, si: null, unit: kind === 'quantity' ? 'm' : '', default: null, given: true, line: 1, text: '', ...more });

const fields: Field[] = [
  field(list, 'list', null, { count: 2 }),
  field(`${list}[0]`, 'map', null), field(`${list}[0].name`, 'text', 'first'), field(`${list}[0].x`, 'quantity', '5.230 m'), field(`${list}[0].z`, 'quantity', '-4.5 m'), field(`${list}[0].rows`, 'integer', '3'),
  field(`${list}[0].offset`, 'quantity', null, { given: false, default: '0 m' }),
  field(`${list}[1]`, 'map', null), field(`${list}[1].x`, 'quantity', '30 ft'), field(`${list}[1].z`, 'quantity', '-5.7 m'),
];
const model = (list = fields, drafts = new Map()): ModelParts => ({ fields: list, byPath: new Map(list.map((f) => [f.path, f])), diagnostics: new Map(), drafts });

describe('columns of a list', () => {
  test('are the members of its items with their units', () => {
    expect(columns.map((c) => [c.key, c.kind, c.unit, c.required])).toEqual([
      ['name', 'text', '', false], ['x', 'quantity', 'm', true], ['z', 'quantity', 'm', true], ['offset', 'quantity', 'm', false], ['rows', 'integer', '', false], ['core', 'choice', '', false],
    ]);
  });
  test('places get a column for each coordinate, lists one that leads to them', () => {
    expect(listColumns(root, 'moorings.lines').map((c) => [c.key, c.kind, c.required])).toEqual([
      ['name', 'text', false], ['fairlead.x', 'quantity', true], ['fairlead.y', 'quantity', true], ['fairlead.z', 'quantity', true], ['segments', 'nested', false],
    ]);
  });
  test('a list of values has one', () => { expect(listColumns(root, 'seeds').map((c) => c.key)).toEqual(['']); });
  test('next to results only required, given or requested columns are shown', () => {
    expect(shownColumns(columns, (key) => key === 'rows', ['offset'], true).map((c) => c.key)).toEqual(['name', 'x', 'z', 'offset', 'rows']);
    expect(shownColumns(columns, () => false, [], false)).toHaveLength(6);
  });
  test('lists are known by model or schema, also those that are not given', () => {
    expect(isList(list, new Map(), root)).toBe(true);
    expect(isList('supports.stinger', new Map(), root)).toBe(false);
    expect(listAround(`${list}[3].x`)).toBe(list);
    expect(listAround('tensioner.tension')).toBe('');
  });
});

describe('numbers as they are typed', () => {
  test('a decimal comma, thousands and other minus signs are read', () => {
    expect(readNumber('3,5')).toEqual({ digits: '3.5', rest: '' });
    expect(readNumber('1.234,5 kN')).toEqual({ digits: '1234.5', rest: 'kN' });
    expect(readNumber('1,234.50')).toEqual({ digits: '1234.50', rest: '' });
    expect(readNumber('12 345 mm')).toEqual({ digits: '12345', rest: 'mm' });
    expect(readNumber("12'345")).toEqual({ digits: '12345', rest: '' });
    expect(readNumber('−4.578')).toEqual({ digits: '-4.578', rest: '' });
    expect(readNumber('1e-3 m')).toEqual({ digits: '1e-3', rest: 'm' });
    expect(readNumber('abc')).toBeNull();
    expect(readNumber('1.2.3,4,5')).toBeNull();
  });
  test('three digits behind a comma may be thousands: the table decides, otherwise they are ambiguous', () => {
    expect(readNumber('1,234')).toBe('ambiguous');
    expect(readNumber('1,234', ',')).toEqual({ digits: '1.234', rest: '' });
    expect(readNumber('1,234', '.')).toEqual({ digits: '1234', rest: '' });
    expect(readNumber('0,027')).toEqual({ digits: '0.027', rest: '' });
    expect(readNumber('12.500', ',')).toEqual({ digits: '12500', rest: '' });
    expect(decimalMark(['1,234', '3,5'])).toBe(',');
    expect(decimalMark(['1,234', '3.5'])).toBe('.');
    expect(decimalMark(['1,234', '5'])).toBeNull();
  });
});

describe('a cell', () => {
  test('is shown in the unit of its head, as it is written where that is the same', () => {
    expect(headUnit(['5.2 m', '3 ft', '4 ft', null], 'm')).toBe('ft');
    expect(shownValue('5.230 m', 'm')).toBe('5.230');
    expect(shownValue('30 ft', 'm')).toBe('9.144');
    expect(shownValue('30 furlong', 'm')).toBe('30 furlong');
  });
  test('takes the unit of the head or the typed unit', () => {
    expect(readCell('3', named('x'), 'm')).toEqual({ value: '3 m' });
    expect(readCell('3 ft', named('x'), 'm')).toEqual({ value: '3 ft' });
    expect(readCell(' ', named('x'), 'm')).toEqual({ value: null });
    expect(unitLike('M', 'm')).toBe('m');
    expect(unitLike('kn', 'N')).toBe('kN');
    expect(unitLike('m²', 'm^2')).toBe('m^2');
    expect(unitLike('kNm', 'kN m')).toBe('kN m');
    expect(unitLike('kN', 'm')).toBeNull();
  });
  test('reports the error in an unreadable text', () => {
    expect(readCell('3 kN', named('x'), 'm')).toEqual({ message: '“kN” is not a unit of x. Units: m, mm, cm, km, in, ft.' });
    expect(readCell('abc', named('x'), 'm')).toHaveProperty('message');
    expect(readCell('1,234', named('x'), 'm')).toHaveProperty('message', '“1,234” is ambiguous: enter 1234 or 1.234.');
    expect(readCell('2.5', named('rows'), '')).toHaveProperty('message', 'Enter a whole number.');
    expect(readCell('rope', named('core'), '')).toHaveProperty('message', 'One of: wire, fibre_rope.');
    expect(readCell('Fibre rope', named('core'), '')).toEqual({ value: 'fibre_rope' });
  });
});

describe('a table from a spreadsheet', () => {
  test('is read with tabs, semicolons or commas, and with quotes', () => {
    expect(parseTable('a\tb\r\n1,5\t2\r\n')).toEqual([['a', 'b'], ['1,5', '2']]);
    expect(parseTable('a;b\n1,5;2')).toEqual([['a', 'b'], ['1,5', '2']]);
    expect(parseTable('name,x\n"box, 1",5')).toEqual([['name', 'x'], ['box, 1', '5']]);
    expect(parseTable('3,5\n4,25')).toEqual([['3,5'], ['4,25']]);
    expect(tabText([['a', 'b\nc']])).toBe('a\tb c\n');
  });
  test('headings are recognised by name, with units behind them or in a row below', () => {
    expect(splitTitle('x [m]')).toEqual({ title: 'x', unit: 'm' });
    expect(splitTitle('Elevation (ft)')).toEqual({ title: 'Elevation', unit: 'ft' });
    const known = columns.map((c) => ({ id: c.key, title: c.title, unit: c.unit }));
    const head = readHead([['Box', 'X', 'Elevation', 'weight'], ['', 'ft', 'ft', 'kN'], ['1', '2', '3', '4']], known)!;
    expect(head).toEqual({ columns: ['name', 'x', 'z', null], units: ['', 'ft', 'ft', 'kN'], ignored: ['weight'], rows: [['1', '2', '3', '4']] });
    expect(readHead([['5.2', '-4.5']], known)).toBeNull();
    expect(readHead([['stinger 9', 'ramp_v']], known)).toBeNull();
  });

  const views: ViewColumn[] = inputColumns(columns, [{ path: list, title: 'stinger' }], model(), {});
  const values = (text: string, from = 0, sizes?: Map<string, number>) => readPaste(text, views, from, [], sizes).rows.map((row) => row.cells.map((c) => ('value' in c.read ? c.read.value : c.read.message)));

  test('goes to the columns of its headings, in their units', () => {
    expect(values('z (ft)\tx [mm]\n-15,5\t5230')).toEqual([['-15.5 ft', '5230 mm']]);
    expect(values('x [kN]\n5')).toEqual([['“kN” is not a unit of x. Units: m, mm, cm, km, in, ft.']]);
  });
  test('without headings it starts at the selected column', () => {
    expect(values('5\t-4\t0\t3', 1)).toEqual([['5 m', '-4 m', '0 m', 3]]);
  });
  test('commas in all numbers are read by the magnitude of the present values', () => {
    expect(values('x\n5,200\n9,000', 0, new Map([['x', 31]]))).toEqual([['5.200 m'], ['9.000 m']]);
    expect(values('x [mm]\n5,200\n9,000', 0, new Map([['x', 31]]))).toEqual([['5200 mm'], ['9000 mm']]);
    expect(values('x\n5,200')[0]![0]).toContain('is ambiguous');
  });
});

describe('changes of a list', () => {
  const items = [{ name: 'a 1', x: '1 m' }, { name: 'a 2', x: '3 m' }];
  test('cells are written individually, new rows as a whole with the common values of the rows', () => {
    expect(cellChanges('l', items, [{ row: 1, key: 'x', value: '4 m' }, { row: 0, key: 'z', value: null }, { row: 2, key: 'x', value: '5 m' }], () => ({ length: '2 m' }))).toEqual([
      { path: 'l[1].x', value: '4 m' }, { path: 'l[2]', value: { length: '2 m', x: '5 m' } },
    ]);
  });
  test('many cells are written row by row', () => {
    const many = Array.from({ length: 100 }, (_none, i) => ({ row: i % 2, key: `k${i}`, value: i }));
    const changes = cellChanges('l', items, many);
    expect(changes.map((c) => c.path)).toEqual(['l[0]', 'l[1]']);
    expect(changes[0]!.value).toMatchObject({ name: 'a 1', k0: 0, k98: 98 });
  });
  test('another order rewrites only what differs, and what is left over goes from the end', () => {
    expect(listChanges('l', [1, 2, 3, 4], [1, 3])).toEqual([{ path: 'l[1]', value: 3 }, { path: 'l[3]', value: null }, { path: 'l[2]', value: null }]);
    expect(listChanges('l', [1], [])).toEqual([{ path: 'l', value: null }]);
    expect(removal('l', 4, [1, 3])).toEqual([{ path: 'l[3]', value: null }, { path: 'l[1]', value: null }]);
  });
  test('copies get names of their own', () => { expect(duplicated(items, [0])).toEqual([items[0], { name: 'a 3', x: '1 m' }, items[1]]); });
  test('rows are moved past their neighbour', () => {
    expect(shifted(['a', 'b', 'c', 'd'], 1, 2, -1)).toEqual(['b', 'c', 'a', 'd']);
    expect(shifted(['a', 'b', 'c', 'd'], 1, 2, 1)).toEqual(['a', 'd', 'b', 'c']);
    expect(shifted(['a', 'b'], 0, 0, -1)).toEqual(['a', 'b']);
  });
  test('a new row continues with the step of the last two', () => {
    expect(nextItem(items, columns, null)).toEqual({ name: 'a 3', x: '5 m' });
    expect(nextItem([], [{ ...named('x'), example: '1 m' }], null)).toEqual({ x: '1 m' });
  });
  test('items are known with all that is nested in them, or not at all', () => {
    expect(listItems(fields, list)).toEqual([{ name: 'first', x: '5.230 m', z: '-4.5 m', rows: 3 }, { x: '30 ft', z: '-5.7 m' }]);
    expect(listItems([field(list, 'list', null, { count: 300 }), ...fields.slice(1)], list)).toBeNull();
    expect(withValue({ at: { x: '1 m' } }, 'at.y', '2 m')).toEqual({ at: { x: '1 m', y: '2 m' } });
    expect(withValue({ a: 1, b: 2 }, 'b', null)).toEqual({ a: 1 });
  });
});

describe('contents of a grid', () => {
  const lists = [{ path: list, title: 'stinger', standardName: (i: number) => `stinger ${i + 1}` }];
  const rows = (parts = model()) => viewRows(lists, inputColumns(columns, lists, parts, {}), [], parts);
  test('values in the unit of the column, and defaults of omitted ones', () => {
    expect(rows()[0]!.cells.map((c) => [c.text, c.state]).slice(0, 4)).toEqual([['first', ''], ['5.230', ''], ['-4.5', ''], ['0', 'standard']]);
    expect(rows()[1]!.cells.map((c) => c.text).slice(0, 2)).toEqual(['stinger 2', '9.144']);
    expect(rows()[1]!.name).toBe('stinger 2');
  });
  test('an unreadable text, until the model gets another value there', () => {
    const drafts = (base: string) => new Map([[`${list}[0].x`, { text: 'abc', message: 'A number.', base }]]);
    expect(rows(model(fields, drafts('5.230 m')))[0]!.cells[1]).toMatchObject({ text: 'abc', state: 'bad', message: 'A number.' });
    expect(rows(model(fields, drafts('4 m')))[0]!.cells[1]).toMatchObject({ text: '5.230', state: '' });
  });
  test('the diagnostic of a key in its cell', () => {
    const parts = { ...model(), diagnostics: new Map([[`${list}[1].x`, { severity: 'error' as const, line: 1, column: 1, key: '', message: 'x increases' }]]) };
    expect(rows(parts)[1]!.cells[1]).toMatchObject({ severity: 'error', message: 'x increases' });
  });
  test('rows in the order of a column, empty ones last', () => {
    expect(sortedRows(rows(), 1, true).map((r) => r.index)).toEqual([1, 0]);
    expect(sortedRows(rows(), 4, false).map((r) => r.index)).toEqual([0, 1]);
  });
  test('boxes of ramp and stinger, or of its sections with continuous numbers', () => {
    const given = (path: string, kind: Field['kind'], more = {}): [string, Field] => [path, field(path, kind, null, more)];
    const two = new Map([given('supports.ramp', 'map'), given('supports.stinger', 'map'), given('supports.stinger.sections', 'list', { count: 2 }), given('supports.stinger.sections[0].boxes', 'list', { count: 3 })]);
    expect(boxLists(two).map((l) => [l.path, l.standardName!(0)])).toEqual([['supports.ramp.boxes', 'ramp 1'], ['supports.stinger.sections[0].boxes', 'stinger 1'], ['supports.stinger.sections[1].boxes', 'stinger 4']]);
  });
  test('rollers by their rows', () => {
    const rollers = ['bottom', 'port', 'bottom', 'port'].map((position) => ({ position })) as never;
    expect(rollerRows(rollers).map((r) => r.length)).toEqual([2, 2]);
  });
});

describe('the selection', () => {
  test('is moved by keys, extended with Shift, and stays within the table', () => {
    const range = spotRange({ row: 1, column: 1 });
    expect(moved(range, 'ArrowDown', {}, 3, 3)!.focus).toEqual({ row: 2, column: 1 });
    expect(moved(range, 'ArrowRight', { control: true }, 3, 5)!.focus).toEqual({ row: 1, column: 4 });
    expect(rectangle(moved(range, 'ArrowUp', { shift: true }, 3, 3)!)).toEqual({ top: 0, bottom: 1, left: 1, right: 1 });
    expect(moved(range, 'PageDown', {}, 3, 3)!.focus.row).toBe(2);
    expect(moved(range, 'a', {}, 3, 3)).toBeNull();
    expect(clamped(range, 0, 3)).toBeNull();
  });
  test('Tab goes on in the next row and leaves the table at its end', () => {
    expect(tabbed(spotRange({ row: 0, column: 2 }), false, 2, 3)!.focus).toEqual({ row: 1, column: 0 });
    expect(tabbed(spotRange({ row: 1, column: 2 }), false, 2, 3)).toBeNull();
  });
});

describe('boxes on an arc', () => {
  const request = { radius: '120 m', count: '8', spacing: '4 m', length: '3 m', x: '', z: '', incline: '' };
  const ramp = [{ x: -18.29, z: 0.036 }, { x: -9.47, z: -1.24 }, { x: -0.452, z: -3.089 }];
  const end = { ...ramp[2]!, incline: lastIncline(ramp, 0) };
  test('are placed as by the program: bgl1 with a radius of 120 m', () => {
    const boxes = generatedBoxes(request, end);
    expect(boxes).toHaveLength(8);
    expect(boxes[0]!.x).toBeCloseTo(3.4248, 3);
    expect(boxes[0]!.z).toBeCloseTo(-0.255344 - 3.818, 3);
    expect(boxes[7]!.x).toBeCloseTo(29.34784, 3);
    expect((boxes[0]!.incline * 180) / Math.PI).toBeCloseTo(15.2016, 2);
  });
  test('a circle keeps its direction', () => {
    const circle = arcBoxes({ x: 0, z: 0, incline: 0.1 }, 100, 5, 3);
    expect(lastIncline(circle, 0)).toBeCloseTo(circle[2]!.incline, 9);
  });
  test('missing input is reported before anything is written', () => {
    expect(findArcErrors(request, end)).toEqual([]);
    expect(findArcErrors({ ...request, radius: '0 m', count: 'x' }, end).map((f) => f.key)).toEqual(['radius', 'count']);
    expect(findArcErrors(request, null).map((f) => f.key)).toEqual(['x', 'z']);
  });
  test('are written as a row, or as a list in the place of what was there', () => {
    expect(rowChanges('supports.stinger', request)[0]).toEqual({ path: list, value: { count: 8, spacing: '4 m', length: '3 m' } });
    const changes = writtenOut('supports.stinger', request, [{ x: 3.42481, z: -4.07334, incline: 0 }], true);
    expect(changes).toEqual([{ path: list, value: null }, { path: `${list}[0]`, value: { x: '3.4248 m', z: '-4.0733 m', length: '3 m' } }, { path: 'supports.stinger.radius', value: null }]);
  });
});

test('boxes that the program places on an arc are read-only rows', () => {
  const lists = [{ path: list, title: 'stinger', standardName: (i: number) => `stinger ${i + 1}`, placed: [{ x: '3.425 m', z: '-4.073 m' }] }];
  const rows = viewRows(lists, inputColumns(columns, lists, model([]), {}), [], model([]));
  expect(rows[0]!.cells.map((c) => [c.text, c.state]).slice(0, 3)).toEqual([['stinger 1', 'fixed'], ['3.425', 'fixed'], ['-4.073', 'fixed']]);
  expect(isPlaced(rows[0]!)).toBe(true);
});
