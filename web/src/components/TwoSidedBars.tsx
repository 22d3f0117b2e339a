// Bars on both sides of a line: the effect of several keys on a result.
import { Chart } from './Chart';
import { colours } from './colours';
import { nameEnd } from './keyAxis';

export interface SideBar { name: string; low: number; high: number; title: string }

const kRow = 24;

export interface TwoSidedBarsProps {
  title: string;
  label: string;
  bars: SideBar[];
  middle: number;
  range: [number, number];
  width?: number;
  lowColour?: string;
  highColour?: string;
}

/** Bars on both sides of a line, in the order of the list from the top. */
export function TwoSidedBars(props: TwoSidedBarsProps) {
  const { title, label, bars, middle, range, width, lowColour = colours.second, highColour = colours.pipe } = props;
  const rowMiddle = (row: number): number => bars.length - row - 0.5;
  const rowRange = (row: number): [number, number] => [rowMiddle(row) - 0.33, rowMiddle(row) + 0.33];
  return (
    <Chart
      small title={title} width={width} height={84 + kRow * bars.length} x={{ range, label, ticks: 5 }}
      y={{ range: [0, bars.length], names: bars.map((bar, row) => ({ value: rowMiddle(row), text: nameEnd(bar.name, 26) })) }}
      bars={bars.flatMap(({ low, high }, row) => [
        { x: [low, middle] as const, y: rowRange(row), colour: lowColour },
        { x: [middle, high] as const, y: rowRange(row), colour: highColour },
      ])}
      verticals={[{ x: middle, colour: colours.zero, dash: 'none' }]}
    >
      {(frame) => bars.map((bar, row) => (
        <rect y={frame.y(rowMiddle(row) + 0.5)} width={frame.right} height={frame.y(0) - frame.y(1)} fill="none" pointer-events="all">
          <title>{bar.title}</title>
        </rect>
      ))}
    </Chart>
  );
}
