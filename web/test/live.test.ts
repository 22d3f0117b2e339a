import { describe, expect, test } from 'vitest';
import { fittedRadius } from '../src/logic/stinger';
import { liveChanges, readBase, span, type Known } from '../src/logic/live';

const known: Known[] = [
  { path: 'tensioner.tension', si: 250e3 },
  { path: 'environment.water_depth', si: 89 },
  { path: 'environment.current[0].speed', si: 1 },
  { path: 'environment.current[1].speed', si: 0.4 },
  ...[0.1, 0.14, 0.18, 0.22].map((turn) => [-20 + 150 * Math.sin(turn), 150 * Math.cos(turn)]).flatMap(([x, z], i) => [
    { path: `supports.stinger.boxes[${i}].x`, si: x! }, { path: `supports.stinger.boxes[${i}].z`, si: z! }, { path: `supports.stinger.boxes[${i}].name`, si: null, value: `box ${i}` },
  ]),
];

describe('sliders', () => {
  const base = readBase(known);
  test('the model says what there is to drag', () => {
    expect(base).toMatchObject({ tension: 250e3, depth: 89, trim: 0, current: [1, 0.4] });
    expect(base.radius).toBeCloseTo(150, 6);
    expect(base.boxes.map((b) => b.name)).toEqual(['box 0', 'box 1', 'box 2', 'box 3']);
    expect(readBase([]).radius).toBeNull();
  });
  test('nothing dragged, nothing sent', () => expect(liveChanges(base, {})).toEqual([]));
  test('values go out with units', () => {
    expect(liveChanges(base, { tension: 260e3, depth: 95.5, trim: Math.PI / 180 })).toEqual([
      { path: 'tensioner.tension', value: '260 kN' }, { path: 'environment.water_depth', value: '95.5 m' }, { path: 'vessel.trim', value: '1 deg' },
    ]);
    expect(liveChanges(base, { current: 0.5 }).map((c) => c.value)).toEqual(['0.5 m/s', '0.2 m/s']);
  });
  test('a raised box stays raised when the radius changes too', () => {
    const alone = liveChanges(base, { radius: 200 });
    const both = liveChanges(base, { radius: 200, 'stinger 3': 0.1 });
    const z = (list: typeof alone): number => Number.parseFloat(list.find((c) => c.path.endsWith('boxes[2].z'))!.value);
    expect(z(both) - z(alone)).toBeCloseTo(0.1, 4);
    expect(alone.every((c) => c.path.startsWith('supports.stinger.boxes['))).toBe(true);
    expect(alone.some((c) => c.path.startsWith('supports.stinger.boxes[0]'))).toBe(false);
  });
  test('listed boxes come to lie on the circle that is dragged, whatever radius they had', () => {
    const moved = new Map(liveChanges(base, { radius: 200 }).map((c) => [c.path, Number.parseFloat(c.value)]));
    const boxes = base.boxes.map((b) => ({ x: moved.get(`${b.path}.x`) ?? b.x, z: moved.get(`${b.path}.z`) ?? b.z }));
    expect(fittedRadius(boxes)! / 200).toBeCloseTo(1, 2); // places to a tenth of a millimetre, over an arc 0.3 m high
  });
  test('of boxes told as a row the radius alone is dragged', () => {
    const row = readBase([{ path: 'supports.stinger.radius', si: 150 }, { path: 'supports.stinger.boxes.count', si: 8 }]);
    expect(row).toMatchObject({ radius: 150, row: true, boxes: [] });
    expect(liveChanges(row, { radius: 200 })).toEqual([{ path: 'supports.stinger.radius', value: '200 m' }]);
  });
  test('round ends', () => expect(span(250, 0.4, 2)).toEqual([100, 500]));
});
