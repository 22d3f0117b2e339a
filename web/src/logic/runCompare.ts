// Comparison of runs: differing keys of their models, results with differences, histories and envelopes in one diagram.
import type { ChartData, Line } from '../charts/data';
import type { DynamicSummary, Envelopes, Field, RunSummary, Series, Spread } from '../api/types';
import type { TableData } from '../components/document';
import { display, quantity, unitName } from './show';

/** Distinct for all kinds of colour vision, on light and dark background. */
export const runColours = ['#0b7bd0', '#d9730d', '#2a9d72', '#b565c9'] as const;
export const maxCompared = runColours.length;

export interface KeyDifference { path: string; values: (string | null)[] }
type Keys = readonly Pick<Field, 'path' | 'kind' | 'value' | 'si' | 'given'>[];

/** Two notations of one quantity are not a difference. */
const same = (a: Keys[number] | undefined, b: Keys[number] | undefined): boolean => {
  if (!a || !b) return a === b;
  return a.si !== null && b.si !== null ? Math.abs(a.si - b.si) <= 1e-9 * Math.max(Math.abs(a.si), Math.abs(b.si)) : String(a.value) === String(b.value);
};

/** Keys whose values differ between the models, in the order of the first model; null if a model omits the key. */
export function modelDifferences(models: readonly Keys[]): KeyDifference[] {
  const given = models.map((fields) => new Map(fields.filter((f) => f.given && f.value !== null && f.value !== undefined && f.path !== 'title').map((f) => [f.path, f])));
  const paths = [...new Set(given.flatMap((fields) => [...fields.keys()]))];
  return paths.filter((path) => given.some((fields) => !same(fields.get(path), given[0]!.get(path))))
    .map((path) => ({ path, values: given.map((fields) => { const f = fields.get(path); return f ? String(f.value) : null; }) }));
}

export interface ResultRow { name: string; unit: string; values: (number | null)[] }

type Static = { [key: string]: unknown };
const number = (value: unknown): number | null => (typeof value === 'number' && Number.isFinite(value) ? value : null);
const inside = (of: unknown, ...path: string[]): number | null => number(path.reduce<unknown>((value, name) => (value as Static | null | undefined)?.[name], of));

const statics: [string, string, string[]][] = [
  ['top tension', 'N', ['top_tension']], ['bottom tension', 'N', ['bottom_tension']], ['lay-back', 'm', ['lay_back']], ['departure angle', 'rad', ['departure_angle']],
  ['tip clearance', 'm', ['stinger_tip_clearance']], ['overbend von Mises', 'Pa', ['overbend', 'max_von_mises']], ['overbend strain', '%', ['overbend', 'max_strain']],
  ['sagbend von Mises', 'Pa', ['sagbend', 'max_von_mises']], ['sagbend strain', '%', ['sagbend', 'max_strain']], ['largest reaction', 'N', ['largest_reaction', 'value']],
];

const spread = (of: Spread | null | undefined, part: keyof Spread): number | null => number(of?.[part]);

const dynamics: [string, string, (d: DynamicSummary) => number | null][] = [
  ['top tension, max', 'N', (d) => spread(d.top_tension, 'max')], ['top tension, min', 'N', (d) => spread(d.top_tension, 'min')], ['bottom tension, min', 'N', (d) => spread(d.bottom_tension, 'min')],
  ['overbend von Mises, max', 'Pa', (d) => spread(d.overbend?.max_von_mises, 'max')], ['overbend strain, max', '%', (d) => spread(d.overbend?.max_strain, 'max')],
  ['sagbend von Mises, max', 'Pa', (d) => spread(d.sagbend?.max_von_mises, 'max')], ['sagbend strain, max', '%', (d) => spread(d.sagbend?.max_strain, 'max')],
  ['tip clearance, min', 'm', (d) => spread(d.stinger_tip_clearance, 'min')], ['box reaction, max', 'N', (d) => (d.supports?.length ? Math.max(...d.supports.map((box) => box.reaction.max)) : null)],
  ['impacts', '', (d) => number(d.impact_count)],
];

export type ComparedSummary = RunSummary & { static?: Static; checks?: { worst?: { utilisation?: number } | null } };

/** Results that at least one of the runs has. */
export function resultRows(summaries: readonly (ComparedSummary | null)[]): ResultRow[] {
  const rows: ResultRow[] = [
    { name: 'utilisation', unit: '', values: summaries.map((s) => inside(s?.dynamic ?? s, 'checks', 'worst', 'utilisation')) },
    ...statics.map(([name, unit, path]) => ({ name: `static ${name}`, unit, values: summaries.map((s) => inside(s?.static, ...path)) })),
    ...dynamics.map(([name, unit, value]) => ({ name, unit, values: summaries.map((s) => (s?.dynamic ? value(s.dynamic) : null)) })),
  ];
  return rows.filter((row) => row.values.some((value) => value !== null));
}

