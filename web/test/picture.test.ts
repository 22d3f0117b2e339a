// The picture: separation of names, window of the elevation, coordinates, sections, the ruler, and events of a run.
import { describe, expect, test } from 'vitest';
import type { Column, Impact, Lay, Scene, Support } from '../src/api/types';
import { boxName, boxPath } from '../src/logic/boxes';
import { elevation } from '../src/logic/elevation';
import { eventsOfRun, findExtreme, nextEvent, objectOfColumn, tensionerEvents, wantedExtremes, worstImpact } from '../src/logic/events';
import { labelHeight, placeNames } from '../src/logic/labelPlaces';
import { liveChanges, readBase } from '../src/logic/live';
import { measure, withPoint } from '../src/logic/ruler';
import { boxSection, heaviestBox, pipeLayers } from '../src/logic/section';
import { inBoxFrame, shipAxes, toShip, toWorld } from '../src/logic/shipAxes';
import { exaggeration, fitWindow, scaleText, zoomWindow } from '../src/logic/sideFrame';
import { availableDrawings, shownDrawings } from '../src/logic/views';

describe('names', () => {
  const room = { x0: 0, y0: 0, x1: 400, y1: 300 };
  const rect = (p: { middle: number; top: number }, width: number) => ({ x0: p.middle - width / 2, x1: p.middle + width / 2, y0: p.top, y1: p.top + labelHeight });

  test('names do not cover each other, and each keeps its place below its leader', () => {
    const wanted = [0, 1, 2, 3].map((k) => ({ x: 100 + 12 * k, y: 150, width: 60, weight: k }));
    const placed = placeNames(wanted, room, []);
    expect(placed.length).toBeGreaterThan(2);
    for (const a of placed) {
      expect(Math.abs(a.middle - wanted[a.index]!.x)).toBeLessThanOrEqual(30);
      expect(a.top + labelHeight + a.leader).toBeCloseTo(150);
      for (const b of placed) {
        if (a === b) continue;
        const [p, q] = [rect(a, 60), rect(b, 60)];
        expect(p.x0 < q.x1 && p.x1 > q.x0 && p.y0 < q.y1 && p.y1 > q.y0).toBe(false);
      }
    }
  });

  test('the heavier name has the better place, and a name without room is left out', () => {
    const wanted = [{ x: 100, y: 150, width: 60, weight: 1 }, { x: 100, y: 150, width: 60, weight: 9 }];
    expect(placeNames(wanted, room, [])[0]).toMatchObject({ index: 1, middle: 100 });
    expect(placeNames([wanted[0]!], room, [{ x0: 0, y0: 0, x1: 400, y1: 140 }])).toHaveLength(0);
  });
});

describe('the window of the side view', () => {
  const plot = { width: 800, height: 400 }, seen = { x0: -60, x1: 440, z0: -90, z1: 10 };

  test('true to scale a metre is as long as it is high', () => {
    const w = fitWindow(seen, plot, true);
    expect(exaggeration(w, plot)).toBeCloseTo(1);
    expect(w.x0).toBeLessThan(seen.x0);
    expect(w.z0).toBeLessThan(seen.z0);
    expect(scaleText(exaggeration(w, plot))).toBe('true to scale');
  });

  test('exaggerated heights fill the room, and heights are never drawn smaller than lengths', () => {
    const factor = exaggeration(fitWindow(seen, plot, false), plot);
    expect(factor).toBeGreaterThan(1.5);
    expect(scaleText(factor)).toMatch(/^heights × \d/);
    expect(exaggeration(fitWindow({ x0: 0, x1: 10, z0: -500, z1: 0 }, plot, false), plot)).toBeCloseTo(1);
    expect(exaggeration(fitWindow({ x0: 0, x1: 5000, z0: -1, z1: 0 }, plot, false), plot)).toBeLessThanOrEqual(20.001);
  });

  test('the point under the pointer is fixed while zooming', () => {
    const w = zoomWindow(seen, 100, -20, 0.5);
    expect((100 - w.x0) / (w.x1 - w.x0)).toBeCloseTo((100 - seen.x0) / (seen.x1 - seen.x0));
    expect(w.x1 - w.x0).toBeCloseTo(250);
  });
});

/** Bow to the west, 10 m above the water at the stern shoe, with a box 5 m astern. */
const pose = [-40, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, 1];
const roller = (position: 'bottom' | 'port', x: number, y: number, z: number, axis: [number, number, number], reaction: number) =>
  ({ position, reaction, separation: reaction > 0 ? 0 : 0.02, axis, radius: 0.15, face: 0.6, center: [x, y, z] as [number, number, number] });
