import { describe, expect, it } from 'vitest';
import { layoutChart } from '../src/components/chart/frame';
import { LabelRoom, visibleNames } from '../src/components/chart/labels';
import { runs } from '../src/components/chart/marks';
import { extent, interpolate, linearScale, lowerBound, ticks, tickTexts, widened, withRoom } from '../src/components/chart/scale';
import type { ChartProps } from '../src/components/chart/types';
import { unitsFromTable } from '../src/components/units';

const units = unitsFromTable({ N: { name: 'kN', factor: 1e-3, more: 0 }, m: { name: 'ft', factor: 3.28084, more: 0 } });

describe('scales', () => {
  it('map both ends of their values to both ends in pixels and back', () => {
    const scale = linearScale([10, 20], [300, 100]);
    expect([scale(10), scale(20), scale(15)]).toEqual([300, 100, 200]);
    expect(scale.invert(250)).toBeCloseTo(12.5);
  });

  it('have ticks at multiples of 1, 2 or 5 times a power of ten', () => {
    expect(ticks(0, 100, 10)).toEqual([0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100]);
    expect(ticks(-0.31, 0.42, 5)).toEqual([-0.2, 0, 0.2, 0.4]);
    expect(ticks(0.1, 0.3, 2)).toEqual([0.1, 0.2, 0.3]);
    expect(ticks(3, 3, 5)).toEqual([3]);
  });

  it('write ticks with the decimals that distinguish them, and no minus zero', () => {
    expect(tickTexts([-0.5, 0, 0.5])).toEqual(['\u22120.5', '0.0', '0.5']);
    expect(tickTexts(ticks(-1e-6, 1e-6, 2))).toContain('0.000000');
    expect(tickTexts([100000, 200000])).toEqual(['100000', '200000']);
  });
});

describe('ranges', () => {
  it('omit values that are not numbers', () => {
    expect(extent([3, null, Number.NaN, 1, undefined])).toEqual([1, 3]);
    expect(extent([])).toEqual([0, 0]);
  });

  it('have room where all values are the same', () => {
    expect(withRoom([5, 5], 0.1)).toEqual([4.5, 5.5]);
    expect(withRoom([0, 0], 0.1)).toEqual([-0.1, 0.1]);
  });

  it('are widened to a hundredth of the values, so that noise does not fill the figure', () => {
    expect(widened([500, 500.1], 0.1)).toEqual([500.05 - 2.5005, 500.05 + 2.5005]);
    expect(widened([100, 900], 0.1)).toEqual([100, 900]);
  });

  it('are widened to ten of the last decimal shown, upwards from zero', () => {
    expect(widened([0, 1e-9], 0.001)).toEqual([0, 0.01]);
    expect(widened([-1e-9, 1e-9], 0.001)).toEqual([-0.005, 0.005]);
  });

  it('are interpolated between the points of a column', () => {
    expect(lowerBound([0, 1, 2], 1)).toBe(1);
    expect(interpolate([0, 1, 2], [0, 10, 40], 1.5)).toBe(25);
    expect(interpolate([0, 1, 2], [0, 10, 40], 9)).toBe(40);
  });
});

describe('labels', () => {
  const plot = { x0: 0, x1: 400, y0: 0, y1: 200 };

  it('are directly above their point if it is free', () => {
    expect(new LabelRoom(plot).place([100, 100], 60)).toEqual([108, 90]);
  });

  it('keep clear of curves, of each other and of the edges', () => {
    const room = new LabelRoom(plot);
    room.takeCurve([[0, 90], [400, 90]]);
    const [, below] = room.place([100, 100], 60);
    expect(below).toBeGreaterThan(100);
    const second = room.place([100, 100], 60);
    expect(second).not.toEqual([108, below]);
    expect(room.place([395, 150], 60)[0]).toBeLessThan(340);
  });

  it('stay inside if all positions are occupied', () => {
    const room = new LabelRoom(plot);
    room.take(plot);
    const [x, y] = room.place([390, 5], 60);
    expect(x + 60).toBeLessThanOrEqual(400);
    expect(y).toBeGreaterThan(0);
  });

  it('of vertical lines move to the other side or down where a curve runs', () => {
    const room = new LabelRoom(plot);
    expect(room.placeUpright(200, 66)).toEqual([195, 72]);
    expect(room.placeUpright(200, 66)).toEqual([216, 72]);
    room.takeCurve([[100, 20], [300, 20]]);
    expect(room.placeUpright(200, 66)[1]).toBeGreaterThan(72);
  });

  it('that are slanted omit names that would cover the previous one', () => {
    const names = [0, 5, 30, 31, 60].map((x) => ({ x }));
    expect(visibleNames(names, 50, 12).map(({ x }) => x)).toEqual([0, 30, 60]);
  });
});

