// Goal seek on the page: keys that can vary, the request, and the answer as text.
import type { Field, Lay, Region } from '../api/types';
import { unitName } from './show';
import { complete, fromSi, parseQuantity, tidy, write } from './units';

/** A result that goal seek can set. */
export interface SeekTarget { name: string; result: string; unit: string; si: number }

export const quantityText = (si: number, unit: string, digits = 5): string => (unit ? write(si, unit, digits) : tidy(si, digits));

/** Maximum utilisation of the governing checks; null if there is none. */
export function worstUtilisation(lay: Pick<Lay, 'checks'>): number | null {
  const list = lay.checks.filter((check) => check.governing && check.utilisation !== undefined).map((check) => check.utilisation!);
  return list.length ? Math.max(...list) : null;
}

function regionGoals(name: string, region: Region | null): SeekTarget[] {
  if (!region || region.von_mises === 0) return [];
  return [
    { name: `von Mises stress in the ${name}`, result: `static.${name}.max_von_mises`, unit: unitName('Pa'), si: region.von_mises },
    { name: `bending stress in the ${name}`, result: `static.${name}.max_bending_stress`, unit: unitName('Pa'), si: region.bending_stress },
  ];
}

/** Results of a lay for goal seek, the utilisation first. */
export function seekGoals(lay: Pick<Lay, 'checks' | 'key' | 'supports'>): SeekTarget[] {
  const worst = worstUtilisation(lay), k = lay.key;
  const out: SeekTarget[] = worst === null ? [] : [{ name: 'largest utilisation', result: 'checks.worst.utilisation', unit: '', si: worst }];
  if (!k) return out;
  const add = (name: string, result: string, si: number | null | undefined, unit: string): void => { if (si !== null && si !== undefined) out.push({ name, result, unit: unitName(unit), si }); };
  add('top tension', 'static.top_tension', k.top_tension, 'N');
  add('bottom tension', 'static.bottom_tension', k.bottom_tension, 'N');
  add('lay-back', 'static.lay_back', k.lay_back, 'm');
  add('departure angle', 'static.departure_angle', k.departure_angle, 'rad');
  add('tip clearance', 'static.stinger_tip_clearance', k.stinger_tip_clearance, 'm');
  if (lay.supports.length) add('largest reaction', 'static.largest_reaction.value', k.largest_reaction, 'N');
  return [...out, ...regionGoals('overbend', k.overbend), ...regionGoals('tower', k.tower), ...regionGoals('sagbend', k.sagbend)];
}

export type Relation = 'equals' | 'at_most' | 'at_least';
export const relations: [Relation, string][] = [['equals', 'equal to'], ['at_most', 'at most'], ['at_least', 'at least']];

export interface SeekRequest { relation: Relation; value: string; key: string; from: string; to: string }

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

/** Numeric keys, the usual ones first, then in the order of the form; `wanted` is included even if it is omitted in the model. */
export function variableKeys(fields: Field[], wanted = ''): Field[] {
  const numbers = fields.filter((f) => (f.kind === 'quantity' || f.kind === 'number') && f.si !== null && !/^(analysis|checks|seek|report)\b/.test(f.path));
  const foremost = [wanted, ...usual];
  return [
    ...fields.filter((f) => f.path === wanted),
    ...usual.flatMap((path) => numbers.filter((f) => f.path === path && path !== wanted)),
    ...numbers.filter((f) => !foremost.includes(f.path) && f.given),
  ];
}

/** From half to one and a half times the present value; 1 m either way for coordinates. */
export function usualBounds(field: Field | undefined): { from: string; to: string } {
  const si = field?.si ?? null;
  if (!field || si === null) return { from: '', to: '' };
  const place = /\.(x|y|z|offset)$/.test(field.path);
  const [low, high] = place ? [si - 1, si + 1] : [Math.min(0.5 * si, 1.5 * si), Math.max(0.5 * si, 1.5 * si)];
  const format = (si: number): string => quantityText(si, field.unit);
  return { from: format(low), to: format(high) };
}

export const initialSeek = (target: SeekTarget, key: Field | undefined): SeekRequest => ({ relation: 'equals', value: quantityText(target.si, target.unit, 4), key: key?.path ?? '', ...usualBounds(key) });

export function findSeekErrors(request: SeekRequest): { key: string; text: string }[] {
  return (['value', 'from', 'to'] as const).filter((key) => !parseQuantity(request[key])).map((key) => ({ key, text: 'enter a number with its unit' }));
}

/** The key `seek` of a model. */
export function seekRequest(request: SeekRequest, target: SeekTarget, unit: string): unknown {
  return { vary: { key: request.key, from: complete(request.from, unit), to: complete(request.to, unit) }, until: { result: target.result, [request.relation]: complete(request.value, target.unit) } };
}

/** Remarks in addition to the answer. */
export function seekRemarks(found: SeekFound, target: SeekTarget, unit: string): string[] {
  const key = (si: number): string => quantityText(si, unit);
  const result = (si: number): string => quantityText(si, target.unit, 4);
  return [
    ...found.others.map((si) => `another solution: ${key(si)}`),
    ...found.jumps.map((jump) => `discontinuity at ${key(jump.at)}: from ${target.unit ? tidy(fromSi(jump.below, target.unit), 4) : result(jump.below)} to ${result(jump.above)}${jump.why ? `; ${jump.why}` : ''}`),
    ...found.remarks,
  ];
}
