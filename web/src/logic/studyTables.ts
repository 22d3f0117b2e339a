// Tables of a study: a result over two keys, governing checks, permissible tensions of each depth, cases, limits.
import type { Cell as TableCell, Column, TableData } from '../components/document';
import type { Matrix, MatrixCase, MatrixLimits } from '../api/types';
import { withoutPaths } from './findings';
import type { DepthLimits, LimitEnd } from './layGrid';
import { cellsOver, foremost, governingChecks, keyLabel, kUtilisation, resultTitle, type Cell } from './studies';
import { tidy } from './units';

/** Decimals that show about four digits of every value, without common trailing zeros. */
export function decimals(values: readonly (number | null)[]): number {
  const numbers = values.filter((v): v is number => v !== null && Number.isFinite(v));
  const largest = Math.max(...numbers.map(Math.abs), 0), wanted = largest > 0 ? Math.min(4, Math.max(0, 3 - Math.floor(Math.log10(largest)))) : 0;
  const isWhole = (digits: number): boolean => numbers.every((v) => Math.abs(v - Number(v.toFixed(digits))) < 1e-6 * Math.max(1, Math.abs(v)));
  return Array.from({ length: wanted }, (_, digits) => digits).find(isWhole) ?? wanted;
}

const titled = (input: { key: string; unit: string; values: (number | null)[] }): Column => (
  { title: keyLabel(input.key), unit: input.unit || undefined, digits: decimals(input.values) });

const inputValue = (input: { words: string[]; values: (number | null)[] }, i: number): TableCell => input.values[i] ?? input.words[i] ?? '';

const short = (value: TableCell): string => (typeof value === 'number' ? tidy(value, 5) : String(value ?? ''));

const verdictMark = (c: MatrixCase): 'over' | 'reserved' | 'soft' | '' =>
  (c.state !== 'done' ? 'soft' : c.verdict === 'exceeded' ? 'over' : c.verdict === 'reserved' ? 'reserved' : '');

/** Rows and columns are keys; `cell` gives the content of their intersection. */
function crossed(m: Matrix, [x, y]: readonly number[], cells: Cell[][], title: string, isText: boolean, cell: (of: Cell) => TableCell): TableData {
  const across = m.inputs[x!]!, down = m.inputs[y!]!, unit = across.unit ? ` ${across.unit}` : '';
  const rows = cells.map((row) => row.map(cell)), digits = decimals(rows.flat().filter((value) => typeof value === 'number'));
  return {
    title, look: 'plain',
    columns: [{ ...titled(down), words: true }, ...across.words.map((_, i): Column => ({ title: `${short(inputValue(across, i))}${unit}`, digits, words: isText }))],
    rows: rows.map((row, j) => [short(inputValue(down, j)), ...row]),
  };
}

/** The selected result over two keys. */
export const resultTable = (m: Matrix, axes: readonly number[], cells: Cell[][], output: number): TableData =>
  crossed(m, axes, cells, resultTitle(m, output), false, (cell) => cell.value ?? (cell.state === 'failed' ? 'no solution' : null));

/** The governing check over two keys. */
export const governingTable = (m: Matrix, axes: readonly number[], cells: Cell[][]): TableData =>
  crossed(m, axes, cells, 'Governing check', true, (cell) => foremost(cell)?.governing || (cell.state === 'failed' ? 'no solution' : ''));

/** Number of cases that each check governs. */
export const governingCounts = (m: Matrix): TableData => ({
  title: 'Governing checks', look: 'plain',
  columns: [{ title: '', words: true }, { title: 'check', words: true }, { title: 'cases', digits: 0 }, { title: 'largest utilisation', digits: 3 }],
  rows: governingChecks(m).map(({ letter, name, count, most }) => [letter, name, count, most]),
});

const endText = (end: LimitEnd | null, sign: string): string => (end ? `${end.open ? sign : ''}${tidy(end.tension, 4)}` : 'none');

