// Operations on the line: the table of stages, and the parts of the line in a stage: pipe, head and cable.
import type { LineParts, Operation, OperationStage, StageValues } from '../api/types';
import type { Cell, TableData } from '../components/document';
import { display, fixedIn, unitName } from './show';

export type PartName = 'pipe' | 'head' | 'cable';

/** Line part at arc length `s` from the tensioner. */
export function partAt(parts: LineParts | null, s: number): PartName {
  if (!parts) return 'pipe';
  if (s >= parts.head_from && s <= parts.head_to) return 'head';
  return (s > parts.head_to) === parts.cable_at_far_end ? 'cable' : 'pipe';
}

/** Colours of head and cable, distinct from every colour of the pipe. */
export const partColours = (dark: boolean): Record<'head' | 'cable', string> => (dark ? { head: '#d782f0', cable: '#dfe5ea' } : { head: '#8e24aa', cable: '#2b3640' });

export type StageLevel = 'good' | 'near' | 'over' | 'unknown' | 'gone';

/** By verdict and utilisation; `gone` if the stage has no solution. */
export function stageLevel(stage: OperationStage): StageLevel {
  if (!stage.values) return 'gone';
  const { utilisation, verdict } = stage.values;
  if ((utilisation ?? 0) > 1 || verdict.startsWith('EXCEEDED')) return 'over';
  if (verdict.includes('RESERVATION')) return 'near';
  return utilisation === null ? 'unknown' : 'good';
}

/** The mark repeats the meaning of the colour. */
export const stageLights: Record<StageLevel, { mark: string; text: string }> = {
  good: { mark: '●', text: 'passes' }, near: { mark: '▲', text: 'passes with reservations' }, over: { mark: '✕', text: 'fails' },
  unknown: { mark: '○', text: 'not judged' }, gone: { mark: '⊘', text: 'no solution' },
};

/** `unit`: SI, for values shown in the unit of the page; '%' and '' are not converted. `setting`: an input of the stage. */
export interface StageColumn { name: string; unit: string; title: string; digits: number; setting?: 'out' | 'tension'; value: (s: OperationStage) => number | null }

const of = (name: string, unit: string, title: string, digits: number, key: keyof StageValues): StageColumn =>
  ({ name, unit, title, digits, value: (s) => (s.values ? (s.values[key] as number | null) : null) });

/** Columns with a value in any stage. */
export function stageColumns(o: Operation): StageColumn[] {
  const all: StageColumn[] = [
    { name: o.out_name.toLowerCase(), unit: 'm', title: 'Progress of the operation', digits: 1, setting: 'out', value: (s) => s.out },
    { name: 'top', unit: 'N', title: 'Tension at the top', digits: 1, setting: 'tension', value: (s) => s.values?.top_tension ?? null },
    of('bottom', 'N', 'Horizontal tension at touchdown', 1, 'bottom_tension'),
    of('end z', 'm', 'Height of the free end above the water', 2, 'end_height'),
    of('moment', 'N m', 'Largest bending moment of lifted pipe', 1, 'largest_moment'),
    of('bending', 'Pa', 'Largest bending stress of lifted pipe', 0, 'largest_bending_stress'),
    of('davit', 'N', 'Largest tension of a davit', 1, 'davit_tension'),
    of('head z', 'm', 'Height of the head above the water', 1, 'head_z'),
    of('head x', 'm', 'Head, astern of the stern shoe', 1, 'head_x'),
    of('sagbend', 'Pa', 'Largest von Mises stress of the sagbend', 0, 'sagbend_von_mises'),
    of('strain', '%', 'Largest strain of the sagbend', 3, 'sagbend_strain'),
    of('tip', 'm', 'Clearance at the stinger tip', 2, 'stinger_tip_clearance'),
    of('roller', 'N', 'Largest load of a roller', 1, 'largest_reaction'),
    of('cable', '%', 'Largest tension of the cable over its breaking load', 1, 'cable_utilisation'),
    { name: 'ahead', unit: 'm', title: 'Advance of the vessel since the first stage', digits: 1, value: (s) => (s.values && o.stages.some((x) => Math.abs(x.barge_ahead) > 5e-3) ? s.barge_ahead : null) },
    of('use', '', 'Largest utilisation of the governing checks and the cable', 3, 'utilisation'),
  ];
  return all.filter((c) => o.stages.some((s) => c.value(s) !== null));
}

/** Inputs of a stage; the other columns are results. */
export const isSetting = (column: StageColumn): boolean => column.setting !== undefined;

/** The stages as a table of numbers, for spreadsheets. */
export function stageTable(o: Operation): TableData {
  const columns = stageColumns(o);
  const number = (column: StageColumn, stage: OperationStage): Cell => {
    const value = column.value(stage);
    return value === null ? null : column.unit === '%' ? 100 * value : column.unit === '' ? value : value * display(column.unit)[1];
  };
  return {
    title: o.title, look: 'dense',
    columns: [{ title: 'stage', words: true }, ...columns.map((c) => ({ title: c.name, unit: columnUnit(c) || undefined, digits: c.digits })), { title: 'verdict', words: true }],
    rows: o.stages.map((stage, i) => [stageName(stage, i), ...columns.map((c) => number(c, stage)), stage.values?.verdict ?? whyNot(stage)]),
  };
}

export const columnUnit = (c: StageColumn): string => (c.unit === '%' || c.unit === '' ? c.unit : unitName(c.unit));

/** Never "-0". */
export function cell(c: StageColumn, s: OperationStage): string {
  const v = c.value(s);
  if (v === null) return '–';
  const text = c.unit === '%' ? (100 * v).toFixed(c.digits) : c.unit === '' ? v.toFixed(c.digits) : fixedIn(v, c.unit, c.digits);
  return Number(text) === 0 ? text.replace('-', '') : text;
}

export const stageName = (s: OperationStage, i: number): string => (s.name && s.name !== `stage ${i + 1}` ? `${i + 1} ${s.name}` : String(i + 1));

/** "2 of 7: head past the tip". */
export function stagePlace(s: OperationStage, i: number, count: number): string {
  const place = `${i + 1} of ${count}`;
  return s.name && s.name !== `stage ${i + 1}` ? `${place}: ${s.name}` : place;
}

/** Reason why a stage has no solution, with the minimum tension that has one. */
export function whyNot(s: OperationStage): string {
  const f = s.failure;
  if (!f) return '';
  const least = f.least_tension === null ? '' : ` The minimum top tension is ${fixedIn(f.least_tension, 'N', 1)} ${unitName('N')}.`;
  return `${[f.what, f.where].filter(Boolean).join(', ')}${f.why ? `: ${f.why}` : ''}.${least}`.replace('..', '.');
}
