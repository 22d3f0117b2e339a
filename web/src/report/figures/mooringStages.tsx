// Mooring lines and pipe over the stages of an operation, or over the advance of a pull-ahead.
import type { VNode } from 'preact';
import { Chart } from '../../components/Chart';
import { extent, type Range } from '../../components/chart/scale';
import type { Axis, CurvePoint, Frame } from '../../components/chart/types';
import { colours, curveLook } from '../../components/colours';
import { EndNames } from '../../components/EndNames';
import type { MooringSpread, PipeAtStep, PullAheadStep } from '../../components/mooringSpread';
import { shortened, useUnits } from '../../components/units';
import type { FigureProps } from '../figures';
import { readSpread } from './moorings';

/** A range with some room on both sides; the chart widens that of a constant. */
function withSomeRoom([lo, hi]: Range): Range {
  return [lo - 0.08 * (hi - lo), hi + 0.08 * (hi - lo)];
}

interface LineCurvesProps {
  title: string;
  /** Range over all lines. */
  curves: CurvePoint[][];
  names: string[];
  marks: boolean;
  x: Axis;
  y: { label: string; si: string; digits: number };
}

/** A curve for every line, with names at the right. */
function LineCurves({ title, curves, names, marks, x, y }: LineCurvesProps): VNode {
  const ends = (frame: Frame) => curves.flatMap((points, k) =>
    (points.length > 0 ? [{ text: names[k]!, colour: curveLook(k).colour, y: frame.y(points.at(-1)![1]!) }] : []));
  return (
    <Chart
      title={title}
      right={210}
      x={x}
      y={{ ...y, range: withSomeRoom(extent(curves.flat().map((p) => p[1]))) }}
      curves={curves.map((points, k) => ({ points, ...curveLook(k), width: 1.8, marks: marks ? 3 : undefined }))}
    >
      {(frame) => <EndNames frame={frame} ends={ends(frame)} />}
    </Chart>
  );
}

function StageTensions({ spread: { states } }: { spread: MooringSpread }): VNode {
  const names = states.map((state, i) => ({ value: i, text: i === 0 ? 'at rest' : shortened(state.name, 30) }));
  const curves = states[0]!.lines.map((_, k) => states.flatMap(({ lines }, i): CurvePoint[] => (lines[k]!.parted ? [] : [[i, lines[k]!.tension]])));
  return (
    <LineCurves
      title="Tension at the fairleads"
      curves={curves}
      names={states[0]!.lines.map((line) => line.name)}
      marks
      x={{ range: [-0.25, states.length - 0.75], names }}
      y={{ label: 'Tension at the fairlead', si: 'N', digits: 1 }}
    />
  );
}

const advanceAxis = (steps: PullAheadStep[]) => ({ label: 'Advance of the vessel', si: 'm', range: extent(steps.map((step) => step.advance)) });

function OverAdvance({ spread: { steps, states }, part }: { spread: MooringSpread; part: string }): VNode {
  const tensions = part === 'tensions';
  const lines = states[0]!.lines;
  const value = (step: PullAheadStep, k: number): number => (tensions ? step.tensions[k]! : step.lengths[k]! - steps[0]!.lengths[k]!);
  return (
    <LineCurves
      title={tensions ? 'Tension at the fairleads' : 'Length paid out by the winches'}
      curves={lines.map((_, k) => steps.map((step): CurvePoint => [step.advance, value(step, k)]))}
      names={lines.map((line) => line.name)}
      marks={steps.length < 12}
      x={advanceAxis(steps)}
      y={tensions ? { label: 'Tension at the fairlead', si: 'N', digits: 1 } : { label: 'Length paid out', si: 'm', digits: 3 }}
    />
  );
}

/** Lines stage by stage, or over the advance of a pull-ahead. */
export function MooringStages({ part, data }: FigureProps): VNode {
  const spread = readSpread(data);
  return part === 'stages' ? <StageTensions spread={spread} /> : <OverAdvance spread={spread} part={part} />;
}

const pipeCurves: { key: PipeAtStep; title: string; si: string; digits: number }[] = [
  { key: 'tension', title: 'Tension at the tensioner', si: 'N', digits: 1 },
  { key: 'overbend', title: 'Overbend, largest bending stress', si: 'Pa', digits: 1 },
  { key: 'sagbend', title: 'Sagbend, largest bending stress', si: 'Pa', digits: 1 },
  { key: 'clearance', title: 'Clearance at the stinger tip', si: 'm', digits: 3 },
];

/** The pipe over the advance of a pull-ahead. */
export function MovePipe({ data }: FigureProps): VNode {
  const units = useUnits();
  const { steps } = readSpread(data);
  const known = pipeCurves.filter(({ key }) => steps.every((step) => (step.pipe?.[key] ?? null) !== null));
  return (
    <>
      {known.map(({ key, title, si, digits }) => {
        const points = steps.map((step): CurvePoint => [step.advance, step.pipe![key]]);
        return (
          <Chart
            key={key}
            small
            height={210}
            title={`${title} [${units.unit(si).name}]`}
            x={advanceAxis(steps)}
            y={{ si, digits, range: withSomeRoom(extent(points.map((p) => p[1]))) }}
            curves={[{ points, colour: colours.pipe }]}
          />
        );
      })}
    </>
  );
}