/** Permissible tensions for every depth. */
export function tensionTable(m: Matrix, axes: readonly number[], list: DepthLimits[]): TableData {
  const [x, y] = axes.map((a) => m.inputs[a]!) as [Matrix['inputs'][number], Matrix['inputs'][number]];
  const length = m.outputs.find(({ name }) => name.endsWith('.lay_back'))?.unit;
  const back = (end: LimitEnd | null): TableCell => end?.layBack ?? null, open = m.cases.some((c) => c.state === 'open');
  return {
    title: 'Permissible tensions', look: 'plain',
    columns: [
      titled(y), { title: 'minimum tension', unit: x.unit }, { title: 'maximum', unit: x.unit }, { title: 'lay-back at minimum', unit: length, digits: 1 },
      { title: 'at maximum', unit: length, digits: 1 }, { title: 'limit below', words: true }, { title: 'limit above', words: true },
    ],
    rows: list.map(({ word, least, most, gap }, j) => [
      inputValue(y, j) || word, endText(least, '≤ '), `${endText(most, '≥ ')}${gap ? ' *' : ''}`, back(least), back(most), least?.because ?? '', most?.because ?? '']),
    marks: list.map(({ least }) => (least || open ? '' : 'over')),
  };
}

/** A row for every case. */
export function casesTable(m: Matrix, list: readonly MatrixCase[] = m.cases): TableData {
  const seeds = m.cases.some((c) => c.seed !== null);
  return {
    title: 'Cases', look: 'plain',
    columns: [
      { title: 'case', words: true }, ...m.inputs.map(titled), ...(seeds ? [{ title: 'seed', digits: 0 }] : []), { title: 'verdict', words: true },
      { title: 'utilisation', digits: 3 }, { title: 'governing check', words: true },
      ...m.outputs.map(({ unit }, i): Column => ({ title: resultTitle({ ...m, outputs: m.outputs.map((o) => ({ ...o, unit: '' })) }, i), unit: unit || undefined, digits: decimals(m.cases.map((c) => c.values[i] ?? null)) })),
      { title: 'remark', words: true },
    ],
    rows: list.map((c) => [
      String(c.number), ...m.inputs.map((_, i): TableCell => c.inputs[i] ?? c.words[i] ?? ''), ...(seeds ? [c.seed] : []),
      c.state === 'failed' ? 'no solution' : c.state === 'open' ? '' : c.verdict, c.utilisation, c.governing, ...m.outputs.map((_, i) => c.values[i] ?? null),
      withoutPaths(c.reason) || c.obstacle]),
    marks: list.map(verdictMark),
  };
}

/** Limits of operability over one or two keys; for more keys a row for every combination. */
export function limitsTable(of: MatrixLimits): TableData {
  const shown = (c: MatrixLimits['cells'][number]): string =>
    (!c.decided ? '?' : `${c.limit === null ? 'none' : `${c.beyond ? '≥ ' : ''}${tidy(c.limit, 4)}`}${c.reason ? ' *' : ''}`);
  return {
    title: `Limiting ${of.over}`, look: 'plain',
    columns: [...of.axes.map(titled), { title: `limiting ${keyLabel(of.over)}`, unit: of.unit || undefined }, { title: 'exceeded above the limit', words: true }, { title: 'remark', words: true }],
    rows: of.cells.map((c) => [...of.axes.map((axis, k) => inputValue(axis, c.at[k]!)), shown(c), c.decided ? c.governing : '', withoutPaths(c.reason)]),
    marks: of.cells.map((c) => (!c.decided || c.limit === null ? 'over' : '')),
  };
}

/** Sheets of a workbook: over two keys the result, governing checks and tensions, then all cases. */
export function studySheets(m: Matrix, axes: readonly number[], fixed: Record<number, number>, tensions: DepthLimits[] | null): TableData[] {
  if (m.operability) return [limitsTable(m.operability)];
  const cases = casesTable(m);
  if (axes.length < 2) return [cases];
  const cells = cellsOver(m, [...axes], fixed, kUtilisation);
  return [
    { ...resultTable(m, axes, cells, kUtilisation), title: 'Utilisation' }, governingTable(m, axes, cells),
    ...(tensions ? [{ ...tensionTable(m, axes, tensions), title: 'Tensions' }] : []), cases];
}
