// A study from the page: its file, and how its cases are laid out in a chart.
import type { Field, Matrix, MatrixCase, VerdictKind } from '../api/types';
import { parseSeeds } from './runs';
import { complete, parseQuantity, tidy } from './units';

export interface AxisWish { key: string; values: string }
export interface StudyWish { analysis: 'static' | 'dynamic' | 'operation' | 'seek'; axes: AxisWish[]; seeds: string; duration: string; gather: string; limit: string }

/** "200 kN..400 kN/21": 21 values, both ends included. */
const range = /^\s*(.+?)\s*(?:\.\.|–| to )\s*(.+?)\s*\/\s*(\d{1,5})\s*$/;

const scalar = (text: string): string => (/^[\w.+-]+( [\w.^*/%-]+)?$/.test(text) ? text : JSON.stringify(text));

/** A number without a unit gets the one that the key is written in. */
const withUnit = (text: string, unit: string): string => (unit && parseQuantity(text) ? complete(text, unit) : text);

/** An axis as the study file has it; null where its values say nothing. */
export function axisYaml(axis: AxisWish, unit: string): string | null {
  const match = range.exec(axis.values);
  if (match) {
    const steps = Number(match[3]);
    if (steps < 2 || !parseQuantity(match[1]!) || !parseQuantity(match[2]!)) return null;
    return `{key: ${scalar(axis.key)}, from: ${scalar(withUnit(match[1]!, unit))}, to: ${scalar(withUnit(match[2]!, unit))}, steps: ${steps}}`;
  }
  const list = axis.values.split(',').map((v) => v.trim()).filter(Boolean);
  return axis.key && list.length ? `{key: ${scalar(axis.key)}, values: [${list.map((v) => scalar(withUnit(v, unit))).join(', ')}]}` : null;
}

export function axisCount(axis: AxisWish): number {
  const match = range.exec(axis.values);
  return match ? Number(match[3]) : axis.values.split(',').filter((v) => v.trim()).length;
}

/** Number of cases; of an operability chart of its combinations, each a search over the axis. */
export function caseCount(wish: StudyWish): number {
  const seeds = wish.analysis === 'dynamic' && wish.seeds.trim() ? parseSeeds(wish.seeds)?.length ?? 1 : 1;
  return wish.axes.filter((a) => a.key && a.key !== wish.limit).reduce((n, a) => n * Math.max(axisCount(a), 1), wish.limit ? 1 : seeds);
}

export function studyFault(wish: StudyWish, unitOf: (key: string) => string): string | null {
  const used = wish.axes.filter((a) => a.key || a.values.trim());
  if (used.length === 0 && !(wish.analysis === 'dynamic' && wish.seeds.trim())) return 'choose a key that changes, and its values';
  const bad = used.find((a) => axisYaml(a, unitOf(a.key)) === null);
  if (bad) return `${bad.key || 'a key'}: values like "1 m, 1.5 m, 2 m", or a range like "200 kN..400 kN/21"`;
  if (new Set(used.map((a) => a.key)).size < used.length) return 'each key once';
  if (wish.analysis === 'dynamic' && wish.seeds.trim() && !parseSeeds(wish.seeds)) return 'seeds like "1-5" or "3, 7, 12"';
  return wish.limit && !used.some((a) => a.key === wish.limit) ? `${wish.limit} is not one of the keys` : null;
}

/** The whole study file. */
export function studyYaml(wish: StudyWish, base: string, unitOf: (key: string) => string): string {
  const seeds = wish.analysis === 'dynamic' && wish.seeds.trim() ? parseSeeds(wish.seeds) : null;
  const gather = wish.gather.split(',').map((g) => g.trim()).filter(Boolean);
  return [
    'overbend_study: 1', `base: ${scalar(base)}`, `analysis: ${wish.analysis}`,
    ...(wish.analysis === 'dynamic' && wish.duration.trim() ? [`duration: ${wish.duration.trim()}`] : []),
    ...(wish.axes.some((a) => a.key) ? ['axes:', ...wish.axes.filter((a) => a.key).map((a) => `  - ${axisYaml(a, unitOf(a.key)) ?? '{}'}`)] : []),
    ...(seeds ? [`seeds: [${seeds.join(', ')}]`] : []),
    ...(gather.length ? [`gather: [${gather.map(scalar).join(', ')}]`] : []),
    ...(wish.limit ? [`operability: {over: ${scalar(wish.limit)}, criterion: checks}`] : []),
    '',
  ].join('\n');
}

