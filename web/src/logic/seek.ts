// Goal seek from the page: which keys can vary, what is asked, what the answer says.
import type { Field } from '../api/types';
import { complete, fromSi, parseQuantity, tidy, write } from './units';

/** A result of the page that is to be something else. */
export interface SeekTarget { name: string; result: string; unit: string; si: number }

export type Relation = 'equals' | 'at_most' | 'at_least';
export const relations: [Relation, string][] = [['equals', 'equal to'], ['at_most', 'at most'], ['at_least', 'at least']];

export interface SeekWish { relation: Relation; value: string; key: string; from: string; to: string }

export interface SeekFound {
  found: boolean; why: string | null; answer: number | null; unit: string; evaluations: number; slope: number | null;
  others: number[]; jumps: { at: number; below: number; above: number; why: string }[]; remarks: string[];
  keys: { key: string; before: number; answer: number | null }[];
  goals: { result: string; reached: number | null }[];
}

export interface SeekAnswer {
  status: 'found' | 'none' | 'invalid';
  seek?: SeekFound;
  changes?: { path: string; value: string }[];
  diagnostics?: { key: string; message: string }[];
}

const usual = ['tensioner.tension', 'environment.water_depth'];

/** Keys with a quantity or a number, the usual ones first, then as the form lists them. */
export function variableKeys(fields: Field[]): Field[] {
  const numbers = fields.filter((f) => (f.kind === 'quantity' || f.kind === 'number') && f.si !== null && !/^(analysis|checks|seek|report)\b/.test(f.path));
  return [...usual.flatMap((path) => numbers.filter((f) => f.path === path)), ...numbers.filter((f) => !usual.includes(f.path) && f.given)];
}

/** Half of the present value up to half as much again; 1 m either way of what is measured from an origin. */
export function usualBounds(field: Field | undefined): { from: string; to: string } {
  if (!field || field.si === null) return { from: '', to: '' };
  const place = /\.(x|y|z|offset)$/.test(field.path);
  const [low, high] = place ? [field.si - 1, field.si + 1] : [Math.min(0.5 * field.si, 1.5 * field.si), Math.max(0.5 * field.si, 1.5 * field.si)];
  const words = (si: number): string => (field.unit ? write(si, field.unit) : tidy(si));
  return { from: words(low), to: words(high) };
}

export const startWish = (target: SeekTarget, key: Field | undefined): SeekWish => ({ relation: 'equals', value: write(target.si, target.unit, 4), key: key?.path ?? '', ...usualBounds(key) });

export function seekFaults(wish: SeekWish): { key: string; text: string }[] {
  return (['value', 'from', 'to'] as const).filter((key) => !parseQuantity(wish[key])).map((key) => ({ key, text: 'a number with its unit' }));
}

/** The key `seek` of a model. */
export function seekRequest(wish: SeekWish, target: SeekTarget, unit: string): unknown {
  return { vary: { key: wish.key, from: complete(wish.from, unit), to: complete(wish.to, unit) }, until: { result: target.result, [wish.relation]: complete(wish.value, target.unit) } };
}

/** What there is to say besides the answer itself. */
export function seekRemarks(found: SeekFound, target: SeekTarget, unit: string): string[] {
  const key = (si: number): string => (unit ? write(si, unit) : tidy(si));
  return [
    ...found.others.map((other) => `another answer: ${key(other)}`),
    ...found.jumps.map((jump) => `a jump at ${key(jump.at)}: from ${tidy(fromSi(jump.below, target.unit), 4)} to ${write(jump.above, target.unit, 4)}${jump.why ? `; ${jump.why}` : ''}`),
    ...found.remarks,
  ];
}