const box = (name: string, x: number, reaction: number): Support => ({
  name, place: [x, 0, 5], s: x, reaction, separation: 0, structure: 'stinger', contact: reaction > 0,
  rollers: [roller('bottom', x, 0, 5, [0, 1, 0], reaction), roller('port', x, -0.5, 5.3, [0, 0.5, 0.87], 0)],
});
const lay = {
  pipe: { s: [0, 10, 20], x: [0, 10, 20], y: [0, 0, 0], z: [5.35, 5.35, 5.35] }, supports: [box('first', 5, 2000), box('second', 12, 9000)],
  touchdown: { s: 20, place: [20, 0, 5] }, tensioner: { place: [0, 0, 5.35], direction: [1, 0, 0] }, moorings: null, lines: [],
} as unknown as Lay;
const scene = {
  vessel: { name: 'barge', length: 80, beam: 20, height: 10, draught: 5, pose }, stern_shoe: [0, 0, 4], ramp: [], stinger: [], water_depth: 50,
  seabed: { normal: [0, 0, 1], point: [0, 0, -50] }, pipe: { outer_radius: 0.2 },
} as unknown as Scene;

describe('ship axes', () => {
  test('count astern of the stern shoe and to port, and lead back to the world', () => {
    const axes = shipAxes(scene, lay);
    expect(toShip(axes, [7, -2, 3])).toEqual([7, 2, 3]);
    expect(toWorld(axes, [7, 2, 3])).toEqual([7, -2, 3]);
  });

  test('a move astern and up is the same in the frame of the boxes, and turned where the vessel is trimmed', () => {
    expect(inBoxFrame(pose, shipAxes(scene, lay), 1, 0.5)).toEqual({ x: 1, z: 0.5 });
    const trimmed = [...pose];
    [trimmed[3], trimmed[5], trimmed[9], trimmed[11]] = [-0.8, 0.6, 0.6, 0.8];
    const move = inBoxFrame(trimmed, shipAxes(scene, lay), 1, 0);
    expect(move.x).toBeCloseTo(0.8);
    expect(move.z).toBeCloseTo(0.6);
  });

  test('a box that is moved both ways changes both coordinates of the model', () => {
    const base = readBase([['x', 5], ['z', -1]].map(([key, si]) => ({ path: `supports.stinger.boxes[0].${key}`, kind: 'quantity', unit: 'm', si: Number(si), value: `${si} m`, given: true })));
    expect(liveChanges(base, { 'supports.stinger.boxes[0].x': 4.5, 'supports.stinger.boxes[0].z': -0.75 })).toEqual([
      { path: 'supports.stinger.boxes[0].x', value: '4.5 m' }, { path: 'supports.stinger.boxes[0].z', value: '-0.75 m' },
    ]);
  });
});

test('the side view has pipe, boxes and hull in ship axes, at rest and at a moment of a run', () => {
  const staticView = elevation(lay, scene, null, null, 0.32);
  expect(staticView.lay.stations.x).toEqual([0, 10, 20]);
  expect(staticView.lay.supports[0]!.p).toMatchObject({ 0: 5, 2: 5 });
  expect(staticView.lay.supports[1]!.rows[0]!.rollers[0]!.reaction).toBe(9000);
  expect(staticView.bed(100)).toBe(-50);
  const raised = [...pose];
  raised[2] = 1;
  const moment = { pose: raised, places: new Float32Array([0, 0, 6, 10, 0, 6, 20, 0, 6]), lines: null, reactions: new Map([['first', 70]]) };
  const moved = elevation(lay, scene, null, moment, null);
  expect(moved.lay.supports[0]!.p[2]).toBeCloseTo(6);
  expect(moved.lay.stations.z).toEqual([6, 6, 6]);
  expect(moved.lay.supports.map((b) => b.rows[0]!.rollers[0]!.reaction)).toEqual([70, 0]);
});

describe('sections', () => {
  test('a section is viewed from astern: port rollers on the left, the pipe above the bottom roller', () => {
    const [row] = boxSection(lay, scene, lay.supports[0]!);
    expect(row!.pipe[0]).toBeCloseTo(0);
    expect(row!.pipe[1]).toBeCloseTo(0.35);
    const port = row!.rollers.find((r) => r.position === 'port')!;
    expect(toShip(shipAxes(scene, lay), [5, -0.5, 5.3])[1]).toBeCloseTo(0.5); // to port
    expect(port.x).toBeCloseTo(-0.5);
    expect(port.y).toBeCloseTo(0.3);
  });

  test('the box with the largest reaction is shown first', () => expect(heaviestBox(lay)?.name).toBe('second'));

  test('layers of the pipe come from the model, and without it the pipe is one', () => {
    const fields: Record<string, { si: number; value?: string }> = {
      'pipe.steel.outside_diameter': { si: 0.4 }, 'pipe.steel.wall_thickness': { si: 0.01 }, 'pipe.coatings[0].thickness': { si: 0.05 }, 'pipe.coatings[0].name': { si: 0, value: 'concrete' },
    };
    const layers = pipeLayers((path) => fields[path], 0.25);
    expect(layers.map((l) => l.name)).toEqual(['bore', 'steel', 'concrete']);
    expect(layers[2]!.radius).toBeCloseTo(0.25);
    expect(pipeLayers(() => undefined, 0.25)).toEqual([expect.objectContaining({ name: 'pipe', radius: 0.25 })]);
  });
});

