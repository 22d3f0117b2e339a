import { describe, expect, test } from 'vitest';
import { carried, columnsFor, largestOfRun, lineLevel, lineTable, poseAt, sceneAt, mooredStateAt } from '../src/logic/moorings';
import { cellText, nextOrder, rowOrder, titleWithUnit, type SortOrder } from '../src/components/tableText';
import { alongLine, around, ellipse, labelAt, outline, scaleLength, scatter } from '../src/logic/plan';
import { firstItem, nextName } from '../src/logic/firstItems';
import { lineNames, parseAngles, spreadChanges, findSpreadErrors, usualAngles, type SpreadRequest } from '../src/logic/spread';
import { firstView, shownViews, availableViews } from '../src/logic/views';
import type { Lay, MooringLine, Moorings, Scene, VesselOffset } from '../src/api/types';

const atRest: VesselOffset = { surge: 0, sway: 0, heave: 0, roll: 0, pitch: 0, yaw: 0, natural_periods: [] };
// heads east: forward is x, port is y
const east = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
const north = [10, 20, 0, 0, -1, 0, 1, 0, 0, 0, 0, 1];
const close = (a: readonly number[], b: readonly number[]): void => a.forEach((v, i) => expect(v).toBeCloseTo(b[i]!, 10));

describe('hull position', () => {
  test('nowhere else without an offset', () => { close(poseAt(east, atRest), east); close(poseAt(north, atRest), north); });
  test('a nominal trim is kept', () => {
    const trimmed = poseAt(north, { ...atRest, roll: 0.05, pitch: -0.1 });
    close(poseAt(trimmed, atRest), trimmed);
  });
  test('surge and sway are along the nominal axes', () => close(poseAt(north, { ...atRest, surge: 3, sway: 2, heave: -1 }).slice(0, 3), [8, 23, -1]));
  test('yaw turns the bow to port, pitch lowers it, roll lowers starboard', () => {
    const turned = poseAt(east, { ...atRest, yaw: 0.1 });
    expect(turned[6]).toBeCloseTo(Math.sin(0.1)); // y of the forward axis
    expect(poseAt(east, { ...atRest, pitch: 0.1 })[9]).toBeCloseTo(-Math.sin(0.1)); // z of the forward axis
    expect(poseAt(east, { ...atRest, roll: 0.1 })[10]).toBeCloseTo(Math.sin(0.1)); // z of the port axis
  });
  test('objects on the vessel move with it, those on the seabed do not', () => {
    const scene = { vessel: { pose: east }, ramp: [{ name: 'r', place: [5, 0, 2], direction: [1, 0, 0], length: 3 }], stinger: [], stern_shoe: [-60, 0, 3], tensioner: null, objects: [{ name: 'o', points: [[1, 2, 3]] }] } as unknown as Scene;
    const moved = sceneAt(scene, poseAt(east, { ...atRest, surge: 2, yaw: Math.PI / 2 }));
    close(moved.ramp[0]!.place, [2, 5, 2]);
    close(moved.ramp[0]!.direction, [0, 1, 0]);
    close(moved.stern_shoe!, [2, -60, 3]);
    expect(moved.tensioner).toBeNull();
    expect(moved.objects).toBe(scene.objects);
    close(carried(north, north, [1, 2, 3]), [1, 2, 3]);
  });
});

const line = (part: Partial<MooringLine>): MooringLine => ({ name: 'a', fairlead_tension: 300e3, anchor_uplift: 0, utilisation: 0.1, anchor_utilisation: null, clearance: null, slack: false, parted: false, ...part }) as MooringLine;

