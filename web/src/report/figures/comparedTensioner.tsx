// Tensioner modes off, controlled and constant: histories of tension and travel in one diagram.
import type { VNode } from 'preact';
import { Chart } from '../../components/Chart';
import { extent } from '../../components/chart/scale';
import type { Area, Curve, CurvePoint, Frame, LegendEntry, Level } from '../../components/chart/types';
import { colours } from '../../components/colours';
import { fixed, useUnits } from '../../components/units';
import type { ComparedTensioner, ComparedTensionerRun } from '../data';
import type { FigureProps } from '../figures';
import { buildUpMarks, rangeBand, timeLabel, timeScale, traceArea, traceRange, traceTime, type TimeScale } from './inTime';

type Quantity = 'tension' | 'travel';

const looks: Record<ComparedTensionerRun['name'], { colour: string; width: number; dash?: string }> = {
  off: { colour: '#d08a2e', width: 1.6 },
  controlled: { colour: colours.pipe, width: 1.8 },
  constant: { colour: colours.ink, width: 1.1, dash: '5 3' },
};

/** In the order of their indices in the data. */
const states = [
  { text: 'holds', colour: '#dfe5ea' },
  { text: 'delay', colour: '#f0c24b' },
  { text: 'pays out', colour: '#3c9d6b' },
  { text: 'hauls in', colour: '#8a5bb0' },
  { text: 'at limit', colour: colours.accent },
];

const stripHeight = 14; // px
const height = 380;

function valueRange({ runs, range }: ComparedTensioner, quantity: Quantity, close: boolean): [number, number] {
  const values = runs.flatMap((run) => (close ? extent(run.close[quantity]) : traceRange(run[quantity])));
  const others = quantity === 'travel' ? [0] : range ?? [];
  return extent([...values, ...others]);
}

/** Stretches of a trace are drawn as areas, except those of dashed curves. */
function runAreas(runs: ComparedTensionerRun[], quantity: Quantity, scale: TimeScale): Area[] {
  return runs.filter(({ name }) => !looks[name].dash)
    .map((run) => traceArea(run[quantity], scale, { line: looks[run.name].colour, area: looks[run.name].colour }));
}

function middlePoints(run: ComparedTensionerRun, quantity: Quantity, scale: TimeScale): CurvePoint[] {
  const trace = run[quantity];
  const time = traceTime(scale, trace);
  return trace.low.map((low, k) => [time(k), low === null ? null : trace.lowest + trace.quantum * 0.5 * (low + trace.high[k]!)]);
}

function runCurves(runs: ComparedTensionerRun[], quantity: Quantity, scale: TimeScale, close: boolean): Curve[] {
  const drawn = runs.filter(({ name }) => close || looks[name].dash);
  return drawn.map((run) => ({
    ...looks[run.name],
    points: close ? run.close.time.map((t, k): CurvePoint => [t / scale.seconds, run.close[quantity][k]!]) : middlePoints(run, quantity, scale),
  }));
}

type Span = ComparedTensionerRun['states'][number];

/** States of the controlled tensioner, below the curves. */
function StateStrip({ frame, spans, seconds }: { frame: Frame; spans: Span[]; seconds: number }): VNode {
  const top = frame.bottom - stripHeight;
  const place = (time: number): number => Math.min(Math.max(frame.x(time / seconds), frame.left), frame.right);
  return (
    <g>
      {spans.map(([from, to, state]) => (
        <rect x={place(from)} y={top} width={place(to) - place(from)} height={stripHeight} fill={states[state]!.colour}>
          <title>{`${states[state]!.text}: ${fixed(from, 1)} to ${fixed(to, 1)} s`}</title>
        </rect>
      ))}
      <line x1={frame.left} x2={frame.right} y1={top} y2={top} stroke={colours.zero} />
    </g>
  );
}

export function ComparedTensionerChart({ part, data }: FigureProps): VNode {
  const units = useUnits();
  const { comparison } = data as { comparison: ComparedTensioner };
  const { build_up: buildUp, duration, close_from: closeFrom, range, limit, runs } = comparison;
  const [quantity, view] = part.split('_') as [Quantity, string];
  const close = view === 'close';
  const scale = timeScale(buildUp, duration);
  const first = close ? closeFrom : -buildUp;
  const [lo, hi] = valueRange(comparison, quantity, close);
  const room = 0.07 * (hi - lo || 1);
  const below = room + (hi - lo + 2 * room) * stripHeight / (height - 130); // room for the strip
  const limits = quantity === 'travel' && limit ? [-limit, limit].filter((end) => end > lo - below && end < hi + room) : [];
  const bounds = quantity === 'tension' ? range ?? [] : [];
  const levels: Level[] = [
    ...bounds.map((value) => ({ value, colour: '#5fa37f', width: 0.9 })),
    ...limits.map((value) => ({ value, colour: colours.accent, dash: '2 3', width: 1.2 })),
  ];
  const legend: LegendEntry[] = runs.map(({ name }) => ({ text: name, ...looks[name] }));
  if (bounds.length > 0) legend.push({ text: 'operational range', colour: '#cfe8cf', look: 'block', edge: '#5fa37f' });
  if (limits.length > 0) legend.push({ text: 'limit', colour: colours.accent, dash: '2 3' });
  const spans = (runs.find(({ name }) => name === 'controlled')?.states ?? []).filter(([from, to]) => to > first && from < duration);
  const shown = states.filter((_, state) => spans.some((span) => span[2] === state));
  const { bands, verticals } = buildUpMarks(scale);
  const limitText = quantity === 'travel' && limit ? `; limit ${fixed(limit, 2)} ${units.unit('m').name} either way` : '';
  return (
    <Chart
      title={(close ? `From ${fixed(closeFrom, 0)} s to the end` : 'Whole run') + limitText}
      height={height}
      x={{ label: timeLabel(scale), range: [first / scale.seconds, duration / scale.seconds] }}
      y={{
        label: quantity === 'tension' ? `Tension [${units.unit('N').name}]` : `Travel, positive when paid out [${units.unit('m').name}]`,
        range: [lo - below, hi + room],
      }}
      bands={[...(close ? [] : bands), ...(quantity === 'tension' && range ? [rangeBand(range)] : [])]}
      verticals={close ? [] : verticals}
      levels={levels}
      areas={close ? [] : runAreas(runs, quantity, scale)}
      curves={runCurves(runs, quantity, scale, close)}
      legend={legend}
      secondLegend={spans.length === 0 ? undefined : {
        title: 'Strip below: state of the controlled tensioner',
        entries: shown.map((state) => ({ ...state, look: 'block' as const, edge: colours.zero })),
      }}
    >
      {(frame) => <StateStrip frame={frame} spans={spans} seconds={scale.seconds} />}
    </Chart>
  );
}
