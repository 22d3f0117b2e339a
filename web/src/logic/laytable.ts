// What a lay table asks for and how its curves are drawn; the program makes the table.
import type { TableData } from '../components/document';
import type { LayTable, LayTableVary } from '../api/types';

export interface LayTableWish { vary: LayTableVary; from: string; to: string; steps: string }

const number = (text: string): number | null => { const value = Number.parseFloat(text); return Number.isFinite(value) ? value : null; };

/** "200 kN..400 kN/20", as the program takes it. */
export const rangeText = (wish: LayTableWish): string => `${wish.from.trim()}..${wish.to.trim()}/${wish.steps.trim()}`;

export function layWishFault(wish: LayTableWish): string | null {
  const steps = Number(wish.steps);
  if (number(wish.from) === null || number(wish.to) === null) return 'from and to are numbers with their units';
  if (!/[a-zA-Z]/.test(wish.to)) return 'the unit is missing: 400 kN, 120 m';
  return Number.isInteger(steps) && steps >= 1 && steps <= 1000 ? null : 'steps are a whole number from 1 to 1000';
}

/** What a table over it usually covers, from the lay that is shown: SI values. */
export function usualRange(vary: LayTableVary, lay: { top_tension: number; lay_back: number } | null, depth: number | null): LayTableWish {
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

/** Steps by their number, limits by their name. */
export const layRowName = ({ rows }: LayTable, i: number): string =>
  (rows[i]!.kind === 'step' ? String(rows.slice(0, i + 1).filter(({ kind }) => kind === 'step').length) : rows[i]!.kind);

/** The rows, with those that are limits set apart. */
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

/** Tension and depth of a row as keys of the model; without one that has no lay. */
export function layRowKeys({ columns, rows }: LayTable, i: number): { key: string; text: string }[] {
  const value = (title: string, key: string): { key: string; text: string }[] => {
    const at = columns.findIndex(({ heading }) => titleParts(heading).title === title), cell = rows[i]?.cells[at];
    return typeof cell === 'number' ? [{ key, text: `${Number(cell.toPrecision(6))} ${titleParts(columns[at]!.heading).unit ?? ''}`.trim() }] : [];
  };
  return [...value('top tension', 'tensioner.tension'), ...value('depth', 'environment.water_depth')];
}