/** Relative to the first run; null if that is not meaningful. */
export function change(first: number | null, value: number | null): number | null {
  return first === null || value === null || Math.abs(first) < 1e-12 ? null : (100 * (value - first)) / Math.abs(first);
}

export const shownFactor = (unit: string): number => (unit === '%' ? 100 : unit === '' ? 1 : display(unit)[1]);
export const shownUnitName = (unit: string): string => (unit === '%' || unit === '' ? unit : unitName(unit));

export function differenceTable(names: readonly string[], keys: readonly KeyDifference[]): TableData {
  return { title: 'Differences in the model', look: 'dense', columns: [{ title: 'key', words: true }, ...names.map((title) => ({ title, words: true }))], rows: keys.map((k) => [k.path, ...k.values.map((v) => v ?? 'not given')]) };
}

export function resultTable(names: readonly string[], rows: readonly ResultRow[]): TableData {
  const columns = names.flatMap((title, i) => [{ title, digits: 3 }, ...(i ? [{ title: `${title}: difference`, unit: '%', digits: 2 }] : [])]);
  return {
    title: 'Results', look: 'dense', columns: [{ title: 'result', words: true }, { title: 'unit', words: true }, ...columns],
    rows: rows.map(({ name, unit, values }) => [name, shownUnitName(unit), ...values.flatMap((v, i) => [v === null ? null : v * shownFactor(unit), ...(i ? [change(values[0]!, v)] : [])])]),
  };
}

/** Values at other positions, interpolated linearly; null outside the range. */
function valuesAt(places: readonly number[], x: readonly number[], y: readonly number[]): (number | null)[] {
  let k = 0;
  return places.map((place) => {
    if (x.length === 0 || place < x[0]! - 1e-9 || place > x.at(-1)! + 1e-9) return null;
    while (k < x.length - 2 && x[k + 1]! < place) ++k;
    const x0 = x[k]!, x1 = x[k + 1] ?? x0, y0 = y[k]!, y1 = y[k + 1] ?? y0;
    return x1 > x0 ? y0 + ((y1 - y0) * Math.min(1, Math.max(0, (place - x0) / (x1 - x0)))) : y0;
  });
}

const union = (lists: readonly (readonly number[])[]): number[] => [...new Set(lists.flat())].sort((a, b) => a - b);

export interface Compared<T> { name: string; colour: string; data: T | null }

/** Maximum and minimum as one line each, or as a single line if they coincide. */
function pair(name: string, colour: string, x: readonly number[], from: readonly number[], low: readonly number[], high: readonly number[], factor: number): Line[] {
  const scaled = (values: readonly number[]): (number | null)[] => valuesAt(x, from, values).map((v) => (v === null ? null : v * factor));
  const top: Line = { name, colour, values: scaled(high), width: 1.4 };
  return low.every((v, i) => v === high[i]) ? [top] : [top, { name: `${name}, min`, colour, values: scaled(low), width: 1.4, dash: true }];
}

export function historyChart(title: string, unit: string, runs: readonly Compared<Series>[]): ChartData {
  const [name, factor] = display(unit), known = runs.filter((run) => run.data?.t.length), x = union(known.map((run) => run.data!.t));
  const lines = known.flatMap(({ name: run, colour, data }) => pair(run, colour, x, data!.t, data!.min, data!.max, factor).map((line) => ({ ...line, dash: false })));
  return { title, xName: 'time [s]', yName: `${title.toLowerCase()} [${name}]`, x, s: x, lines, marks: [], level: [] };
}

export type EnvelopeKey = 'effective_tension' | 'bending_moment' | 'bending_stress' | 'von_mises' | 'strain';
export const envelopeKeys: readonly EnvelopeKey[] = ['von_mises', 'bending_stress', 'effective_tension', 'strain', 'bending_moment'];

/** Maximum and minimum over time for a dynamic run, the state for a static run. */
export function envelopeChart(key: EnvelopeKey, runs: readonly Compared<Envelopes>[]): ChartData {
  const q = quantity(key)!, [metre, m] = display('m'), known = runs.filter((run) => run.data?.s.length), x = union(known.map((run) => run.data!.s));
  const lines = known.flatMap(({ name, colour, data }) => { const band = data![key]; return pair(name, colour, x, data!.s, band.min ?? band.static, band.max ?? band.static, q.factor); });
  return { title: q.name, xName: `arc length from the tensioner [${metre}]`, yName: `${q.name.toLowerCase().replace('von mises', 'von Mises')} [${q.unit}]`, x: x.map((v) => v * m), s: x, lines, marks: [], level: [] };
}
