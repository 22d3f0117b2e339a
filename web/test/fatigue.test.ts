import { expect, test } from 'vitest';
import { waitWords } from '../src/logic/fatigue';

test('a time to wait is told in the unit that fits', () => {
  expect(waitWords(600)).toBe('10 min');
  expect(waitWords(73.05 * 3600)).toBe('73.0 h');
  expect(waitWords(30 * 86400)).toBe('30 days');
  expect(waitWords(3.15576e9)).toBe('100 years');
});
