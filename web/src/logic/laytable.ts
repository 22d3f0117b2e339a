// Request of a lay table, and the layout of its curves; the program computes the table.
import type { TableData } from '../components/document';
import type { LayTable, LayTableVary } from '../api/types';

export interface LayTableRequest { vary: LayTableVary; from: string; to: string; steps: string }

const number = (text: string): number | null => { const value = Number.parseFloat(text); return Number.isFinite(value) ? value : null; };

/** "200 kN..400 kN/20", in the notation of the program. */
export const rangeText = (request: LayTableRequest): string => `${request.from.trim()}..${request.to.trim()}/${request.steps.trim()}`;

export function findLayTableError(request: LayTableRequest): string | null {
  const steps = Number(request.steps);
  if (number(request.from) === null || number(request.to) === null) return 'enter from and to as numbers with units';
  if (!/[a-zA-Z]/.test(request.to)) return 'enter the unit as well, for example 400 kN or 120 m';
  return Number.isInteger(steps) && steps >= 1 && steps <= 1000 ? null : 'steps must be a whole number from 1 to 1000';
}

/** Default range about the lay shown: SI values. */
export function usualRange(vary: LayTableVary, lay: { top_tension: number; lay_back: number } | null, depth: number | null): LayTableRequest {
  const span = (value: number | null | undefined, less: number, more: number, unit: string, factor: number): [string, string] =>
    (value ? [`${Number((less * value * factor).toPrecision(3))} ${unit}`, `${Number((more * value * factor).toPrecision(3))} ${unit}`] : ['', '']);
  const [from, to] = vary === 'tension' ? span(lay?.top_tension, 0.8, 1.6, 'kN', 1e-3) : vary === 'lay_back' ? span(lay?.lay_back, 0.9, 1.2, 'm', 1) : span(depth, 0.8, 1.2, 'm', 1);
  return { vary, from, to, steps: '16' };
}

/** "tension [kN]": title and unit. */
function titleParts(heading: string): { title: string; unit?: string } {
  const [, title = heading, unit] = /^(.*?)(?: \[(.*)\])?$/.exec(heading)!;
  return { title, unit };
}

/** Steps by number, limits by name. */
export const layRowName = ({ rows }: LayTable, i: number): string =>
  (rows[i]!.kind === 'step' ? String(rows.slice(0, i + 1).filter(({ kind }) => kind === 'step').length) : rows[i]!.kind);

/** The rows, with limits highlighted. */
export function layRows(table: LayTable): TableData {
  const { columns, rows } = table;
  return {
    title: 'Lay table',
    look: 'lay-rows',
    columns: columns.map(({ heading, digits }, i) => (
      { ...titleParts(heading), digits: Math.min(digits, 4), words: rows.every((row) => typeof row.cells[i] === 'string') })),
    rows: rows.map((row, i) => row.cells.map((cell, k) => (k === 0 && cell === row.kind ? layRowName(table, i) : cell ?? '-'))),
    marks: rows.map(({ kind, verdict }) => (kind !== 'step' ? 'limit' : verdict === 'passed' ? '' : verdict === 'reserved' ? 'reserved' : 'over')),
  };
}

/** Tension and depth of a row as keys of the model; empty if it has no lay. */
export function layRowKeys({ columns, rows }: LayTable, i: number): { key: string; text: string }[] {
  const value = (title: string, key: string): { key: string; text: string }[] => {
    const column = columns.findIndex(({ heading }) => titleParts(heading).title === title), cell = rows[i]?.cells[column];
    return typeof cell === 'number' ? [{ key, text: `${Number(cell.toPrecision(6))} ${titleParts(columns[column]!.heading).unit ?? ''}`.trim() }] : [];
  };
  return [...value('top tension', 'tensioner.tension'), ...value('depth', 'environment.water_depth')];
}
