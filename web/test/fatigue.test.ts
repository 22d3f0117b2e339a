import { expect, test } from 'vitest';
import { waitText } from '../src/logic/fatigue';

test('a standby time is shown in a suitable unit', () => {
  expect(waitText(600)).toBe('10 min');
  expect(waitText(73.05 * 3600)).toBe('73.0 h');
  expect(waitText(30 * 86400)).toBe('30 days');
  expect(waitText(3.15576e9)).toBe('100 years');
});
