import { describe, expect, test } from 'vitest';
import { complete, fromSi, convertLike, parseQuantity, tidy, tidyLength, toSi, twin } from '../src/logic/units';
import { UndoStack } from '../src/logic/undo';
import { LatestGate } from '../src/logic/gate';
import { loadShares, pictureScale, quantityLimit } from '../src/logic/colour';
import { aboveLimit, readHex, valueShares, viridis } from '../src/components/colourScale';
import { indexBefore, nearest, resample } from '../src/logic/series';
import { tube, tubeIndices } from '../src/logic/tube';
import { fitCircle, fittedRadius, withRadius } from '../src/logic/stinger';
import { axisNames } from '../src/logic/show';
import { elevation, surface } from '../src/logic/waves';
import { check, completed, type Answers } from '../src/logic/start';
import { blend, decode } from '../src/logic/frames';
import { diagramRows } from '../src/charts/data';
import { csvText } from '../src/components/tableText';

describe('units', () => {
  test('16 in and 406.4 mm are the same, whichever is typed', () => {
    expect(twin('16 in')).toBe('406.4 mm');
    expect(twin('406.4 mm')).toBe('16 in');
    expect(twin('55 kip')).toBe('244.7 kN');
    expect(twin('414 MPa')).toBe('60.05 ksi');
    expect(twin('30 deg')).toBe('');
    expect(twin('abc')).toBe('');
  });
  test('round trip through SI', () => {
    for (const unit of ['m', 'mm', 'in', 'ft', 'kN', 'kip', 'MPa', 'ksi', 'kN/m^3', 'lbf/ft^3', 'knot', 'deg']) expect(fromSi(toSi(12.5, unit), unit)).toBeCloseTo(12.5, 10);
  });
  test('reads numbers with exponents, signs and no space', () => {
    expect(parseQuantity(' -1.5e3kN ')).toEqual({ number: -1500, unit: 'kN' });
    expect(parseQuantity('.5 m')).toEqual({ number: 0.5, unit: 'm' });
    expect(parseQuantity('kN')).toBeNull();
  });
  test('slider values are written in the unit of the file', () => {
    expect(convertLike('250 kN', '55 kip')).toBe('56.20224 kip');
    expect(convertLike('250 kN', '240 kN')).toBe('250 kN');
    expect(convertLike('250 kN', '')).toBe('250 kN');
  });
  test('a bare number takes the unit that was there', () => {
    expect(complete('260', 'kN')).toBe('260 kN');
    expect(complete('16in', 'mm')).toBe('16 in');
    expect(complete('jonswap', '')).toBe('jonswap');
  });
  test('numbers without noise', () => {
    expect(tidy(0.1 + 0.2)).toBe('0.3');
    expect(tidy(123456.789)).toBe('123460');
    expect(tidy(Number.NaN)).toBe('–');
  });
  test('the name of an axis is cut from its front, down to its unit', () => {
    expect(axisNames('horizontal distance from the tensioner [m]')).toEqual(['horizontal distance from the tensioner [m]', 'from the tensioner [m]', '[m]']);
    expect(axisNames('time [s]')).toEqual(['time [s]', '[s]']);
  });
  test('shows lengths to a tenth of a millimetre', () => {
    expect(tidyLength(-8.228e-5)).toBe('-0.0001');
    expect(tidyLength(-3e-5)).toBe('0');
    expect(tidyLength(335.6143)).toBe('335.6');
  });
});

