// Request of a study, and its file: varied keys with their values, results to collect.
import type { Field } from '../api/types';
import { parseSeeds } from './runs';
import { complete, convertLike, parseQuantity, tidy } from './units';

/** Values are the list if given, otherwise `count` values from `from` to `to`. */
export interface AxisRequest { key: string; from: string; to: string; count: string; list: string }

/** `table`: a lay table; `each`: one key at a time from the values of the model. */
export type StudyKind = 'table' | 'study' | 'operability' | 'each';

export interface StudyRequest {
  analysis: 'static' | 'dynamic' | 'operation' | 'seek';
  axes: AxisRequest[];
  seeds: string;
  duration: string;
  /** Results by their names in summary.json. */
  gather: string;
  /** Operability: the key whose largest passing value is sought, and the resolution of the search. */
  over: string;
  resolution: string;
}

/** Model data for a study file: the unit of a key and its value as written. */
export interface ModelKeys { unit: (key: string) => string; value: (key: string) => string }

export const emptyAxis = (key = ''): AxisRequest => ({ key, from: '', to: '', count: '5', list: '' });

const scalar = (text: string): string => (/^[\w.+-]+( [\w.^*/%-]+)?$/.test(text) ? text : JSON.stringify(text));

/** A number without a unit gets the unit of its key. */
const withUnit = (text: string, unit: string): string => (unit && parseQuantity(text) ? complete(text, unit) : text.trim());

/** "200 kN..400 kN/21" in the list: 21 values, both ends included. */
const range = /^\s*(.+?)\s*(?:\.\.|–| to )\s*(.+?)\s*\/\s*(\d{1,5})\s*$/;

interface Ends { from: string; to: string; count: number }

function readEnds(axis: AxisRequest): Ends | null {
  const match = range.exec(axis.list);
  if (match) return { from: match[1]!, to: match[2]!, count: Number(match[3]) };
  return axis.list.trim() ? null : { from: axis.from, to: axis.to, count: Number(axis.count) };
}

const isRange = ({ from, to, count }: Ends): boolean =>
  Number.isInteger(count) && count >= 2 && count <= 100_000 && parseQuantity(from) !== null && parseQuantity(to) !== null;

const readList = (axis: AxisRequest): string[] => (range.test(axis.list) ? [] : axis.list.split(',').map((v) => v.trim()).filter(Boolean));

export function axisCount(axis: AxisRequest): number {
  const ends = readEnds(axis);
  return ends ? (isRange(ends) ? ends.count : 0) : readList(axis).length;
}

/** Values of an axis in the notation of the model; empty if they are invalid. */
export function axisValues(axis: AxisRequest, unit: string): string[] {
  const ends = readEnds(axis);
  if (!ends) return readList(axis).map((v) => withUnit(v, unit));
  if (!isRange(ends)) return [];
  const first = withUnit(ends.from, unit), quantity = parseQuantity(first)!;
  const last = parseQuantity(convertLike(withUnit(ends.to, unit), first))!;
  return Array.from({ length: ends.count }, (_, i) =>
    `${tidy(quantity.number + (last.number - quantity.number) * i / (ends.count - 1), 7)} ${quantity.unit}`.trim());
}

/** An axis in the notation of the study file; null if its values are invalid. */
export function axisYaml(axis: AxisRequest, unit: string): string | null {
  if (!axis.key) return null;
  const ends = readEnds(axis);
  if (ends) {
    if (!isRange(ends)) return null;
    return `{key: ${scalar(axis.key)}, from: ${scalar(withUnit(ends.from, unit))}, to: ${scalar(withUnit(ends.to, unit))}, steps: ${ends.count}}`;
  }
  const list = readList(axis);
  return list.length ? `{key: ${scalar(axis.key)}, values: [${list.map((v) => scalar(withUnit(v, unit))).join(', ')}]}` : null;
}

/** The case of the model first, then every key through its values while the others are constant. */
function eachAxesYaml(axes: AxisRequest[], model: ModelKeys): string[] {
  const valueLists = axes.map((a) => axisValues(a, model.unit(a.key)));
  return axes.map((axis, i) => {
    const base = model.value(axis.key);
    const values = [base, ...valueLists.flatMap((list, k) => list.map((value) => (k === i ? value : base)))];
    return `{key: ${scalar(axis.key)}, values: [${values.map(scalar).join(', ')}]${i ? `, with: ${scalar(axes[0]!.key)}` : ''}}`;
  });
}

