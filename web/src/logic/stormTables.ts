// Results of a storm as tables: statistics, extremes, roller boxes and rollers.
import type { DynamicSummary, ExtremeOverTime, Lay, Region, RegionSummary, Spread, Study, StudyQuantity } from '../api/types';
import type { Cell, Column, TableData } from '../components/document';
import { shownUnit } from './show';
import { tidy } from './units';

const numbers = (title: string, digits: number, unit = '', description = ''): Column =>
  ({ title, digits, ...(unit ? { unit } : {}), ...(description ? { description } : {}) });
const textColumn = (title: string): Column => ({ title, words: true });

const isValue = (value: number | null | undefined): value is number => value !== null && value !== undefined && Number.isFinite(value);
const unitText = (si: string): string => (si === '%' ? '%' : shownUnit(si).unit);

/** A value as text, for a table in which each row has a different unit. */
function cell(value: number | null | undefined, si: string): Cell {
  if (!isValue(value)) return null;
  if (si === '%') return (100 * value).toFixed(3);
  const { factor, digits } = shownUnit(si);
  return (value * factor).toFixed(digits > 4 ? 3 : digits);
}

type Row = [name: string, si: string, atRest: number | null | undefined, over: Spread | ExtremeOverTime | null | undefined];

function regionRows(name: string, before: Region | null | undefined, over: RegionSummary | null | undefined): Row[] {
  if (!over) return [];
  return [
    [`${name}: von Mises stress`, 'Pa', before?.von_mises, over.max_von_mises],
    [`${name}: bending stress`, 'Pa', before?.bending_stress, over.max_bending_stress],
    [`${name}: strain`, '%', before?.strain, over.max_strain],
  ];
}

/** Statistics of one run with its static values. */
export function statisticsTable(d: DynamicSummary, lay: Lay | null): TableData {
  const k = lay?.key;
  const t = d.tensioner;
  const rows: Row[] = [
    ['top tension', 'N', k?.top_tension, d.top_tension], ['bottom tension', 'N', k?.bottom_tension, d.bottom_tension],
    ['minimum tension along the line', 'N', null, d.smallest_tension],
    ...(t ? [['tensioner travel', 'm', 0, { min: t.travel_min, max: t.travel_max, mean: t.travel_mean, std: t.travel_std }] as Row] : []),
    ...regionRows('overbend', k?.overbend, d.overbend), ...regionRows('tower', k?.tower, d.tower), ...regionRows('sagbend', k?.sagbend, d.sagbend),
    ['lay-back', 'm', k?.lay_back, d.lay_back],
    ['departure angle', 'rad', k?.departure_angle, d.departure_angle],
    ['stinger tip clearance', 'm', k?.stinger_tip_clearance, d.stinger_tip_clearance],
  ];
  return {
    title: '', look: 'dense',
    columns: [textColumn('quantity'), textColumn('unit'), ...['static', 'min', 'mean', 'max', 'std'].map((title) => numbers(title, 1))],
    rows: rows.filter(([, , , over]) => over).map(([name, si, before, over]) =>
      [name, unitText(si), ...[before, over!.min, over!.mean, over!.max, over!.std].map((value) => cell(value, si))]),
  };
}

const shownCell = (q: StudyQuantity, value: number | null | undefined): Cell => (isValue(value) ? tidy(value * q.factor, 4) : null);

/** Quantities of seeds or variants, one row each: statistics over seeds, or the variants in columns. */
export function studyTable(study: Study): TableData {
  const seeds = study.kind === 'seeds';
  const heads = seeds ? ['mean', 'std', 'min', 'max'] : study.cases.map((variant) => variant.words);
  const values = (q: StudyQuantity): (number | null | undefined)[] => (seeds ? [q.mean, q.std, q.min, q.max] : q.values);
  return {
    title: '', look: 'dense',
    columns: [textColumn(seeds ? `over ${study.cases.length} seeds` : 'quantity'), textColumn('unit'), ...heads.map((title) => numbers(title, 1))],
    rows: study.quantities.map((q) => [q.text, q.unit === '-' ? '' : q.unit, ...values(q).map((value) => shownCell(q, value))]),
  };
}

/** Most probable three-hour extremes from all seeds; null if there are too few. */
export function seedExtremes(study: Study): TableData | null {
  const known = study.quantities.filter((q) => q.gumbel ?? q.acer);
  if (known.length === 0) return null;
  const three = (q: StudyQuantity, e: StudyQuantity['gumbel']): Cell[] => [e?.estimate, e?.low, e?.high].map((value) => shownCell(q, value));
  const heads = ['3 h', '2.5 %', '97.5 %'];
  return {
    title: '', look: 'dense',
    columns: [textColumn('quantity'), textColumn('unit'), ...[...heads, ...heads].map((title) => numbers(title, 1))],
    groups: [['', 2], ['Gumbel', 3], ['ACER', 3]],
    rows: known.map((q) => [q.text, q.unit === '-' ? '' : q.unit, ...three(q, q.gumbel), ...three(q, q.acer)]),
  };
}