describe('undo', () => {
  test('typing without a pause is one step, other changes are each one', () => {
    const u = new UndoStack('a');
    u.push('ab', 'yaml', 0);
    u.push('abc', 'yaml', 100);
    u.push('abcd', 'form', 150);
    expect(u.undo()).toBe('abc');
    expect(u.undo()).toBe('a');
    expect(u.undo()).toBeNull();
    expect(u.redo()).toBe('abc');
    expect(u.redo()).toBe('abcd');
    expect(u.redo()).toBeNull();
  });
  test('a new change discards the redo steps', () => {
    const u = new UndoStack('a');
    u.push('b', 'form', 0);
    u.undo();
    u.push('c', 'form', 1);
    expect(u.canRedo).toBe(false);
    expect(u.undo()).toBe('a');
  });
  test('is restored with its position', () => {
    const u = new UndoStack('a');
    u.push('b', 'form', 0);
    u.push('c', 'form', 1);
    u.undo();
    const again = UndoStack.from(JSON.parse(JSON.stringify(u.keep(100))) as ReturnType<UndoStack['keep']>, 'b');
    expect([again.text, again.redo(), again.undo(), again.undo(), again.undo()]).toEqual(['b', 'c', 'b', 'a', null]);
    expect(UndoStack.from(u.keep(100), 'of another tab').undo()).toBe('b');
    expect(UndoStack.from(u.keep(2), 'b').undo()).toBe('a');
    expect(UndoStack.from(u.keep(1), 'b').canUndo).toBe(false);
    expect(UndoStack.from(null, 'x').canUndo).toBe(false);
  });
  test('does not grow without end', () => {
    const u = new UndoStack('0', 800, 3);
    for (let i = 1; i < 10; ++i) u.push(String(i), 'form', i);
    expect([u.undo(), u.undo(), u.undo(), u.undo()]).toEqual(['8', '7', '6', null]);
  });
});

test('gate: one request at a time, of the waiting ones only the newest', async () => {
  const asked: number[] = [];
  const got: number[] = [];
  let open: (() => void)[] = [];
  const gate = new LatestGate<number, number>(
    (n) => new Promise((resolve, reject) => { asked.push(n); open.push(() => (n === 3 ? reject(new Error('no')) : resolve(n * 10))); }),
    (answer) => got.push(answer),
    () => got.push(-1),
  );
  const turn = async (): Promise<void> => { const list = open; open = []; list.forEach((f) => f()); await new Promise((r) => setTimeout(r, 0)); };
  gate.submit(1); gate.submit(2); gate.submit(3);
  expect(asked).toEqual([1]);
  await turn();
  expect(asked).toEqual([1, 3]);
  await turn();
  gate.submit(4);
  await turn();
  expect(got).toEqual([10, -1, 40]);
  expect(gate.skipped).toBe(1);
  expect(gate.inFlight).toBe(false);
});

test('colours: ends, middle, and nonsense', () => {
  expect(loadShares(0)).toEqual(loadShares(-5));
  expect(loadShares(1)).toEqual(loadShares(7));
  const scale = { low: 0, top: 10, high: 20 };
  expect(valueShares(scale, Number.NaN, [0, 0, 0])).toEqual(valueShares(scale, 0, [0, 0, 0]));
  expect(valueShares(scale, 10, [0, 0, 0]).map((v) => Math.round(255 * v))).toEqual(readHex(viridis(1)));
  expect(valueShares(scale, 11, [0, 0, 0])[0]).toBeGreaterThan(valueShares(scale, 11, [0, 0, 0])[1]); // red
});

test('the scale of the picture ends at the limit, and what lies above it leaves the scale', () => {
  expect(pictureScale(0, 330, 414)).toEqual({ low: 0, top: 414, high: 414 });
  expect(pictureScale(0, 450, 414)).toMatchObject({ top: 414, high: 500 });
  expect(pictureScale(0, 90, 414)).toEqual({ low: 0, top: 90, high: 90 });
  expect(pictureScale(205, 250, null)).toMatchObject({ low: 200 });
});

test('stresses have the yield stress of the model as their limit, tension has none', () => {
  const lay = { key: { overbend: { von_mises: 331.2e6, utilisation: 0.8 } } } as unknown as Parameters<typeof quantityLimit>[1];
  expect(quantityLimit('von_mises', lay)?.value).toBeCloseTo(414e6, -1);
  expect(quantityLimit('effective_tension', lay)).toBeNull();
  expect(quantityLimit('checks', null)).toEqual({ value: 1, name: 'allowable' });
});

