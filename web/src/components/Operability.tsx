// Operability: the limit over a key, by direction, and the workable time by month.
import { Chart } from './Chart';
import type { Point } from './chart/types';
import { colours, curveLook } from './colours';
import { axisPlaces, keyAxis, type KeyAxis } from './keyAxis';
import { Rose } from './Rose';
import { fixed } from './units';

export interface LimitData { at: number[]; limit: number | null; beyond: boolean; decided: boolean; governing: string }

/** Largest passing value of a key, for every combination of the others. */
export interface OperabilityData {
  over: string;
  least: number | null;
  largest: number;
  alpha: number | null;
  axes: KeyAxis[];
  cells: LimitData[];
  /** Workable time [%]. */
  months?: number[];
  year?: number;
}

/** "hs" from "hs [m]". */
const axisTitle = (axis: KeyAxis): string => axis.name.replace(/ \[.*/, '');

const kMonths = ['Jan', 'Feb', 'Mar', 'Apr', 'May', 'Jun', 'Jul', 'Aug', 'Sep', 'Oct', 'Nov', 'Dec'];

/** Index of the axis of directions, -1 if there is none. */
export const headingAxis = (all: OperabilityData): number => all.axes.findIndex((axis) => axis.name.endsWith('[deg]') && axis.words.length > 2);

/** Axis of the chart: the numeric axis (other than a direction) with the most values, otherwise the first. */
export function chartAxis(all: OperabilityData): number {
  const heading = headingAxis(all);
  const count = (axis: number): number => all.axes[axis]!.words.length;
  const numeric = all.axes.map((_, axis) => axis).filter((axis) => axis !== heading && axisPlaces(all.axes[axis]!).numeric);
  return numeric.sort((a, b) => count(b) - count(a))[0] ?? 0;
}

/** Value at which a cell is drawn; null if not even the smallest value passes. */
const shownLimit = (all: OperabilityData, cell: LimitData): number | null => (cell.beyond ? all.largest : cell.limit);

const cellLabel = (all: OperabilityData, cell: LimitData, without = -1): string =>
  all.axes.flatMap((axis, i) => (i === without ? [] : [`${axisTitle(axis)} ${axis.words[cell.at[i]!]}`])).join(', ');

function describeCell(all: OperabilityData, cell: LimitData): string {
  const limit = !cell.decided ? 'undetermined' : cell.beyond ? `over ${all.largest}` : cell.limit === null ? `below ${all.least}` : String(cell.limit);
  return [cellLabel(all, cell), limit, ...(cell.governing ? [`governing above: ${cell.governing}`] : [])].join('\n');
}

/** Cells that differ by this axis only, with the style of their curve. */
function linesAlong(all: OperabilityData, axis: number): { name: string; cells: LimitData[]; colour: string; dash?: string }[] {
  const lines = new Map<string, LimitData[]>();
  for (const cell of all.cells) {
    const name = cellLabel(all, cell, axis);
    lines.set(name, [...(lines.get(name) ?? []), cell]);
  }
  return [...lines].map(([name, cells], k) => ({ name: name || all.over, cells, ...curveLook(k) }));
}

export function OperabilityChart({ all }: { all: OperabilityData }) {
  const axis = chartAxis(all);
  const { places } = axisPlaces(all.axes[axis]!);
  const findX = (cell: LimitData): number => places[cell.at[axis]!]!;
  const point = (cell: LimitData, colour: string): Point => {
    const limit = cell.decided ? shownLimit(all, cell) : null;
    const shape = limit === null ? 'cross' : cell.beyond ? 'triangle' : 'circle';
    return { x: findX(cell), y: limit ?? 0.025 * all.largest, radius: 3.6, shape, colour, title: describeCell(all, cell) };
  };
  const lines = linesAlong(all, axis);
  return (
    <>
      <Chart
        height={380} x={keyAxis(all.axes[axis]!)} y={{ range: [0, 1.06 * all.largest], label: all.over }}
        levels={[{ value: all.largest, colour: colours.steel, dash: '3 3' }]}
        curves={lines.map(({ cells, colour, dash }) => ({
          colour, dash,
          points: cells.filter((cell) => cell.decided && shownLimit(all, cell) !== null).sort((a, b) => findX(a) - findX(b))
            .map((cell) => [findX(cell), shownLimit(all, cell)]),
        }))}
        points={lines.flatMap(({ cells, colour }) => cells.map((cell) => point(cell, colour)))}
        legend={lines.map(({ name, colour, dash }) => ({ text: name, colour, dash }))}
      />
      <p class="small">{'\u25b2 the largest value passes \u2003 \u00d7 the smallest value fails, or undetermined'}</p>
    </>
  );
}

export function OperabilityRose({ all }: { all: OperabilityData }) {
  const heading = headingAxis(all);
  const axis = all.axes[heading]!;
  const degrees = axisPlaces(axis).places;
  return (
    <Rose
      label={`${all.over} by direction`} note={`${axis.name}; ${all.over}`} directions={degrees} largest={all.largest}
      lines={linesAlong(all, heading).map(({ cells, ...look }) => ({
        ...look,
        points: cells.filter((cell) => cell.decided)
          .map((cell) => ({ degrees: degrees[cell.at[heading]!]!, value: shownLimit(all, cell) ?? 0, title: describeCell(all, cell) })),
      }))}
    />
  );
}

export function Workability({ months, year }: { months: number[]; year: number }) {
  return (
    <Chart
      height={300} x={{ range: [0, 12], label: `year: ${fixed(year, 1)} %`, names: kMonths.map((text, i) => ({ value: i + 0.5, text })) }}
      y={{ range: [0, 100], label: 'workable [%]' }}
      bars={months.map((value, i) => ({ x: [i + 0.15, i + 0.85], y: [0, value], colour: colours.pipe }))}
      levels={[{ value: year, colour: colours.accent, dash: '6 4', width: 1.6 }]}
    >
      {(frame) => months.map((value, i) => (
        <text class="halo" text-anchor="middle" x={frame.x(i + 0.5)} y={frame.y(Math.min(value, 94)) - 5}>{fixed(value, 0)}</text>
      ))}
    </Chart>
  );
}
