// Results next to the inputs in the table of a list: by the path of the list, from statics and from the run shown.
import type { Lay, OperationStage, RunSummary } from '../api/types';
import type { Support, SupportSummary, MooringLine, LineAtRest } from '../api/results';
import { pageUnits, shownUnit } from './show';

export interface ResultRow { name: string; index: number; list: string }
export interface ResultCell { text: string; warning?: string }
export interface ResultColumn {
  id: string; title: string; unit: string; group: string; info: string; isText?: boolean;
  cell: (row: ResultRow) => ResultCell;
}
export interface ResultSources { lay: Lay | null; run: RunSummary | null; stages: OperationStage[] }

type Read<T> = (item: T) => number | null | undefined;
type Finder<T> = (row: ResultRow) => T | undefined;

/** A column of numbers: `si` is the SI unit of the value, `digits` the decimals in metric units. */
function numbers<T>(id: string, title: string, group: string, info: string, [si, digits]: [si: string, digits: number], find: Finder<T>, read: Read<T>): ResultColumn {
  return {
    id: `${group}:${id}`, title, group, info, unit: si ? shownUnit(si).unit.replace('–', '') : '',
    cell: (row) => {
      const item = find(row), value = item === undefined ? null : read(item);
      return { text: value === null || value === undefined ? '' : si ? pageUnits.number(value, si === 'mm' ? 'section' : si, digits) : value.toFixed(digits) };
    },
  };
}

function byName<T extends { name: string }>(items: T[] | undefined): Finder<T> {
  const known = new Map((items ?? []).map((item) => [item.name, item]));
  return ({ name }) => known.get(name);
}

type Rollers = Support['rollers'];

/** Rollers row by row: each row begins with the same position. */
export function rollerRows(rollers: Rollers): Rollers[] {
  const rows: Rollers[] = [];
  for (const roller of rollers) {
    if (roller.position === rollers[0]!.position) rows.push([]);
    rows.at(-1)!.push(roller);
  }
  return rows;
}

const isSide = (position: string): boolean => position !== 'bottom';

function gap(support: Support): number | null {
  const below = support.rollers.filter((r) => !isSide(r.position)).map((r) => r.separation);
  return below.length ? Math.max(0, Math.min(...below)) : null;
}

function sideContact(support: Support): ResultCell {
  const loaded = support.rollers.filter((r) => isSide(r.position) && r.reaction > 0);
  if (loaded.length === 0) return { text: '' };
  const sides = [...new Set(loaded.map((r) => r.position))];
  return { text: `${sides.join(', ')} ${pageUnits.number(Math.max(...loaded.map((r) => r.reaction)), 'N', 1)}` };
}

function boxColumns({ lay, run }: ResultSources): ResultColumn[] {
  const named = byName(lay?.supports);
  const find: Finder<Support> = (row) => named(row);
  const offEnd = new Map((lay?.findings ?? []).filter((f) => f.code === 'pipe-at-roller-end').map((f) => [String(f.object ?? ''), f.message]));
  const group = 'static';
  const columns: ResultColumn[] = [
    numbers('reaction', 'reaction', group, 'Resultant of the rollers on the pipe', ['N', 1], find, (s) => s.reaction),
    numbers('gap', 'gap', group, 'Minimum clearance of the pipe from the bottom rollers; 0 in contact', ['mm', 1], find, gap),
    {
      id: `${group}:side`, title: 'side', group, unit: shownUnit('N').unit, info: 'Side rollers in contact, with the maximum force', isText: true,
      cell: (row) => { const s = find(row), warning = offEnd.get(row.name); return { ...(s ? sideContact(s) : { text: '' }), ...(warning ? { warning } : {}) }; },
    },
    {
      id: `${group}:carried`, title: 'carried', group, unit: '', info: 'Number of loaded roller rows', isText: true,
      cell: (row) => { const s = find(row); if (!s) return { text: '' }; const rows = rollerRows(s.rollers); return { text: `${rows.filter((r) => r.some((roller) => roller.reaction > 0)).length} of ${rows.length}` }; },
    },
  ];
  return run?.dynamic ? [...columns, ...stormBoxColumns(byName(run.dynamic.supports))] : columns;
}

