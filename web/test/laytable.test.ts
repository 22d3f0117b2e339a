// What a lay table asks for, and how its curves are laid out.
import { expect, test } from 'vitest';
import { bounds, rangeOf, usualRange, wishFault } from '../src/logic/laytable';

test('a range is asked for as the command line does', () => {
  expect(rangeOf({ vary: 'tension', from: ' 200 kN', to: '400 kN ', steps: '20' })).toBe('200 kN..400 kN/20');
});

test('the usual range lies around the lay that is shown', () => {
  expect(usualRange('tension', { top_tension: 250e3, lay_back: 330 }, 89)).toEqual({ vary: 'tension', from: '200 kN', to: '400 kN', steps: '16' });
  expect(usualRange('lay_back', { top_tension: 250e3, lay_back: 330 }, 89).to).toBe('396 m');
  expect(usualRange('depth', null, 89).from).toBe('71.2 m');
  expect(wishFault(usualRange('tension', null, null))).not.toBeNull();
});

test('what cannot be asked for is said before it is sent', () => {
  const good = { vary: 'tension', from: '200', to: '400 kN', steps: '20' } as const;
  expect(wishFault(good)).toBeNull();
  expect(wishFault({ ...good, to: '400' })).toMatch(/unit/);
  expect(wishFault({ ...good, steps: '0' })).toMatch(/steps/);
  expect(wishFault({ ...good, from: 'much' })).toMatch(/numbers/);
});

test('bounds hold the curves and the limit', () => {
  const panel = { title: '', limit: 1, series: [{ name: 'a', points: [[200, 0.4], [400, 0.8]] as [number, number][] }] };
  const { x, y } = bounds(panel);
  expect(x).toEqual([200, 400]);
  expect(y[1]).toBeGreaterThan(1);
  expect(y[0]).toBeGreaterThanOrEqual(0);
  expect(y[0]).toBeLessThan(0.4);
});
