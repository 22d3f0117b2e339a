// What a study asks for, and its file: keys that change with their values, what is computed of every case.
import type { Field } from '../api/types';
import { parseSeeds } from './runs';
import { complete, inUnitOf, parseQuantity, tidy } from './units';

/** Values are the list where there is one, else `count` values from `from` to `to`. */
export interface AxisWish { key: string; from: string; to: string; count: string; list: string }

/** `table`: a lay table; `each`: one key at a time from the model's values. */
export type StudyKind = 'table' | 'study' | 'operability' | 'each';

export interface StudyWish {
  analysis: 'static' | 'dynamic' | 'operation' | 'seek';
  axes: AxisWish[];
  seeds: string;
  duration: string;
  /** Results by their names in summary.json. */
  gather: string;
  /** Of operability: the key whose largest value that passes is searched, and the steps of the search. */
  over: string;
  resolution: string;
}

/** What of the model a study file needs: the unit of a key and its value as written. */
export interface ModelKeys { unit: (key: string) => string; value: (key: string) => string }

export const emptyAxis = (key = ''): AxisWish => ({ key, from: '', to: '', count: '5', list: '' });

const scalar = (text: string): string => (/^[\w.+-]+( [\w.^*/%-]+)?$/.test(text) ? text : JSON.stringify(text));

/** A number without a unit gets the one that the key is written in. */
const withUnit = (text: string, unit: string): string => (unit && parseQuantity(text) ? complete(text, unit) : text.trim());

/** "200 kN..400 kN/21" in the list: 21 values, both ends included. */
const range = /^\s*(.+?)\s*(?:\.\.|–| to )\s*(.+?)\s*\/\s*(\d{1,5})\s*$/;

interface Ends { from: string; to: string; count: number }

function endsOf(axis: AxisWish): Ends | null {
  const match = range.exec(axis.list);
  if (match) return { from: match[1]!, to: match[2]!, count: Number(match[3]) };
  return axis.list.trim() ? null : { from: axis.from, to: axis.to, count: Number(axis.count) };
}

const isRange = ({ from, to, count }: Ends): boolean =>
  Number.isInteger(count) && count >= 2 && count <= 100_000 && parseQuantity(from) !== null && parseQuantity(to) !== null;

const listOf = (axis: AxisWish): string[] => (range.test(axis.list) ? [] : axis.list.split(',').map((v) => v.trim()).filter(Boolean));

export function axisCount(axis: AxisWish): number {
  const ends = endsOf(axis);
  return ends ? (isRange(ends) ? ends.count : 0) : listOf(axis).length;
}

/** Every value of an axis as it would stand in the model; empty where they say nothing. */
export function axisValues(axis: AxisWish, unit: string): string[] {
  const ends = endsOf(axis);
  if (!ends) return listOf(axis).map((v) => withUnit(v, unit));
  if (!isRange(ends)) return [];
  const first = withUnit(ends.from, unit), own = parseQuantity(first)!;
  const last = parseQuantity(inUnitOf(withUnit(ends.to, unit), first))!;
  return Array.from({ length: ends.count }, (_, i) =>
    `${tidy(own.number + (last.number - own.number) * i / (ends.count - 1), 7)} ${own.unit}`.trim());
}

/** An axis as the study file has it; null where its values say nothing. */
export function axisYaml(axis: AxisWish, unit: string): string | null {
  if (!axis.key) return null;
  const ends = endsOf(axis);
  if (ends) {
    if (!isRange(ends)) return null;
    return `{key: ${scalar(axis.key)}, from: ${scalar(withUnit(ends.from, unit))}, to: ${scalar(withUnit(ends.to, unit))}, steps: ${ends.count}}`;
  }
  const list = listOf(axis);
  return list.length ? `{key: ${scalar(axis.key)}, values: [${list.map((v) => scalar(withUnit(v, unit))).join(', ')}]}` : null;
}

/** The model's own case first, then every key through its values while the others keep theirs. */
function eachAxesYaml(axes: AxisWish[], model: ModelKeys): string[] {
  const own = axes.map((a) => axisValues(a, model.unit(a.key)));
  return axes.map((axis, i) => {
    const base = model.value(axis.key);
    const values = [base, ...own.flatMap((list, k) => list.map((value) => (k === i ? value : base)))];
    return `{key: ${scalar(axis.key)}, values: [${values.map(scalar).join(', ')}]${i ? `, with: ${scalar(axes[0]!.key)}` : ''}}`;
  });
}

const used = (wish: StudyWish): AxisWish[] => wish.axes.filter((a) => a.key || a.list.trim());

const seedsOf = (wish: StudyWish): number[] | null => (wish.analysis === 'dynamic' && wish.seeds.trim() ? parseSeeds(wish.seeds) : null);

