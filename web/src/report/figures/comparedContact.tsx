// Rollers against gap springs, resolved against captured impacts: bars side by side, box by box.
import type { VNode } from 'preact';
import type { Frame, LegendEntry, Point } from '../../components/chart/types';
import type { SupportData } from '../../components/lay';
import { colours } from '../../components/colours';
import { fixed } from '../../components/units';
import type { ComparedBoxRun, ComparedContact, ComparedQuantity } from '../data';
import type { FigureProps } from '../figures';
import { BoxChart, Cross, makeSlots } from './boxes';

const looks = [{ colour: colours.pipe, rows: '#9fc3e6' }, { colour: colours.second, rows: null }];

interface Kind {
  key: ComparedQuantity;
  title: string;
  axis: string;
  /** Values of the rows, shown on the bars of the first run. */
  rows?: 'row_contact_share' | 'row_peak_force';
  /** The static reaction is marked. */
  before?: boolean;
  /** Range of the axis, if not that of the values. */
  top?: number;
  ticks?: number[];
}

const kinds: Record<string, Kind> = {
  share: { key: 'contact_share', title: 'Fraction of time in contact', axis: '% of time', rows: 'row_contact_share', top: 110, ticks: [0, 25, 50, 75, 100] },
  peak: { key: 'peak_reaction', title: 'Peak reaction', axis: 'Peak reaction', rows: 'row_peak_force', before: true },
  dent: { key: 'dent_depth', title: 'Dent depth of bare steel under the largest force', axis: 'Dent depth' },
  load: { key: 'line_load', title: 'Line load on the coating under the largest force', axis: 'Line load' },
};

/** The bar of a run within its box: values as shown. */
interface RunBar { x: [number, number]; value: number; before: number; rows: number[]; look: (typeof looks)[number]; title: string }

function runBars({ boxes, runs, shown }: ComparedContact, supports: SupportData[], kind: Kind): RunBar[] {
  const { unit, factor, digits } = shown[kind.key];
  return makeSlots(supports).boxes.flatMap(({ from, to }, b) => {
    const box = boxes[b]!;
    const width = (to - from - 0.2) / box.runs.length;
    return box.runs.map((run: ComparedBoxRun, k): RunBar => {
      const first = from + 0.1 + k * width;
      const value = run[kind.key] * factor;
      return {
        x: [first, first + 0.94 * width],
        value,
        before: run.static_reaction * factor,
        rows: (kind.rows ? run[kind.rows] : []).map((row) => row * factor),
        look: looks[k]!,
        title: `${box.name}, ${runs[k]!.name}: ${fixed(value, digits)} ${unit}`,
      };
    });
  });
}

/** The value of each row, on the bar of its box; a single row has the value of the bar. */
function rowPoints({ x: [x0, x1], rows, look }: RunBar): Point[] {
  if (rows.length < 2 || !look.rows) return [];
  return rows.map((value, k) => ({ x: x0 + (k + 0.5) * (x1 - x0) / rows.length, y: value, radius: 3.4, colour: look.rows!, edge: '#12395f' }));
}

function BarMarks({ frame, bars, before }: { frame: Frame; bars: RunBar[]; before: boolean }): VNode {
  return (
    <g>
      {before && bars.filter((bar) => bar.before > 0).map(({ x, before: value }) => (
        <line x1={frame.x(x[0])} x2={frame.x(x[1])} y1={frame.y(value)} y2={frame.y(value)} stroke="#fff" stroke-width="2" />
      ))}
      {bars.filter(({ value }) => value <= 0).map(({ x, look }) => <Cross frame={frame} x={0.5 * (x[0] + x[1])} colour={look.colour} />)}
    </g>
  );
}

export function ComparedContactChart({ part, data }: FigureProps): VNode {
  const { comparison, supports } = data as { comparison: ComparedContact; supports: SupportData[] };
  const kind = kinds[part]!;
  const bars = runBars(comparison, supports, kind);
  const legend: LegendEntry[] = comparison.runs.map((run, k) => ({ text: run.words, colour: looks[k]!.colour, look: 'block' }));
  const points = bars.flatMap(rowPoints);
  if (points.length > 0) legend.push({ text: 'bottom roller of each row', colour: looks[0]!.rows!, look: 'dot' });
  const top = kind.top ?? 1.14 * (Math.max(...bars.map(({ value }) => value)) || 1);
  return (
    <BoxChart
      slots={makeSlots(supports)}
      label="Support boxes, from the tensioner astern"
      title={kind.title}
      y={{ label: kind.top ? kind.axis : `${kind.axis} [${comparison.shown[kind.key].unit}]`, range: [0, top], ticks: kind.ticks }}
      bars={bars.map(({ x, value, look, title }) => ({ x, y: [0, Math.max(value, 0)], colour: look.colour, title }))}
      points={points}
      legend={legend}
    >
      {(frame) => <BarMarks frame={frame} bars={bars} before={kind.before ?? false} />}
    </BoxChart>
  );
}
