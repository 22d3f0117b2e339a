// Results over the stages of an operation. The highlighted stage is shared with the figure of the lines.
import type { VNode } from 'preact';
import { Chart } from '../../components/Chart';
import type { Pixel } from '../../components/chart/labels';
import { extent, type Range } from '../../components/chart/scale';
import type { Frame } from '../../components/chart/types';
import { colours } from '../../components/colours';
import { useHighlighted } from '../../components/highlight';
import { fixed } from '../../components/units';
import type { StageCurve, StagesData } from '../data';
import type { FigureProps } from '../figures';
import { stageHighlight, stageColour, readStages } from './stageList';

/** Positions of the stages on the x axis: the progress if it is monotonic, otherwise their indices. */
function stageAxis({ list, out }: StagesData) {
  const progress = list.map((stage) => stage.out);
  const changes = (sign: number): boolean => progress.every((value, i) => value !== null && (i === 0 || sign * (value - progress[i - 1]!) > 0));
  const byProgress = list.length > 1 && (changes(1) || changes(-1));
  const values = byProgress ? (progress as number[]) : list.map((_, i) => i + 1);
  const [first, last] = extent(values);
  const side = 0.03 * (last - first || 1);
  const step = Math.max(1, Math.ceil(list.length / 7));
  const numbers = values.filter((value) => value % step === 0 || step === 1);
  const range: Range = [first - side, last + side];
  return { values, axis: byProgress ? { label: out, si: 'm', range } : { label: 'Stage', ticks: numbers, range } };
}

/** A limit is shown if values come near it. */
function limitShown({ limit }: StageCurve, lo: number, hi: number): number | null {
  const near = (value: number): number => 3 * Math.max(hi - lo, 0.1 * Math.abs(value));
  return limit !== null && limit < hi + near(hi) && limit > lo - near(lo) ? limit : null;
}

interface KnownPoint { index: number; x: number; value: number }

function StagePoints({ frame, stages, points, digits }: { frame: Frame; stages: StagesData; points: KnownPoint[]; digits: number }): VNode {
  const current = useHighlighted(stageHighlight(stages));
  const shown = points.find(({ index }) => index === current);
  return (
    <g>
      {points.map(({ index, x, value }) => (
        <circle
          key={index}
          cx={frame.x(x)}
          cy={frame.y(value)}
          r={index === current ? 5.5 : 3.4}
          fill={stageColour(stages, index)}
          stroke="#fff"
          stroke-width="0.7"
        />
      ))}
      {shown && (
        <text
          class="halo mark"
          text-anchor="middle"
          x={Math.min(Math.max(frame.x(shown.x), frame.left + 26), frame.right - 26)}
          y={Math.max(frame.y(shown.value) - 9, frame.top + 10)}
        >
          {fixed(shown.value, digits)}
        </text>
      )}
    </g>
  );
}

function StageCurveChart({ stages, curve }: { stages: StagesData; curve: StageCurve }): VNode {
  const highlight = stageHighlight(stages);
  const { values, axis } = stageAxis(stages);
  const points = values.flatMap((x, index): KnownPoint[] => (curve.values[index] === null ? [] : [{ index, x, value: curve.values[index]! }]));
  let [lo, hi] = extent(curve.values);
  const limit = limitShown(curve, lo, hi);
  if (limit !== null) [lo, hi] = [Math.min(lo, limit), Math.max(hi, limit)];
  const room = 0.1 * (hi - lo);
  const onPointer = (pixel: Pixel | null, frame: Frame): void => {
    const away = ({ x }: KnownPoint): number => Math.abs(frame.x(x) - pixel![0]);
    highlight.point(pixel ? points.reduce((best, point) => (away(point) < away(best) ? point : best)).index : null);
  };
  return (
    <Chart
      small
      height={220}
      title={`${curve.name}${curve.unit ? ` [${curve.unit}]` : ''}`}
      x={axis}
      y={{ digits: curve.digits, range: [lo - room, hi + 1.6 * room] }}
      levels={limit === null ? [] : [{ value: limit, colour: colours.accent, dash: '8 4' }]}
      curves={[{ points: values.map((x, i) => [x, curve.values[i]!] as const), colour: '#9aa6b1', width: 1.5 }]}
      onPointer={onPointer}
    >
      {(frame) => <StagePoints frame={frame} stages={stages} points={points} digits={curve.digits} />}
    </Chart>
  );
}

export function StageCurves({ data }: FigureProps): VNode {
  const stages = readStages(data);
  return <>{stages.curves.map((curve) => <StageCurveChart key={curve.key} stages={stages} curve={curve} />)}</>;
}