const used = (request: StudyRequest): AxisRequest[] => request.axes.filter((a) => a.key || a.list.trim());

const readSeeds = (request: StudyRequest): number[] | null => (request.analysis === 'dynamic' && request.seeds.trim() ? parseSeeds(request.seeds) : null);

/** Number of cases; for operability the number of limits, each a search over its key. */
export function caseCount(kind: StudyKind, request: StudyRequest): number {
  const axes = used(request).filter((a) => a.key), seeds = readSeeds(request)?.length ?? 1;
  if (kind === 'each') return seeds * axes.reduce((n, a) => n + axisCount(a), 1);
  return axes.filter((a) => kind !== 'operability' || a.key !== request.over).reduce((n, a) => n * Math.max(axisCount(a), 1), kind === 'operability' ? 1 : seeds);
}

/** Reason why a study cannot be run as requested; null if it can. */
export function findStudyError(kind: StudyKind, request: StudyRequest, model: ModelKeys): string | null {
  const axes = used(request), dynamic = request.analysis === 'dynamic';
  if (axes.length === 0 && !(kind === 'study' && dynamic && request.seeds.trim())) return 'add a key to vary, and its values';
  const bad = axes.find((a) => axisYaml(a, model.unit(a.key)) === null);
  if (bad) return `${bad.key || 'a key'}: enter from, to and a count of at least 2, or a list such as "1 m, 1.5 m, 2 m"`;
  if (new Set(axes.map((a) => a.key)).size < axes.length) return 'each key can be used only once';
  if (dynamic && request.seeds.trim() && !parseSeeds(request.seeds)) return 'enter seeds such as "1-5" or "3, 7, 12"';
  if (kind === 'operability' && !axes.some((a) => a.key === request.over)) return 'select the key whose limit is sought';
  const lost = kind === 'each' ? axes.find((a) => !model.value(a.key)) : undefined;
  return lost ? `${lost.key} has no value in the model to start from` : null;
}

/** The whole study file. */
export function studyYaml(kind: StudyKind, request: StudyRequest, base: string, model: ModelKeys): string {
  const axes = request.axes.filter((a) => a.key), seeds = readSeeds(request);
  const lines = kind === 'each' ? eachAxesYaml(axes, model) : axes.map((a) => axisYaml(a, model.unit(a.key)) ?? '{}');
  const gather = request.gather.split(',').map((g) => g.trim()).filter(Boolean);
  const steps = request.resolution.trim() ? `, resolution: ${scalar(withUnit(request.resolution, model.unit(request.over)))}` : '';
  return [
    'overbend_study: 1', `base: ${scalar(base)}`, `analysis: ${request.analysis}`,
    ...(request.analysis === 'dynamic' && request.duration.trim() ? [`duration: ${request.duration.trim()}`] : []),
    ...(lines.length ? ['axes:', ...lines.map((line) => `  - ${line}`)] : []),
    ...(seeds ? [`seeds: [${seeds.join(', ')}]`] : []),
    ...(gather.length && kind !== 'operability' ? [`gather: [${gather.map(scalar).join(', ')}]`] : []),
    ...(kind === 'operability' ? [`operability: {over: ${scalar(request.over)}${steps}, criterion: checks}`] : []),
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

/** A key with round values about that of the model. */
export function firstAxis(field: Field | undefined, low = 0.8, high = 1.6, count = 9): AxisRequest {
  const number = field && parseQuantity(String(field.value ?? ''));
  if (!field || field.si === null || !number) return emptyAxis(field?.path);
  const unit = number.unit || field.unit, format = (value: number): string => `${tidy(value)} ${unit}`.trim();
  if (number.number <= 0) return { ...emptyAxis(field.path), from: format(number.number - 1), to: format(number.number + 1) };
  const [from, to] = roundRange(low * number.number, high * number.number, count);
  return { ...emptyAxis(field.path), from: format(from), to: format(to), count: String(count) };
}

/** A tenth below and above the value of the model. */
export function tenthAxis(field: Field | undefined): AxisRequest {
  const axis = firstAxis(field), number = field && parseQuantity(String(field.value ?? ''));
  if (!axis.from || !number || number.number <= 0) return axis.from ? { ...axis, count: '2' } : axis;
  const unit = number.unit || field!.unit, format = (part: number): string => `${tidy(part * number.number, 4)} ${unit}`.trim();
  return { ...axis, from: format(0.9), to: format(1.1), count: '2' };
}