/** A key that is often varied, with values about the model's. */
export function firstAxis(field: Field | undefined): AxisWish {
  if (!field || field.si === null) return { key: '', values: '' };
  const [number, unit] = [parseQuantity(String(field.value)), field.unit];
  if (!number) return { key: field.path, values: '' };
  const words = (factor: number): string => `${tidy(number.number * factor, 3)} ${number.unit || unit}`.trim();
  return { key: field.path, values: `${words(0.8)}..${words(1.6)}/17` };
}

/** Axes along which the cases spread: crossed, with more than one value. */
export const spreadAxes = (m: Matrix): number[] => m.inputs.flatMap((input, i) => (!input.sampled && !input.with && input.words.length > 1 ? [i] : []));

/** Of the seeds of one combination the value that is farther out: the smallest of a minimum, else the largest. */
export function worstValue(cases: MatrixCase[], output: number, name: string): number | null {
  const values = cases.map((c) => c.values[output]).filter((v): v is number => v !== null && v !== undefined);
  if (values.length === 0) return null;
  return /(^|[._])(min|smallest|least)/.test(name) ? Math.min(...values) : Math.max(...values);
}

export interface Cell { cases: MatrixCase[]; value: number | null; state: VerdictKind | 'failed' | 'open' }

const severity: Record<VerdictKind, number> = { passed: 0, reserved: 1, 'not judged': 2, exceeded: 3 };

const worstVerdict = (cases: MatrixCase[]): VerdictKind => cases.map((c) => c.verdict).reduce((a, b) => (severity[a] >= severity[b] ? a : b));

export function cellOf(cases: MatrixCase[], output: number, name: string): Cell {
  const state = cases.some((c) => c.state === 'failed') ? 'failed' : cases.length === 0 || cases.some((c) => c.state === 'open') ? 'open' : worstVerdict(cases);
  return { cases, value: worstValue(cases, output, name), state };
}

/** Cells over one or two axes (rows from the second), the other axes held at `fixed`. */
export function cellsOver(m: Matrix, axes: number[], fixed: Record<number, number>, output: number): Cell[][] {
  const [x, y] = axes, name = m.outputs[output]?.name ?? '';
  const rest = spreadAxes(m).filter((a) => !axes.includes(a));
  const rows = y === undefined ? 1 : m.inputs[y]!.words.length;
  const columns = x === undefined ? 1 : m.inputs[x]!.words.length;
  const held = m.cases.filter((c) => rest.every((a) => c.at[a] === (fixed[a] ?? 0)));
  return Array.from({ length: rows }, (_r, j) => Array.from({ length: columns }, (_c, i) =>
    cellOf(held.filter((c) => (x === undefined || c.at[x] === i) && (y === undefined || c.at[y] === j)), output, name)));
}

const verdictWords: Record<VerdictKind, string> = { passed: 'pass', reserved: 'pass with reservations', exceeded: 'exceed a check', 'not judged': 'solved, not judged' };

/** Counts in words. */
export function tally(m: Matrix): string {
  const n = (test: (c: MatrixCase) => boolean): number => m.cases.filter(test).length;
  const parts: [number, string][] = [
    ...(['passed', 'reserved', 'exceeded', 'not judged'] as const).map((kind): [number, string] => [n((c) => c.state === 'done' && c.verdict === kind), verdictWords[kind]]),
    [n((c) => c.state === 'failed'), 'have no solution'], [n((c) => c.state === 'open'), 'still to come']];
  return `${m.cases.length} cases: ${parts.filter(([count]) => count).map(([count, words]) => `${count} ${words}`).join(', ')}`;
}
