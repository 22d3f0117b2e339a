// Results of a study: layout of its cases in tables and drawings.
import type { Matrix, MatrixCase, VerdictKind } from '../api/types';

/** Index in place of a result: the utilisation of the governing check. */
export const kUtilisation = -1;

export const resultName = (m: Matrix, output: number): string => (output === kUtilisation ? 'utilisation' : m.outputs[output]?.name ?? '');
export const resultUnit = (m: Matrix, output: number): string => (output === kUtilisation ? '' : m.outputs[output]?.unit ?? '');

const plainName = (name: string): string => name.replace(/^(static|dynamic|operation)\./, '').replace(/[._]/g, ' ').replace(/ value$/, '').replace(/\blay back\b/, 'lay-back').replace(/\bvon mises\b/, 'von Mises');

/** "Lay back [m]"; the utilisation as text. */
export function resultTitle(m: Matrix, output: number): string {
  if (output === kUtilisation) return 'Utilisation of the governing check';
  const name = plainName(resultName(m, output)), unit = resultUnit(m, output);
  return name.charAt(0).toUpperCase() + name.slice(1) + (unit ? ` [${unit}]` : '');
}

export const resultValue = (c: MatrixCase, output: number): number | null => (output === kUtilisation ? c.utilisation : c.values[output] ?? null);

/** "water depth" from "environment.water_depth". */
export const keyLabel = (key: string): string => key.split('.').at(-1)!.replace(/_/g, ' ');

/** Crossed axes with more than one value. */
export const spreadAxes = (m: Matrix): number[] => m.inputs.flatMap((input, i) => (!input.sampled && !input.with && input.words.length > 1 ? [i] : []));

/** The more extreme value over the seeds of one combination: the smallest of a minimum, otherwise the largest. */
export function worstValue(cases: MatrixCase[], output: number, name: string): number | null {
  const values = cases.map((c) => resultValue(c, output)).filter((v): v is number => v !== null);
  if (values.length === 0) return null;
  return /(^|[._])(min|smallest|least)/.test(name) ? Math.min(...values) : Math.max(...values);
}

export interface Cell { cases: MatrixCase[]; value: number | null; state: VerdictKind | 'failed' | 'open' }

const severity: Record<VerdictKind, number> = { passed: 0, reserved: 1, 'not judged': 2, exceeded: 3 };

const worstVerdict = (cases: MatrixCase[]): VerdictKind => cases.map((c) => c.verdict).reduce((a, b) => (severity[a] >= severity[b] ? a : b));

export function makeCell(cases: MatrixCase[], output: number, name: string): Cell {
  const state = cases.some((c) => c.state === 'failed') ? 'failed' : cases.length === 0 || cases.some((c) => c.state === 'open') ? 'open' : worstVerdict(cases);
  return { cases, value: worstValue(cases, output, name), state };
}

/** Cells over one or two axes (rows from the second), the other axes held at `fixed`. */
export function cellsOver(m: Matrix, axes: number[], fixed: Record<number, number>, output: number): Cell[][] {
  const [x, y] = axes, name = resultName(m, output);
  const rest = spreadAxes(m).filter((a) => !axes.includes(a));
  const count = (axis: number | undefined): number => (axis === undefined ? 1 : m.inputs[axis]!.words.length);
  const cases = Array.from({ length: count(y) }, () => Array.from({ length: count(x) }, (): MatrixCase[] => []));
  for (const c of m.cases) {
    if (!rest.every((a) => c.at[a] === (fixed[a] ?? 0))) continue;
    cases[y === undefined ? 0 : c.at[y]!]?.[x === undefined ? 0 : c.at[x]!]?.push(c);
  }
  return cases.map((row) => row.map((list) => makeCell(list, output, name)));
}

/** The case shown for a cell: one without a solution, otherwise that with the largest utilisation. */
export function foremost(cell: Cell): MatrixCase | null {
  const failed = cell.cases.find((c) => c.state === 'failed');
  if (failed) return failed;
  return cell.cases.reduce<MatrixCase | null>((a, b) => (a && (a.utilisation ?? 0) >= (b.utilisation ?? 0) ? a : b), null);
}