/** Number of cases; of operability the number of limits, each a search over its key. */
export function caseCount(kind: StudyKind, wish: StudyWish): number {
  const axes = used(wish).filter((a) => a.key), seeds = seedsOf(wish)?.length ?? 1;
  if (kind === 'each') return seeds * axes.reduce((n, a) => n + axisCount(a), 1);
  return axes.filter((a) => kind !== 'operability' || a.key !== wish.over).reduce((n, a) => n * Math.max(axisCount(a), 1), kind === 'operability' ? 1 : seeds);
}

/** Why a study cannot be run as it is asked for; null where it can. */
export function studyFault(kind: StudyKind, wish: StudyWish, model: ModelKeys): string | null {
  const axes = used(wish), dynamic = wish.analysis === 'dynamic';
  if (axes.length === 0 && !(kind === 'study' && dynamic && wish.seeds.trim())) return 'add a key that changes, and its values';
  const bad = axes.find((a) => axisYaml(a, model.unit(a.key)) === null);
  if (bad) return `${bad.key || 'a key'}: from and to with a count from 2, or a list like "1 m, 1.5 m, 2 m"`;
  if (new Set(axes.map((a) => a.key)).size < axes.length) return 'each key once';
  if (dynamic && wish.seeds.trim() && !parseSeeds(wish.seeds)) return 'seeds like "1-5" or "3, 7, 12"';
  if (kind === 'operability' && !axes.some((a) => a.key === wish.over)) return 'choose the key whose largest value is searched';
  const lost = kind === 'each' ? axes.find((a) => !model.value(a.key)) : undefined;
  return lost ? `${lost.key} has no value in the model to start from` : null;
}

/** The whole study file. */
export function studyYaml(kind: StudyKind, wish: StudyWish, base: string, model: ModelKeys): string {
  const axes = wish.axes.filter((a) => a.key), seeds = seedsOf(wish);
  const lines = kind === 'each' ? eachAxesYaml(axes, model) : axes.map((a) => axisYaml(a, model.unit(a.key)) ?? '{}');
  const gather = wish.gather.split(',').map((g) => g.trim()).filter(Boolean);
  const steps = wish.resolution.trim() ? `, resolution: ${scalar(withUnit(wish.resolution, model.unit(wish.over)))}` : '';
  return [
    'overbend_study: 1', `base: ${scalar(base)}`, `analysis: ${wish.analysis}`,
    ...(wish.analysis === 'dynamic' && wish.duration.trim() ? [`duration: ${wish.duration.trim()}`] : []),
    ...(lines.length ? ['axes:', ...lines.map((line) => `  - ${line}`)] : []),
    ...(seeds ? [`seeds: [${seeds.join(', ')}]`] : []),
    ...(gather.length && kind !== 'operability' ? [`gather: [${gather.map(scalar).join(', ')}]`] : []),
    ...(kind === 'operability' ? [`operability: {over: ${scalar(wish.over)}${steps}, criterion: checks}`] : []),
    '',
  ].join('\n');
}

/** A round step of about this size: 1, 2, 2.5 or 5 times a power of ten. */
function roundStep(size: number): number {
  const power = 10 ** Math.floor(Math.log10(size));
  return [1, 2, 2.5, 5, 10].map((n) => n * power).reduce((a, b) => (Math.abs(b - size) < Math.abs(a - size) ? b : a));
}

/** `count` round values from about `low` to about `high`. */
export function roundRange(low: number, high: number, count: number): [number, number] {
  const step = roundStep((high - low) / (count - 1));
  const first = Math.max(step, Math.round(low / step) * step);
  return [Number(first.toPrecision(10)), Number((first + (count - 1) * step).toPrecision(10))];
}

/** A key with round values about the model's. */
export function firstAxis(field: Field | undefined, low = 0.8, high = 1.6, count = 9): AxisWish {
  const number = field && parseQuantity(String(field.value ?? ''));
  if (!field || field.si === null || !number) return emptyAxis(field?.path);
  const unit = number.unit || field.unit, words = (value: number): string => `${tidy(value)} ${unit}`.trim();
  if (number.number <= 0) return { ...emptyAxis(field.path), from: words(number.number - 1), to: words(number.number + 1) };
  const [from, to] = roundRange(low * number.number, high * number.number, count);
  return { ...emptyAxis(field.path), from: words(from), to: words(to), count: String(count) };
}

/** A tenth below and above the value of the model. */
export function tenthAxis(field: Field | undefined): AxisWish {
  const axis = firstAxis(field), number = field && parseQuantity(String(field.value ?? ''));
  if (!axis.from || !number || number.number <= 0) return axis.from ? { ...axis, count: '2' } : axis;
  const unit = number.unit || field!.unit, words = (part: number): string => `${tidy(part * number.number, 4)} ${unit}`.trim();
  return { ...axis, from: words(0.9), to: words(1.1), count: '2' };
}
