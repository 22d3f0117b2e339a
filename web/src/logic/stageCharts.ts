// Diagrams of the stage results over the length paid out.
import type { ChartData, Line } from '../charts/data';
import type { Operation, OperationStage, StageValues } from '../api/types';
import { display, unitName } from './show';

/** Distinct for all kinds of colour vision, on light and dark background. */
const palette = ['#0b7bd0', '#d9730d', '#2a9d72', '#b565c9'];

interface CurveSpec { name: string; value: (stage: OperationStage) => number | null }
interface Spec { title: string; unit: string; curves: CurveSpec[]; level?: ChartData['level'] }

const result = (name: string, key: keyof StageValues): CurveSpec => ({ name, value: (stage) => (stage.values ? (stage.values[key] as number | null) : null) });

const specs = (operation: Operation): Spec[] => [
  { title: 'Tension', unit: 'N', curves: [result('top', 'top_tension'), result('bottom', 'bottom_tension'), result('cable, largest', 'cable_tension'), result('davit, largest', 'davit_tension')] },
  { title: 'Utilisation', unit: '', curves: [result('checks and cable', 'utilisation')], level: [{ y: 1, label: 'limit', kind: 'limit' }] },
  { title: 'Head above the water', unit: 'm', curves: [result('head', 'head_z')], level: [{ y: 0, label: 'water', kind: 'water' }] },
  { title: 'Free end above the water', unit: 'm', curves: [result('free end', 'end_height')], level: [{ y: 0, label: 'water', kind: 'water' }] },
  { title: 'Head above the seabed', unit: 'm', curves: [result('clearance', 'head_clearance')] },
  { title: 'Von Mises stress in the sagbend', unit: 'Pa', curves: [result('sagbend', 'sagbend_von_mises')] },
  { title: 'Strain', unit: '%', curves: [result('sagbend', 'sagbend_strain'), result('overbend', 'overbend_strain')] },
  { title: 'Clearance at the stinger tip', unit: 'm', curves: [result('tip', 'stinger_tip_clearance')] },
  { title: 'Largest roller load', unit: 'N', curves: [result('roller', 'largest_reaction')] },
  { title: 'Largest bending moment', unit: 'N m', curves: [result('moment', 'largest_moment')] },
  { title: 'Largest bending stress', unit: 'Pa', curves: [result('bending stress', 'largest_bending_stress')] },
  { title: 'Cable tension over breaking load', unit: '%', curves: [result('cable', 'cable_utilisation')] },
  { title: 'Vessel ahead', unit: 'm', curves: [{ name: 'vessel', value: (stage) => (stage.values && operation.stages.some((s) => Math.abs(s.barge_ahead) > 5e-3) ? stage.barge_ahead : null) }] },
];

/** Curves that carry information; the cable tension is left out if it is the top tension. */
function lines({ curves, unit }: Spec, stages: OperationStage[]): Line[] {
  const factor = unit === '%' ? 100 : unit === '' ? 1 : display(unit)[1];
  const shown = curves.filter((curve) => stages.some((stage) => curve.value(stage) !== null))
    .filter(({ value }, k, all) => k === 0 || stages.some((stage) => Math.abs((value(stage) ?? 0) - (all[0]!.value(stage) ?? 0)) > 1e-3 * Math.abs(value(stage) ?? 0)));
  return shown.map(({ name, value }, k) => ({ name, colour: palette[k % palette.length]!, width: 2, values: stages.map((stage) => { const v = value(stage); return v === null ? null : v * factor; }) }));
}

export interface StageCharts {
  charts: ChartData[];
  /** Index of the stage of every x. */
  stages: number[];
  /** x of every stage. */
  x: number[];
}

export function stageCharts(operation: Operation): StageCharts {
  const byOut = operation.stages.every((stage) => stage.out !== null), [unit, factor] = display('m');
  const x = operation.stages.map((stage, i) => (byOut ? stage.out! * factor : i + 1));
  const order = [...x.keys()].sort((a, b) => x[a]! - x[b]! || a - b), sorted = order.map((i) => operation.stages[i]!);
  const xName = byOut ? `${operation.out_name.toLowerCase()} [${unit}]` : 'stage';
  const charts = specs(operation).map((spec): ChartData => ({
    title: spec.title, xName, yName: `${spec.title.toLowerCase().replace('von mises', 'von Mises')}${spec.unit ? ` [${spec.unit === '%' ? '%' : unitName(spec.unit)}]` : ''}`,
    x: order.map((i) => x[i]!), s: order, lines: lines(spec, sorted), marks: [], level: spec.level ?? [],
  })).filter((chart) => chart.lines.length > 0);
  return { charts, stages: order, x };
}