describe('charts', () => {
  const usual: ChartProps = { title: 'Chart', x: { range: [0, 10], label: 'x' }, y: { range: [0, 5], label: 'y' } };
  const layout = (props: Partial<ChartProps>) => layoutChart({ ...usual, ...props }, units);

  it('split curves where a value is missing', () => {
    expect(runs([1, null, 2, 3, null], (value) => value === null)).toEqual([[1], [2, 3]]);
  });

  it('show SI values in their units', () => {
    const { yTicks, frame } = layout({ y: { range: [0, 5000], si: 'N', label: 'Force' } });
    const last = yTicks.at(-1)!;
    expect(last.text).toBe('5');
    expect(last.pixel).toBeCloseTo(frame.y(5000));
  });

  it('have the same scale both ways where they are equal, at most as high as given', () => {
    const low = layout({ equal: true, x: { range: [0, 100] }, y: { range: [0, 20] } }).frame;
    expect(low.x(1) - low.x(0)).toBeCloseTo(low.y(0) - low.y(1));
    const high = layout({ equal: true, x: { range: [0, 10] }, y: { range: [0, 20] }, maxHeight: 400 }).frame;
    expect(high.bottom - high.top).toBeCloseTo(400);
    expect(high.x(1) - high.x(0)).toBeCloseTo(high.y(0) - high.y(1));
    expect(0.5 * (high.x.domain[0] + high.x.domain[1])).toBeCloseTo(5);
  });

  it('set the legend next to the title, and in rows below it if it is long', () => {
    const entry = (text: string) => ({ text, colour: '#000' });
    const [legend] = layout({ legend: [entry('one'), entry('two')] }).legends;
    expect(legend!.entries.map(({ y }) => y)).toEqual([20, 20]);
    const long = Array.from({ length: 8 }, (_, i) => entry(`a rather long name ${i}`));
    const { legends, frame } = layout({ legend: long });
    const rows = [...new Set(legends[0]!.entries.map(({ y }) => y))];
    expect(rows.length).toBeGreaterThan(1);
    expect(rows[0]).toBe(42);
    expect(frame.top).toBeGreaterThan(Math.max(...rows));
    for (const placed of legends[0]!.entries) expect(placed.right - placed.textWidth - 34).toBeGreaterThanOrEqual(frame.left);
  });

  it('have no row for a legend without entries, however long the title is', () => {
    expect(layout({ title: 'long '.repeat(60), legend: [] }).frame.top).toBe(34);
  });

  it('set names of the x axis slanted if they do not fit side by side', () => {
    const names = (count: number) => Array.from({ length: count }, (_, i) => ({ value: 10 * i / count, text: `stinger ${i}` }));
    expect(layout({ x: { range: [0, 10], names: names(4) } }).names.level).toBe(true);
    const { names: look, frame } = layout({ x: { range: [0, 10], names: names(40) } });
    expect(look.level).toBe(false);
    expect(frame.height - frame.bottom).toBeGreaterThan(50);
  });

  it('make room for long numbers and names left of the y axis', () => {
    const { frame } = layout({ y: { range: [0, 3], names: [{ value: 1, text: 'a key of a model file with a long name' }] } });
    expect(frame.left).toBeGreaterThan(200);
  });
});