describe('the table of lines', () => {
  const lines = [line({ name: 'a', fairlead_tension: 2 }), line({ name: 'b', fairlead_tension: 3 }), line({ name: 'c', parted: true }), line({ name: 'd', fairlead_tension: 1 })];
  const names = (order: SortOrder | null) => rowOrder(lineTable(lines, false), order).map((i) => lines[i]!.name);
  test('is sorted by a column, a parted line last', () => expect(names(nextOrder(null, 1))).toEqual(['b', 'a', 'd', 'c']));
  test('keeps the order of the model by default', () => expect(names(null)).toEqual(['a', 'b', 'c', 'd']));
  test('has values in engineering units, none for a parted line', () => {
    const { columns, rows, marks } = lineTable([line({ utilisation: 0.6 }), lines[2]!], false, ['fairlead_tension', 'utilisation']);
    expect(columns.map(titleWithUnit)).toEqual(['line', 'fairlead [kN]', 'of MBL [%]']);
    expect(rows.map((cells) => cells.map((cell, i) => cellText(cell, columns[i])))).toEqual([['a', '300.0', '60.0'], ['c', '-', '-']]);
    expect(marks).toEqual(['over', 'soft']);
  });
  test('has no column without information', () => expect(columnsFor(lines).map((c) => c.key)).not.toContain('clearance'));
  test('a line is checked for rope and anchor', () => {
    expect(lineLevel(line({}))).toBe('good');
    expect(lineLevel(line({ anchor_utilisation: 0.6 }))).toBe('near');  // 1.5 times that
    expect(lineLevel(line({ utilisation: 0.51 }))).toBe('over');  // static, with a factor of 2
    expect(lineLevel(line({ utilisation: 0.51 }), true)).toBe('good');  // dynamic, with 1.67
    expect(lineLevel(line({ utilisation: null }))).toBe('unknown');
    expect(lineLevel(line({ parted: true }))).toBe('gone');
  });
  test('lines of a run have its maximum tensions, the others the static ones', () => {
    const spread = (max: number) => ({ min: 0, max, mean: 0, std: 0, slow: { min: 0, max: 0, mean: 0, std: 0 }, wave: { min: 0, max: 0, mean: 0, std: 0 }, most_probable_min: null, most_probable_max: null });
    const [bow, stern] = largestOfRun([line({ name: 'bow', utilisation: 0.2 }), line({ name: 'stern', utilisation: 0.3 })], [{ name: 'bow', fairlead_tension: spread(700e3), anchor_tension: spread(600e3), utilisation: 0.5, parted_at: null, events: [] }]);
    expect([bow!.fairlead_tension, bow!.anchor_tension, bow!.utilisation]).toEqual([700e3, 600e3, 0.5]);
    expect(stern!.utilisation).toBe(0.3);
  });
  test('a deleted stage shows the equilibrium', () => {
    const m = { rest: { name: 'static' }, stages: [{ name: 'one' }] } as unknown as Moorings;
    expect(mooredStateAt(m, 0).name).toBe('one');
    expect(mooredStateAt(m, 3).name).toBe('static');
    expect(mooredStateAt(m, -1).name).toBe('static');
  });
});

describe('the plan', () => {
  test('holds all points, with a margin', () => {
    const box = around([[0, 0], [100, 10]]);
    expect(box.west).toBeLessThan(0);
    expect(box.east).toBeGreaterThan(100);
    expect(box.north - box.south).toBeGreaterThanOrEqual(35);
  });
  test('the bow is the point of the outline', () => expect(outline({ name: '', length: 100, beam: 20, height: 8, draught: 5, pose: north })[2]).toEqual([10, 70]));
  test('half way along a line is half way', () => expect(alongLine([[0, 0, 0], [10, 0, -5], [10, 30, -5]], 0.5)).toEqual([10, 10]));
  test('names stand outside the spread, and within the drawing', () => {
    expect(labelAt([300, 100], [1, 0.2], 60, 400)).toEqual([339, 104]);
    expect(labelAt([380, 100], [1, -0.2], 60, 400)).toEqual([368, 90]);
    expect(labelAt([10, 100], [-1, 0.2], 60, 400)).toEqual([32, 118]);
    expect(labelAt([200, 100], [0, -1], 60, 400)).toEqual([200, 90]);
  });
  test('the scale bar is a round length', () => { expect(scaleLength(2300)).toBe(500); expect(scaleLength(90)).toBe(20); });
  test('the ellipse of offsets has the axes of the covariance', () => {
    // on a straight line of slope 3/4: no second axis
    const s = scatter([-4, 0, 4], [-3, 0, 3]);
    const { a, b, turn } = ellipse(s, 2);
    expect(a).toBeCloseTo(2 * Math.sqrt((2 * 25) / 3));
    expect(b).toBeCloseTo(0);
    expect(turn).toBeCloseTo(Math.atan2(3, 4));
  });
});