/** "overbend von Mises". */
export const extremeName = (name: string): string =>
  name.replace(/^(support|mooring)\//, '').replace(/_peak$/, '').replaceAll('_', ' ').replace('von mises', 'von Mises').replace('/', ', ');

export function extremesTable(d: DynamicSummary): TableData {
  return {
    title: '', look: 'dense',
    columns: [
      textColumn('quantity'), textColumn('unit'), ...['seen', 'in 3 h', '2.5 %', '97.5 %'].map((title) => numbers(title, 1)),
      numbers('peaks', 0), textColumn('method'), textColumn('quality'), textColumn('remark'),
    ],
    rows: d.extremes.map((e) => {
      const si = /strain/.test(e.name) ? '%' : e.units;
      const values = [e.observed, e.estimate, e.low, e.high].map((value) => cell(value, si));
      return [`${extremeName(e.name)}${e.smallest ? ', smallest' : ''}`, unitText(si), ...values, e.peaks, e.method, e.quality, e.remark];
    }),
  };
}

const kilo = (): Pick<Column, 'unit' | 'digits'> => ({ unit: shownUnit('N').unit, digits: shownUnit('N').digits });
const force = (value: number | null | undefined): Cell => (isValue(value) ? value * shownUnit('N').factor : null);
const length = (value: number | null | undefined): Cell => (isValue(value) ? value * shownUnit('mm').factor : null);
const percent = (share: number): Cell => 100 * share;

const forceColumns = (titles: string[]): Column[] => titles.map((title) => ({ title, ...kilo() }));
const contactColumns = (): Column[] => [
  numbers('in contact', 1, '%', 'Fraction of time'), numbers('impacts', 0), { title: 'largest impact', ...kilo() },
  numbers('dent', 2, shownUnit('mm').unit, 'Dent depth of bare steel to DNV-RP-F107'),
];

/** Roller boxes over time: reaction statistics, contact, impacts. */
export function boxesTable(d: DynamicSummary, lay: Lay | null): TableData {
  const impacts = new Map(d.impacts.map((hit) => [hit.name, hit]));
  const atRest = new Map((lay?.supports ?? []).map((box) => [box.name, box.reaction]));
  return {
    title: '', look: 'dense',
    columns: [textColumn('box'), ...forceColumns(['static', 'min', 'mean', '99 %', 'max', 'std']), ...contactColumns()],
    rows: d.supports.map((box) => {
      const hits = impacts.get(box.name), r = box.reaction;
      const reactions = [atRest.get(box.name), r.min, r.mean, box.reaction_percentiles.p99, r.max, r.std];
      return [box.name, ...reactions.map(force), percent(box.contact_share), box.impacts, force(hits?.largest_impact_force), length(hits?.dent_depth)];
    }),
    marks: d.supports.map((box) => (box.left_to_port !== null || box.left_to_starboard !== null ? 'over' : '')),
  };
}

interface RollerOverTime { reaction: Spread; contact_share: number; impacts: number; largest_impact_force: number; dent_depth: number }

/** The same for each roller. */
export function rollersTable(d: DynamicSummary): TableData {
  const rows: Cell[][] = [];
  for (const box of d.supports) {
    box.rows.forEach((row, i) => {
      for (const [position, r] of Object.entries(row as Record<string, RollerOverTime>)) {
        if (typeof r !== 'object' || !r?.reaction) continue;
        const { min, mean, max, std } = r.reaction;
        const contact = [percent(r.contact_share), r.impacts, force(r.largest_impact_force), length(r.dent_depth)];
        rows.push([box.name, i + 1, position, ...[min, mean, max, std].map(force), ...contact]);
      }
    });
  }
  const columns = [textColumn('box'), numbers('row', 0), textColumn('roller'), ...forceColumns(['min', 'mean', 'max', 'std']), ...contactColumns()];
  return { title: '', look: 'dense', columns, rows };
}

/** Default histories, by importance, as far as the run has them. */
export function firstHistories(names: readonly string[]): string[] {
  const wanted = [/^top_tension$/, /^overbend_von_mises$/, /^heave$/, /^sagbend_von_mises$/, /^vessel\/heave$/, /^mooring\/.*tension$/, /tension$/];
  const found = wanted.map((pattern) => names.find((name) => pattern.test(name))).filter((name): name is string => name !== undefined);
  return [...new Set([...found, ...names])].slice(0, 4);
}

/** Frequencies [Hz] to show: slightly beyond those that contain 99.9 % of the variance. */
export function shownFrequencies(frequency: readonly number[], density: readonly number[]): number {
  const total = density.reduce((sum, d) => sum + d, 0);
  let sum = 0;
  for (let i = 0; i < density.length; ++i) {
    sum += density[i]!;
    if (sum >= 0.999 * total) return Math.min(frequency.length, Math.max(8, Math.ceil(1.2 * (i + 1))));
  }
  return frequency.length;
}