describe('the ruler', () => {
  const axes = shipAxes(scene, lay);
  test('measures along, across and up', () => {
    const m = measure(axes, [{ place: [0, 0, 0], flat: false }, { place: [3, -4, 12], flat: false }]);
    expect(m).toMatchObject({ distance: 13, astern: 3, port: 4, up: 12 });
    expect(measure(axes, [{ place: [0, 0, 0], flat: false }, { place: [3, 4, 0], flat: true }])).toMatchObject({ distance: 5, up: null });
  });
  test('a third click starts again', () => {
    const p = { place: [0, 0, 0] as [number, number, number], flat: false };
    expect([[], [p], [p, p]].map((points) => withPoint(points, p).length)).toEqual([1, 2, 1]);
  });
});

describe('selection', () => {
  const boxes = readBase([{ path: 'supports.stinger.boxes[0].x', si: 5 }, { path: 'supports.stinger.boxes[0].z', si: -1 }, { path: 'supports.stinger.boxes[0].name', si: null, value: 'first' }]).boxes;
  test('a box is found by its name in the results and by its path in the model', () => {
    expect(boxPath(boxes, lay.supports, 'first')).toBe('supports.stinger.boxes[0]');
    expect(boxName(boxes, lay.supports, 'supports.stinger.boxes[0]')).toBe('first');
    expect(boxName(boxes, lay.supports, 'supports.stinger')).toBeNull();
  });
  test('a box of a generated row is selected as its row', () => expect(boxPath([], lay.supports, 'second')).toBe('supports.stinger'));
});

test('drawings follow from what the model has', () => {
  const part = (of: Partial<Lay>): Lay => ({ pipe: { s: [] }, moorings: null, lines: [], supports: [], ...of }) as unknown as Lay;
  expect(availableDrawings(lay)).toEqual(['side', 'section', 'plan']);
  expect(availableDrawings(part({ lines: [{}] as Lay['lines'] }))).toEqual(['side', 'plan']);
  expect(availableDrawings(part({}))).toEqual([]);
  expect(shownDrawings(part({ lines: [{}] as Lay['lines'] }))).toEqual([['side', '2'], ['plan', '3']]);
});

describe('events of a run', () => {
  const impact = (time: number, peak_force: number): Impact => ({ support: `box ${time}`, row: 0, position: 'bottom', time, approach_velocity: 0.4, peak_force, duration: 0.1, impulse: 1, dent_depth: 0, line_load: 0 });
  const state = { t: [-1, 0, 1, 2, 3], min: [0, 0, 0, 2, 2], max: [0, 0, 0, 2, 2] };
  const events = eventsOfRun({
    impacts: [impact(5, 900), impact(1, 300)], state, findings: [],
    lines: [{ name: 'port bow', parted_at: 8, events: [{ time: 7, what: 'slack' }] } as never],
  });

  test('events of all kinds are in order of time', () => {
    expect(events.map((e) => [e.time, e.name])).toEqual([[1, 'impact on box 1'], [2, 'tensioner pays out'], [5, 'impact on box 5'], [7, 'port bow: slack'], [8, 'port bow: parted']]);
  });

  test('next and previous leave out the one that is shown', () => {
    expect(nextEvent(events, 1.03, 1)?.time).toBe(2);
    expect(nextEvent(events, 1.03, 1, 'impact')?.time).toBe(5);
    expect(nextEvent(events, 5.03, -1)?.time).toBe(2);
    expect(nextEvent(events, 9, 1)).toBeNull();
  });

  test('the worst impact is the hardest', () => expect(worstImpact([impact(1, 300), impact(5, 900)])?.time).toBe(5));

  test('a state before t = 0 is not an event', () => expect(tensionerEvents({ t: [-2, -1, 1], min: [0, 1, 1], max: [0, 1, 1] })).toEqual([]));

  test('extremes of a history are found from t = 0 on', () => {
    const series = { t: [-5, 0, 1, 2], min: [-90, 1, 3, -2], max: [90, 2, 7, 0] };
    expect(findExtreme(series, 1)).toEqual({ time: 1, value: 7 });
    expect(findExtreme(series, -1)).toEqual({ time: 2, value: -2 });
  });

  test('every history has its maximum in the menu, tensions also their minimum', () => {
    const columns = ['top_tension', 'support/stinger 8/reaction', 'tensioner/state'].map((name): Column => ({ name, unit: 'N', text: '' }));
    expect(wantedExtremes(columns).map((w) => [w.column.name, w.sign])).toEqual([['top_tension', 1], ['support/stinger 8/reaction', 1], ['top_tension', -1]]);
    expect(objectOfColumn('support/stinger 8/reaction')).toBe('stinger 8');
    expect(objectOfColumn('top_tension')).toBeNull();
  });
});