describe('a mooring spread', () => {
  const request: SpreadRequest = { count: 8, angles: usualAngles(8), distance: '1000', kind: 'wire', diameter: '64 mm', tension: '300 kN', winch: true };
  test('angles are of one side and rise', () => {
    expect(parseAngles('25, 65 115;155', 8)).toEqual([25, 65, 115, 155]);
    expect(parseAngles('25, 65', 8)).toBeNull();
    expect(parseAngles('65, 25, 115, 155', 8)).toBeNull();
    for (const count of [4, 6, 8, 10, 12]) expect(usualAngles(count)).toHaveLength(count / 2);
  });
  test('names distinguish lines', () => {
    expect(lineNames([25, 65, 115, 155])).toEqual(['bow', 'forward breast', 'aft breast', 'stern']);
    expect(new Set(lineNames(usualAngles(12))).size).toBe(6);
  });
  test('is symmetric about the vessel', () => {
    const lines = spreadChanges(request, { length: 120, beam: 30, freeboard: 4 }).filter((c) => /lines\[/.test(c.path)).map((c) => c.value as { name: string; bearing: string; fairlead: { x: string; y: string }; anchor_distance: string });
    expect(lines).toHaveLength(8);
    const of = (name: string) => lines.find((l) => l.name === name)!;
    expect(of('port bow').bearing).toBe('335 deg');
    expect(of('starboard bow').bearing).toBe('25 deg');
    expect(of('port stern').fairlead).toMatchObject({ x: '-57 m', y: '15 m' });
    expect(of('starboard stern').fairlead).toMatchObject({ x: '-57 m', y: '-15 m' });
    expect(of('port bow').anchor_distance).toBe('1000 m');
  });
  test('present types and winches are unchanged', () => {
    const paths = spreadChanges(request, { length: 120, beam: 30, freeboard: 4 }, (path) => path === 'moorings.winches.main').map((c) => c.path);
    expect(paths).not.toContain('moorings.winches.main');
    expect(paths[0]).toBe('moorings.types.wire-64mm');
  });
  test('an invalid answer is reported at its field', () => {
    expect(findSpreadErrors(request, '25, 65, 115, 155')).toEqual([]);
    expect(findSpreadErrors({ ...request, tension: '-1 kN', diameter: 'thick' }, '25').map((f) => f.key)).toEqual(['angles', 'diameter', 'tension']);
  });
});

test('lists begin with a valid item, and continue with unique names', () => {
  expect(firstItem('operation.stages', 90)).toEqual({ name: 'stage 1' });
  expect(firstItem('pipe.coatings', 90)).toBeNull();
  expect([nextName('stage 1'), nextName('port bow'), nextName('ramp 9')]).toEqual(['stage 2', 'port bow 2', 'ramp 10']);
});

test('a model has the views of its contents', () => {
  const lay = (part: Partial<Lay>): Lay => ({ pipe: { s: [] }, moorings: null, lines: [], ...part }) as unknown as Lay;
  const held = (lines: number): Moorings => ({ rest: { moorings: Array(lines).fill({}) } }) as unknown as Moorings;
  expect(availableViews(lay({ moorings: held(8) }))).toEqual(['vessel', 'moorings']);
  expect(firstView(lay({ moorings: held(8) }))).toBe('moorings');
  expect(availableViews(lay({ moorings: held(0) }))).toEqual(['vessel']); // thrusters only
  expect(firstView(lay({ moorings: held(0) }))).toBe('vessel');
  expect(availableViews(lay({ lines: [{}] as Lay['lines'] }))).toEqual(['lines']);
  expect(shownViews(lay({ pipe: { s: [0] } as Lay['pipe'] }))).toHaveLength(6);
  expect(shownViews(null).at(-1)).toEqual(['from the pipe', '6']);
});
