// Typesetting of the formulas of the calculation sheet.
import { expect, test } from 'vitest';
import { Formula } from '../src/components/CalculationSheet';
import { drawn } from './lightDom';

const html = (text: string): string => drawn(<Formula text={text} />).html;

test('Greek letters, indices and products are set as in print', () => {
  expect(html('alpha_fab f_y')).toBe('α<sub>fab</sub>\u202ff<sub>y</sub>');
  expect(html('2 pi')).toBe('2\u202fπ');
  expect(html('U = max(dp, 0)/p_c')).toBe('U = max(Δp, 0)/p<sub>c</sub>');
  expect(html('log10(x) (y)')).toBe('log(x)\u202f(y)');
});

test('powers are raised, those in brackets are in plain text', () => {
  expect(html('(D - t_2)^2')).toBe('(D − t<sub>2</sub>)<sup>2</sup>');
  expect(html('x^n_1')).toBe('x<sup>n<sub>1</sub></sup>');
  expect(html('x^(n + 1)')).toBe('x^(n + 1)');
});

test('a leading sign is set close, a binary one has space', () => {
  expect(html('-a + b')).toBe('−a + b');
  expect(html('a (-b)')).toBe('a\u202f(−b)');
  expect(html('a/b')).toBe('a/b');
});

test('a function is not a factor of its bracket', () => {
  expect(html('sigma_eq = sqrt(sigma_l^2 + 3 tau^2)')).toBe('σ<sub>eq</sub> = sqrt(σ<sub>l</sub><sup>2</sup> + 3\u202ftau<sup>2</sup>)');
});

test('markup characters remain text', () => {
  expect(drawn(<Formula text="a < b" />).text).toBe('a < b');
});