function stormBoxColumns(find: Finder<SupportSummary>): ResultColumn[] {
  const group = 'storm';
  return [
    numbers('reaction', 'largest', group, 'Largest reaction in the run', ['N', 1], find, (s) => s.reaction.max),
    numbers('p99', '99 %', group, 'Reaction exceeded 1 % of the time', ['N', 1], find, (s) => s.reaction_percentiles.p99),
    numbers('gap', 'largest gap', group, 'Maximum separation of pipe and box', ['mm', 0], find, (s) => Math.max(0, s.separation.max)),
    numbers('contact', 'contact [%]', group, 'Fraction of time in contact', ['', 0], find, (s) => 100 * s.contact_share),
    numbers('impacts', 'impacts', group, 'Number of impacts', ['', 0], find, (s) => s.impacts),
  ];
}

function mooringColumns({ lay, run }: ResultSources): ResultColumn[] {
  const find = byName(lay?.moorings?.rest.moorings), group = 'static';
  const columns: ResultColumn[] = [
    numbers<MooringLine>('length', 'length', group, 'Unstretched length', ['m', 1], find, (m) => m.length),
    numbers<MooringLine>('fairlead', 'at fairlead', group, 'Tension at the fairlead', ['N', 1], find, (m) => m.fairlead_tension),
    numbers<MooringLine>('anchor', 'at anchor', group, 'Tension at the anchor', ['N', 1], find, (m) => m.anchor_tension),
    numbers<MooringLine>('utilisation', 'utilisation', group, 'Fairlead tension over breaking load', ['', 3], find, (m) => m.utilisation),
    numbers<MooringLine>('on_bed', 'on the seabed', group, 'Length on the seabed', ['m', 0], find, (m) => m.on_bed),
  ];
  const inTime = run?.dynamic?.moorings;
  if (!inTime) return columns;
  const later = byName(inTime);
  return [
    ...columns,
    numbers('fairlead', 'at fairlead', 'storm', 'Largest tension at the fairlead in the run', ['N', 1], later, (m) => m.fairlead_tension.max),
    numbers('utilisation', 'utilisation', 'storm', 'Largest utilisation in the run', ['', 3], later, (m) => m.utilisation),
  ];
}

function lineColumns({ lay }: ResultSources): ResultColumn[] {
  const find = byName(lay?.lines), group = 'static';
  return [
    numbers<LineAtRest>('largest', 'maximum tension', group, 'Maximum tension along the line', ['N', 1], find, (l) => l.largest_tension),
    numbers<LineAtRest>('least', 'minimum tension', group, 'Minimum tension along the line', ['N', 1], find, (l) => l.least_tension),
    numbers<LineAtRest>('on_bed', 'on the seabed', group, 'Length on the seabed', ['m', 1], find, (l) => l.on_bed),
    numbers<LineAtRest>('utilisation', 'utilisation', group, 'Tension over breaking load', ['', 3], find, (l) => l.utilisation),
  ];
}

function stageColumns({ stages }: ResultSources): ResultColumn[] {
  const find: Finder<OperationStage> = ({ index }) => stages[index], group = 'solved';
  return [
    numbers('top', 'top tension', group, 'Tension at the top of the line', ['N', 1], find, (s) => s.values?.top_tension),
    numbers('bottom', 'bottom tension', group, 'Tension at the seabed', ['N', 1], find, (s) => s.values?.bottom_tension),
    numbers('cable', 'cable tension', group, 'Tension of the cable', ['N', 1], find, (s) => s.values?.cable_tension),
    numbers('lay_back', 'lay-back', group, 'From the stern to touchdown', ['m', 1], find, (s) => s.values?.lay_back),
    numbers('utilisation', 'utilisation', group, 'Largest of the governing checks and the cable', ['', 3], find, (s) => s.values?.utilisation),
    { id: `${group}:failure`, title: 'state', group, unit: '', info: 'Equilibrium of the stage', isText: true, cell: (row) => { const s = find(row); return s?.failure ? { text: 'no equilibrium', warning: s.failure.why } : { text: s ? 'solved' : '' }; } },
  ];
}

const makers: [pattern: RegExp, make: (sources: ResultSources) => ResultColumn[]][] = [
  [/^supports\.(ramp|stinger)(\.sections\[\d+\])?\.boxes$/, boxColumns],
  [/^moorings\.lines$/, mooringColumns],
  [/^lines$/, lineColumns],
  [/^operation\.stages$/, stageColumns],
];

/** Result columns of the list at a path; empty for lists without results. */
export function resultColumns(path: string, sources: ResultSources): ResultColumn[] {
  return makers.find(([pattern]) => pattern.test(path))?.[1](sources) ?? [];
}
