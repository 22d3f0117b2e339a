// Painter, colour scale and placing of names, without a browser.
import { describe, expect, test } from 'vitest';
import { spreadNames } from '../src/components/EndNames';
import { aboveLimit, paperScale, readHex, viridis } from '../src/components/colourScale';
import { suspendedAndLaid, hullOutline, offsetInWorld, type MooringLineData, type MooringSpread } from '../src/components/mooringSpread';
import { Camera, Painter, fitInto, placeLabels, type Vector } from '../src/components/painter';

const luminance = (hex: string): number => readHex(hex).reduce((sum, v, k) => sum + v / 255 * [0.2126, 0.7152, 0.0722][k]!, 0);

describe('colour scale', () => {
  test('it starts dark, ends light and becomes brighter all the way', () => {
    const steps = Array.from({ length: 21 }, (_, k) => luminance(viridis(k / 20)));
    for (let k = 1; k < steps.length; ++k) expect(steps[k]!).toBeGreaterThan(steps[k - 1]!);
    expect(viridis(0)).toBe('#440154');
    expect(viridis(1)).toBe('#fde725');
  });

  test('on paper the largest value is the darkest', () => {
    expect(luminance(paperScale(1))).toBeLessThan(luminance(paperScale(0)));
    expect(paperScale(1.5)).toBe(paperScale(1));
  });

  test('the colour above a limit is not one of the scale', () => {
    const [r, g, b] = readHex(aboveLimit);
    for (let k = 0; k <= 20; ++k) {
      const [x, y, z] = readHex(paperScale(k / 20));
      expect(Math.hypot(r - x, g - y, b - z)).toBeGreaterThan(80);
    }
  });
});

describe('painter', () => {
  test('seen from astern, the port side is at the left and heights point upwards', () => {
    const camera = new Camera(0, 0);
    expect(camera.project([0, -1, 0])[0]).toBeCloseTo(-1);
    expect(camera.project([0, 0, 1])[1]).toBeCloseTo(-1);
    expect(camera.project([1, 0, 0])[2]).toBeCloseTo(1);
  });

  test('pieces are painted layer by layer, the nearest last', () => {
    const painter = new Painter(new Camera(0, 0));
    painter.addLine(1, [[0, 0, 0], [0, 1, 0]], { stroke: 'a' });
    painter.addLine(0, [[5, 0, 0], [5, 1, 0]], { stroke: 'b' });
    painter.addLine(0, [[2, 0, 0], [2, 1, 0]], { stroke: 'c' });
    expect(painter.sortedPieces().map((piece) => piece.look.stroke)).toEqual(['c', 'b', 'a']);
  });

  test('faces turned away from the eye are left out', () => {
    const painter = new Painter(new Camera(0, 0));
    const face: Vector[] = [[0, 0, 0], [0, 1, 0], [0, 1, 1]];
    painter.addShaded(0, face, [-1, 0, 0], '#ffffff');
    expect(painter.sortedPieces()).toHaveLength(0);
    painter.addShaded(0, face, [1, 0, 0], '#ffffff');
    expect(painter.sortedPieces()).toHaveLength(1);
  });

  test('the visible extent fills the room within the margins', () => {
    const place = fitInto([[0, 0, 0], [10, 2, 0]], 120, 100, { left: 10, right: 10, top: 20, bottom: 20 });
    expect(place([0, 0, 0])[0]).toBe(10);
    expect(place([10, 2, 0])[0]).toBe(110);
    expect(place([5, 1, 0])[1]).toBe(50);
  });

  test('a label that would cover another moves along its leader', () => {
    const label = { seen: [0, 0, 0] as Vector, text: 'box', dx: 0, dy: 20, anchor: 'middle' as const, movable: true };
    const placed = placeLabels([label, label], () => [50, 50], () => 30, 200);
    expect(placed.map((label) => label.dy)).toEqual([20, 37]);
    expect(placeLabels([label, label], () => [50, 50], () => 30, 90)).toHaveLength(1);
  });
});

describe('names at the ends of curves', () => {
  test('they are separated within the plot, in the order of their curves', () => {
    const rows = spreadNames([{ text: 'b', colour: '', y: 98 }, { text: 'a', colour: '', y: 96 }], 0, 100);
    expect(rows.map((row) => row.text)).toEqual(['a', 'b']);
    expect(rows[1]!.row).toBeLessThanOrEqual(100);
    expect(rows[1]!.row - rows[0]!.row).toBeGreaterThanOrEqual(15);
  });
});

describe('moored vessel', () => {
  const spread = { length: 100, beam: 30, heading: Math.PI / 2 } as MooringSpread;

  test('a vessel that heads east surges east and sways north', () => {
    expect(offsetInWorld(spread, 2, 0)[0]).toBeCloseTo(2);
    expect(offsetInWorld(spread, 0, 3)[1]).toBeCloseTo(3);
  });

  test('its bow is where it heads', () => {
    const outline = hullOutline(spread, { name: '', surge: 0, sway: 0, yaw: 0, lines: [] });
    expect(Math.max(...outline.map((p) => p[0]))).toBeCloseTo(50);
    expect(Math.max(...outline.map((p) => p[1]))).toBeCloseTo(15);
  });

  test('a line is laid from its touchdown on', () => {
    const shape: Vector[] = [[0, 0, 0], [50, 0, -20], [100, 0, -30], [150, 0, -30]];
    const line = { fairlead: [0, 0, 0], shape, touchdown: 100, on_bed: 50 } as unknown as MooringLineData;
    expect(suspendedAndLaid(line).map((part) => part.length)).toEqual([3, 2]);
    expect(suspendedAndLaid({ ...line, on_bed: 0 }).map((part) => part.length)).toEqual([4, 0]);
  });
});
