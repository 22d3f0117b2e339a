import { describe, expect, test } from 'vitest';
import { liveChanges, readBase } from '../src/logic/live';
import { fittedRadius } from '../src/logic/stinger';
import { boxHeight, currentFactor, stingerRadius, type NumericField } from '../src/logic/variables';

const quantity = (path: string, value: string, si: number): NumericField => ({ path, kind: 'quantity', value, si, unit: value.split(' ')[1] ?? '', given: true });
const known: NumericField[] = [
  quantity('tensioner.tension', '250 kN', 250e3),
  quantity('environment.water_depth', '89 m', 89),
  { path: 'vessel.trim', kind: 'quantity', value: null, si: null, unit: 'deg', default: '0 deg', given: false },
  { path: 'pipe.hydrodynamics.drag', kind: 'number', value: 0.7, si: 0.7, unit: '', given: true },
  quantity('environment.current[0].speed', '1 m/s', 1),
  quantity('environment.current[1].speed', '0.4 m/s', 0.4),
  ...[0.1, 0.14, 0.18, 0.22].map((turn) => [-20 + 150 * Math.sin(turn), 150 * Math.cos(turn)]).flatMap(([x, z], i) => [
    quantity(`supports.stinger.boxes[${i}].x`, `${x} m`, x!),
    quantity(`supports.stinger.boxes[${i}].z`, `${z} m`, z!),
  ]),
];

describe('trial values', () => {
  const base = readBase(known);
  test('the model determines the available variables', () => {
    expect(base.radius).toBeCloseTo(150, 6);
    expect(base.current).toEqual([1, 0.4]);
    expect(base.boxes).toHaveLength(4);
    expect(readBase([]).radius).toBeNull();
  });
  test('nothing varied, nothing sent', () => expect(liveChanges(base, {})).toEqual([]));
  test('any numeric key goes out in the unit in which the model writes it', () => {
    expect(liveChanges(base, { 'tensioner.tension': 260e3, 'environment.water_depth': 95.5, 'vessel.trim': Math.PI / 180, 'pipe.hydrodynamics.drag': 0.75 })).toEqual([
      { path: 'tensioner.tension', value: '260 kN' },
      { path: 'environment.water_depth', value: '95.5 m' },
      { path: 'vessel.trim', value: '1 deg' },
      { path: 'pipe.hydrodynamics.drag', value: 0.75 },
    ]);
    expect(liveChanges(base, { [currentFactor]: 0.5 }).map((c) => c.value)).toEqual(['0.5 m/s', '0.2 m/s']);
  });
  test('a value in feet is written in feet', () => {
    const depth = readBase([{ path: 'environment.water_depth', kind: 'quantity', value: '300 ft', si: 91.44, unit: 'm', given: true }]);
    expect(liveChanges(depth, { 'environment.water_depth': 0.3048 * 310 })).toEqual([{ path: 'environment.water_depth', value: '310 ft' }]);
  });
  test('a key that the model does not have is left out', () => expect(liveChanges(base, { 'pipe.nothing': 3 })).toEqual([]));
  test('a box with a height of its own keeps it when the radius changes', () => {
    const alone = liveChanges(base, { [stingerRadius]: 200 });
    const both = liveChanges(base, { [stingerRadius]: 200, 'supports.stinger.boxes[2].z': 127.5 });
    expect(both.find((c) => c.path.endsWith('boxes[2].z'))!.value).toBe('127.5 m');
    expect(both).toHaveLength(alone.length);
    expect(alone.every((c) => c.path.startsWith('supports.stinger.boxes['))).toBe(true);
    expect(alone.some((c) => c.path.startsWith('supports.stinger.boxes[0]'))).toBe(false);
  });
  test('listed boxes move to the varied circle from any radius', () => {
    const moved = new Map(liveChanges(base, { [stingerRadius]: 200 }).map((c) => [c.path, Number.parseFloat(String(c.value))]));
    const boxes = base.boxes.map((b) => ({ x: moved.get(`${b.path}.x`) ?? b.x, z: moved.get(`${b.path}.z`) ?? b.z }));
    expect(fittedRadius(boxes)! / 200).toBeCloseTo(1, 2); // places to a tenth of a millimetre, over an arc 0.3 m high
  });
  test('all boxes of the stinger are raised together', () => {
    const raised = liveChanges(base, { [boxHeight]: 0.1 });
    expect(raised.map((c) => c.path)).toEqual([0, 1, 2, 3].map((i) => `supports.stinger.boxes[${i}].z`));
    expect(Number.parseFloat(String(raised[0]!.value)) - base.boxes[0]!.z).toBeCloseTo(0.1, 4);
  });
  test('of boxes given as a row the radius is a separate key', () => {
    const row = readBase([quantity('supports.stinger.radius', '150 m', 150), { path: 'supports.stinger.boxes.count', kind: 'integer', value: 8, si: 8, given: true }]);
    expect(row).toMatchObject({ radius: null, boxes: [] });
    expect(liveChanges(row, { 'supports.stinger.radius': 200 })).toEqual([{ path: 'supports.stinger.radius', value: '200 m' }]);
  });
});