test('roller loads have no colour of the pipe', () => {
  for (let k = 0; k <= 20; ++k) {
    const load = loadShares(k / 20).map((v) => 255 * v);
    for (let m = 0; m <= 20; ++m) expect(Math.hypot(...readHex(viridis(m / 20)).map((v, i) => v - load[i]!))).toBeGreaterThan(45);
    expect(Math.hypot(...readHex(aboveLimit).map((v, i) => v - load[i]!))).toBeGreaterThan(60);
  }
});

describe('series', () => {
  test('places', () => {
    expect(indexBefore([0, 1, 2], 1.9)).toBe(1);
    expect(indexBefore([0, 1, 2], -4)).toBe(0);
    expect(nearest([0, 1, 2], 1.9)).toBe(2);
    expect(resample([0, 2], [0, 10], [-1, 0, 1, 2, 3])).toEqual([null, 0, 5, 10, null]);
  });
});

describe('tube', () => {
  const points = Array.from({ length: 40 }, (_, i) => [Math.cos(i / 9) * 30, i * 0.2, Math.sin(i / 9) * 30]).flat();
  test('normals are of unit length, across the line, and do not twist', () => {
    const t = tube(points, 8);
    for (let i = 1; i < 39; ++i) {
      const d = [0, 1, 2].map((k) => points[3 * i + 3 + k]! - points[3 * i - 3 + k]!);
      const n = Array.from(t.normals.slice(24 * i, 24 * i + 3));
      const before = Array.from(t.normals.slice(24 * i - 24, 24 * i - 21));
      expect(Math.hypot(...n)).toBeCloseTo(1, 5);
      expect(n.reduce((s, v, k) => s + v * d[k]!, 0) / Math.hypot(...d)).toBeCloseTo(0, 5);
      expect(n.reduce((s, v, k) => s + v * before[k]!, 0)).toBeGreaterThan(0.9);
    }
  });
  test('arrays are used again', () => { const t = tube(points, 8); expect(tube(points, 8, t)).toBe(t); });
  test('triangles name existing points', () => { const k = tubeIndices(5, 6); expect(k.length).toBe(4 * 36); expect(Math.max(...k)).toBe(29); });
  test('a vertical line', () => expect([...tube([0, 0, 0, 0, 0, 1], 4).normals].every(Number.isFinite)).toBe(true));
});

describe('stinger radius', () => {
  const boxes = Array.from({ length: 8 }, (_, i) => { const a = 0.2 + (i * 4) / 150; return { x: 5 + 150 * (Math.sin(a) - Math.sin(0.2)), z: -4 + 150 * (Math.cos(a) - Math.cos(0.2)) }; });
  test('finds the circle', () => { const c = fitCircle(boxes)!; expect(c.radius).toBeCloseTo(150, 6); expect(c.slope).toBeCloseTo(0.2, 8); });
  test('the same radius moves nothing', () => withRadius(boxes, 1)!.forEach((b, i) => { expect(b.x).toBeCloseTo(boxes[i]!.x, 9); expect(b.z).toBeCloseTo(boxes[i]!.z, 9); }));
  test('a new radius keeps first box, slope and distances along the curve', () => {
    const wide = withRadius(boxes, 2)!;
    const c = fitCircle(wide)!;
    expect(wide[0]).toEqual({ x: expect.closeTo(boxes[0]!.x, 9), z: expect.closeTo(boxes[0]!.z, 9) });
    expect(c.radius).toBeCloseTo(300, 5);
    expect(c.slope).toBeCloseTo(0.2, 7);
    expect(wide[7]!.z).toBeGreaterThan(boxes[7]!.z);
  });
  test('the least-squares circle need not pass through the first box', () => {
    expect(fittedRadius(boxes)).toBeCloseTo(150, 5);
    const off = boxes.map((b, i) => ({ x: b.x, z: b.z + (i === 0 ? 0.05 : 0) }));
    expect(Math.abs(fittedRadius(off)! - 150)).toBeLessThan(Math.abs(fitCircle(off)!.radius - 150));
    expect(fittedRadius([{ x: 0, z: 0 }, { x: 1, z: -1 }, { x: 2, z: -2 }])).toBeNull();
    expect(fittedRadius([{ x: 0, z: 0 }, { x: 1, z: -1 }, { x: 2, z: 0 }])).toBeNull();
  });
  test('a straight or sagging row has no radius', () => {
    expect(withRadius([{ x: 0, z: 0 }, { x: 1, z: 0 }, { x: 2, z: 0 }], 2)).toBeNull();
    expect(withRadius([{ x: 0, z: 0 }, { x: 1, z: -1 }, { x: 2, z: 0 }], 2)).toBeNull();
  });
});

