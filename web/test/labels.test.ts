import { expect, test } from 'vitest';
import { wordStep } from '../src/components/HeatMap';
import { upright } from '../src/logic/labelRoom';

test('a name upright stands below the curves, else above them, else it is left out', () => {
  const plot = { top: 10, bottom: 110 };
  expect(upright(40, plot, null)).toBe('low');
  expect(upright(40, plot, [20, 60])).toBe('low');
  expect(upright(40, plot, [60, 105])).toBe('high');
  expect(upright(40, plot, [30, 90])).toBeNull();
  expect(upright(120, plot, null)).toBeNull();
});

test('names along an axis do not overlap', () => {
  expect(wordStep(['36', '38', '40'], 80, 10)).toBe(1);
  const names = ['trapezoid', 'minimum_jerk', 'zero_vibration', 'trapezoid'];
  expect(wordStep(names, 60, 10) * 60).toBeGreaterThan(5.6 * 'zero_vibration'.length);
});