const distance = (a: MatrixCase, b: MatrixCase): number => a.words.filter((word, i) => word !== b.words[i]).length;

/** The case from which every other differs by one key at most; null if the keys are crossed. */
export function baseCase(m: Matrix): MatrixCase | null {
  if (m.inputs.length < 2 || m.cases.length < 3 || m.inputs.some((input) => input.sampled) || spreadAxes(m).length > 1) return null;
  const first = m.cases[0]!;
  return m.inputs.slice(1).every((input) => input.with !== '') && m.cases.every((c) => distance(c, first) <= 1) ? first : null;
}

/** `limits`: of operability; `each`: one key at a time; `list`: more than two crossed keys or none. */
export type Shape = 'limits' | 'each' | 'grid' | 'curve' | 'list';

export function findShape(m: Matrix): Shape {
  if (m.operability) return 'limits';
  if (baseCase(m)) return 'each';
  const axes = spreadAxes(m).length;
  return axes === 0 ? 'list' : axes === 1 ? 'curve' : 'grid';
}

/** The two keys with the most values, the tension along the columns. */
export function gridAxes(m: Matrix): [number, number] {
  const order = spreadAxes(m).sort((a, b) => m.inputs[b]!.words.length - m.inputs[a]!.words.length).slice(0, 2);
  const [x, y] = order as [number, number];
  return m.inputs[y]!.key === 'tensioner.tension' && m.inputs[x]!.key !== 'tensioner.tension' ? [y, x] : [x, y];
}

export interface Swing { key: string; low: number; high: number; lowWord: string; highWord: string }

/** The range of a result for each key in turn, the widest first. */
export function swings(m: Matrix, base: MatrixCase, output: number): Swing[] {
  const middle = resultValue(base, output);
  if (middle === null) return [];
  const all = m.inputs.map(({ key }, k): Swing => {
    const swing: Swing = { key, low: middle, high: middle, lowWord: base.words[k]!, highWord: base.words[k]! };
    for (const c of m.cases) {
      const value = resultValue(c, output);
      if (value === null || c.state !== 'done' || c.words[k] === base.words[k]) continue;
      if (value < swing.low) { swing.low = value; swing.lowWord = c.words[k]!; }
      if (value > swing.high) { swing.high = value; swing.highWord = c.words[k]!; }
    }
    return swing;
  });
  return all.sort((a, b) => (b.high - b.low) - (a.high - a.low));
}

const verdictLabels: Record<VerdictKind, string> = { passed: 'pass', reserved: 'pass with reservations', exceeded: 'exceed a check', 'not judged': 'solved, not judged' };

/** Counts as text. */
export function tally(m: Matrix): string {
  const n = (test: (c: MatrixCase) => boolean): number => m.cases.filter(test).length;
  const parts: [number, string][] = [
    ...(['passed', 'reserved', 'exceeded', 'not judged'] as const).map((kind): [number, string] => [n((c) => c.state === 'done' && c.verdict === kind), verdictLabels[kind]]),
    [n((c) => c.state === 'failed'), 'have no solution'], [n((c) => c.state === 'open'), 'pending']];
  return `${m.cases.length} cases: ${parts.filter(([count]) => count).map(([count, label]) => `${count} ${label}`).join(', ')}`;
}

/** Governing checks, the most frequent first, with a letter and their number of cases. */
export interface Governing { name: string; letter: string; count: number; most: number }

export function governingChecks(m: Matrix): Governing[] {
  const counts = new Map<string, { count: number; most: number }>();
  for (const c of m.cases) {
    if (!c.governing || c.state !== 'done') continue;
    const { count, most } = counts.get(c.governing) ?? { count: 0, most: 0 };
    counts.set(c.governing, { count: count + 1, most: Math.max(most, c.utilisation ?? 0) });
  }
  const order = [...counts].sort(([, a], [, b]) => b.count - a.count);
  return order.map(([name, of], k) => ({ name, letter: k < 26 ? String.fromCharCode(65 + k) : `Z${k - 25}`, ...of }));
}
