// A lay table of water depths by tensions: its request, and the permissible tensions of each depth.
import type { Field, Matrix, MatrixCase } from '../api/types';
import { cellsOver, foremost, kUtilisation, type Cell } from './studies';
import { axisYaml, firstAxis, type AxisRequest, type ModelKeys } from './studyFile';

export const kTension = 'tensioner.tension';
export const kDepth = 'environment.water_depth';

export interface GridRequest { rows: AxisRequest; columns: AxisRequest }

export const usualGrid = (byPath: ReadonlyMap<string, Field>): GridRequest => (
  { rows: firstAxis(byPath.get(kDepth) ?? undefined, 0.8, 1.25, 5), columns: firstAxis(byPath.get(kTension) ?? undefined, 0.8, 1.5, 8) });

const gridAxes = (request: GridRequest): AxisRequest[] => [{ ...request.rows, key: kDepth }, { ...request.columns, key: kTension }];

export function findGridError(request: GridRequest, model: ModelKeys): string | null {
  const bad = gridAxes(request).find((axis) => axisYaml(axis, model.unit(axis.key)) === null);
  return bad ? `${bad.key === kDepth ? 'depths' : 'tensions'}: enter from and to with units, and a number of at least 2` : null;
}

export const gridYaml = (request: GridRequest, base: string, model: ModelKeys): string => [
  'overbend_study: 1', `base: ${/^[\w.+-]+$/.test(base) ? base : JSON.stringify(base)}`, 'analysis: static', 'axes:',
  ...gridAxes(request).map((axis) => `  - ${axisYaml(axis, model.unit(axis.key)) ?? '{}'}`), ''].join('\n');

/** Limits of a case; `clearance` at the stinger tip, null: any. In the units of the study. */
export interface LayLimits { utilisation: number; clearance: number | null; reserved: boolean }

export const usualLimits: LayLimits = { utilisation: 1, clearance: null, reserved: false };

const clearanceOutput = (m: Matrix): number => m.outputs.findIndex(({ name }) => name.endsWith('stinger_tip_clearance'));
const layBackOutput = (m: Matrix): number => m.outputs.findIndex(({ name }) => name.endsWith('.lay_back'));

/** Reason why a case violates the limits; null if it does not. */
export function limitBroken(m: Matrix, c: MatrixCase | null, limits: LayLimits): string | null {
  if (!c || c.state === 'open') return 'not computed yet';
  if (c.state === 'failed') return 'no solution';
  if (c.verdict === 'exceeded' || (c.utilisation ?? 0) > limits.utilisation) return c.governing;
  const clearance = c.values[clearanceOutput(m)];
  if (limits.clearance !== null && clearance !== null && clearance !== undefined && clearance < limits.clearance) return 'tip clearance';
  return c.verdict === 'reserved' && !limits.reserved ? c.obstacle || 'reservations' : null;
}

/** An end of the range; `open`: the table ends before the range does. */
export interface LimitEnd { tension: number; open: boolean; because: string; layBack: number | null }

export interface DepthLimits { word: string; least: LimitEnd | null; most: LimitEnd | null; gap: boolean }

/** Tension at which the utilisation crosses its limit (interpolated), otherwise the last permissible tension. */
function crossing(inside: MatrixCase, outside: MatrixCase, x: number, limits: LayLimits): number {
  const [a, b] = [inside.inputs[x]!, outside.inputs[x]!], [ua, ub] = [inside.utilisation, outside.utilisation];
  if (ua === null || ub === null || ub <= limits.utilisation || inside.governing !== outside.governing) return a;
  return a + (b - a) * (limits.utilisation - ua) / (ub - ua);
}

function rangeEnd(m: Matrix, x: number, inside: MatrixCase, outside: MatrixCase | null, limits: LayLimits): LimitEnd {
  const layBack = inside.values[layBackOutput(m)] ?? null;
  if (!outside) return { tension: inside.inputs[x]!, open: true, because: '', layBack };
  return { tension: crossing(inside, outside, x, limits), open: false, because: limitBroken(m, outside, limits) ?? '', layBack };
}

/** Minimum and maximum permissible tension of every row, within the table. */
export function depthLimits(m: Matrix, x: number, y: number, fixed: Record<number, number>, limits: LayLimits): DepthLimits[] {
  const tension = (cell: Cell): number => foremost(cell)?.inputs[x] ?? Infinity;
  return cellsOver(m, [x, y], fixed, kUtilisation).map((cells, j) => {
    const row = [...cells].sort((a, b) => tension(a) - tension(b)).map(foremost);
    const kept = row.map((c) => c !== null && c.inputs[x] !== null && limitBroken(m, c, limits) === null);
    const first = kept.indexOf(true), last = kept.lastIndexOf(true), word = m.inputs[y]!.words[j]!;
    if (first < 0) return { word, least: null, most: null, gap: false };
    return {
      word, gap: kept.slice(first, last).includes(false),
      least: rangeEnd(m, x, row[first]!, row[first - 1] ?? null, limits), most: rangeEnd(m, x, row[last]!, row[last + 1] ?? null, limits),
    };
  });
}