test('water: grid and point agree', () => {
  const waves = [{ amplitude: 1.2, number: 0.03, frequency: 0.5, phase: 1, direction: 0.4 }, { amplitude: 0.7, number: 0.06, frequency: 0.8, phase: 4, direction: -2 }];
  const grid = surface(waves, [0, 10, 20], [-5, 5], 12, new Float32Array(6));
  expect(grid[4]).toBeCloseTo(elevation(waves, 10, 5, 12), 5);
});

describe('start dialog', () => {
  const good: Answers = { title: '', pipe: '16 in', wall: '11.1 mm', yield: '414 MPa', coating: '3 mm', concrete: '40 mm', depth: '89 m', vessel: 'bgl1', lay: 's', stinger_radius: '150 m', boxes: '8', tension: '250 kN' };
  test('valid and omitted answers have no errors', () => {
    expect(check(good, 0.4064)).toEqual({});
    expect(check({ ...good, wall: '', tension: '', boxes: '' }, 0.4064)).toEqual({});
  });
  test('errors are reported at their answer', () => {
    expect(check({ ...good, depth: '89', wall: '11.1' }, 0.4)).toEqual({}); // taken in m and mm
    expect(check({ ...good, depth: '1' }, 0.4).depth).toMatch(/between/);
    expect(check({ ...good, depth: '89 kN' }, 0.4).depth).toMatch(/not one of/);
    expect(check({ ...good, depth: '' }, 0.4).depth).toMatch(/number/);
    expect(check({ ...good, wall: '90 mm' }, 0.1683).wall).toMatch(/pipe radius/);
    expect(check({ ...good, boxes: '2.5' }, 0.4).boxes).toMatch(/whole/);
    expect(check({ ...good, tension: '0 kN' }, 0.4).tension).toMatch(/between/);
    expect(check({ ...good, lay: 'j', boxes: 'x' }, 0.4).boxes).toBeUndefined();
  });
});

test('an answer without unit takes the previous unit, as a field does', () => {
  expect(completed('depth', '290')).toBe('290 m');
  expect(completed('depth', '290', '300 ft')).toBe('290 ft');
  expect(completed('depth', '290 in', '300 ft')).toBe('290 in');
  expect(completed('boxes', '8')).toBe('8');
});

test('frames come out as they went in', () => {
  const pack = (v: number[]): string => btoa(String.fromCharCode(...new Uint8Array(new Float32Array(v).buffer)));
  const c = decode({ total: 9, from: 4, stations: 1, time: [2, 3], pose: [[], []], place: pack([1, 2, 3, 4, 5, 6]), effective_tension: pack([7, 8]), von_mises: pack([9, 10]) });
  expect([...c.place]).toEqual([1, 2, 3, 4, 5, 6]);
  expect([...blend(c.place, 0, c.place, 3, 3, 0.5, new Float32Array(3))]).toEqual([2.5, 3.5, 4.5]);
});

test('a diagram as CSV has units in its head and quotes commas', () => {
  const lines = [{ name: 'static, now', colour: '#123456', values: [1, null, 3] }];
  const data = { title: 'Tension', xName: 's [m]', yName: 'tension [kN]', x: [0, 1, 2], s: [], marks: [], level: [], lines };
  expect(csvText(diagramRows(data))).toBe('s [m],"static, now [kN]"\r\n0,1\r\n1,\r\n2,3\r\n');
});
