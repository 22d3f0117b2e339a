// Charts over the roller rows, box by box: reactions and separations.
import type { VNode } from 'preact';
import { Chart } from '../../components/Chart';
import type { Axis, Bar, ChartProps, Frame, LegendEntry } from '../../components/chart/types';
import { colours } from '../../components/colours';
import { shortened, useUnits } from '../../components/units';
import type { Position, RollerData, SupportData } from '../../components/lay';
import type { PipeData } from '../data';
import type { DrawFigure } from '../figures';

export const positions: { name: Position; colour: string }[] = [
  { name: 'bottom', colour: colours.pipe },
  { name: 'port', colour: colours.port },
  { name: 'starboard', colour: colours.third },
];

const kGap = 0.8;  // between boxes
export const kHalfBar = 0.36;

/** Positions on the axis: of every row, and the ends of each box. */
export interface Slots {
  rows: { box: number; row: number; value: number }[];
  boxes: { name: string; from: number; to: number }[];
  end: number;
}

export function makeSlots(supports: readonly { name: string; rows: readonly unknown[] }[]): Slots {
  const slots: Slots = { rows: [], boxes: [], end: 0 };
  let value = 0.5;
  supports.forEach(({ name, rows }, box) => {
    const from = value - 0.5;
    rows.forEach((_, row) => slots.rows.push({ box, row, value: value++ }));
    slots.boxes.push({ name, from, to: value - 0.5 });
    value += kGap;
  });
  slots.end = value - kGap;
  return slots;
}

const kBoxesFromTensioner = 'Roller rows of each box, from the tensioner astern';

/** A chart whose x axis is the slots of the boxes. */
export function BoxChart({ slots, label = kBoxesFromTensioner, ...chart }: Omit<ChartProps, 'x'> & { slots: Slots; label?: string }): VNode {
  const names = slots.boxes.map(({ name, from, to }) => ({ value: 0.5 * (from + to), text: name, short: shortened(name) }));
  const zero = { value: 0, colour: '#41505e', width: 1 };
  return (
    <Chart
      {...chart}
      x={{ range: [-0.2, slots.end + 0.2], label, names }}
      bands={slots.boxes.map(({ from, to }) => ({ x: [from, to] }))}
      levels={[...(chart.levels ?? []), zero]}
    />
  );
}

export const roundBar = (value: number, low: number, high: number): Pick<Bar, 'x' | 'y'> => ({ x: [value - kHalfBar, value + kHalfBar], y: [low, high] });

/** A cross just above a level. */
export function Cross({ frame, x, colour, title, y = 0 }: { frame: Frame; x: number; colour: string; title?: string; y?: number }): VNode {
  return (
    <text text-anchor="middle" x={frame.x(x)} y={frame.y(y) - 3} style={{ fontSize: '15px', fill: colour }}>
      {'\u00d7'}
      {title && <title>{title}</title>}
    </text>
  );
}

const rollerAt = (supports: readonly SupportData[], box: number, row: number, position: Position) =>
  supports[box]!.rows[row]!.rollers.find((roller) => roller.position === position);

export const Reactions: DrawFigure = ({ data }) => {
  const units = useUnits();
  const { supports } = data as PipeData;
  const slots = makeSlots(supports);
  const bars: Bar[] = [];
  let largest = { reaction: 0, x: 0, top: 0, name: '' };
  let max = 0;
  for (const { box, row, value } of slots.rows) {
    let below = 0;
    for (const { name, colour } of positions) {
      const reaction = rollerAt(supports, box, row, name)?.reaction ?? 0;
      if (reaction <= 0) continue;
      bars.push({ ...roundBar(value, below, below + reaction), colour, title: `${supports[box]!.name}, ${name}: ${units.shown(reaction, 'N', 2)}` });
      below += reaction;
      if (reaction > largest.reaction) largest = { reaction, x: value, top: below, name: `${supports[box]!.name}, ${name}` };
    }
    max = Math.max(max, below);
  }
  const label = `${units.shown(largest.reaction, 'N', 1)} (${largest.name})`;
  const present = new Set(supports.flatMap((box) => box.rows.flatMap((row) => row.rollers.map((roller) => roller.position))));
  return (
    <BoxChart
      slots={slots}
      height={330}
      title="Normal reactions"
      y={{ range: [0, 1.12 * (max || 1)], label: 'Reaction', si: 'N' }}
      bars={bars}
      legend={positions.filter(({ name }) => present.has(name)).map(({ name, colour }) => ({ text: name, colour, look: 'block' }))}
      points={largest.reaction > 0 ? [{ x: largest.x, y: largest.top, colour: colours.pipe, label }] : []}
    />
  );
};

interface Separation { roller: RollerData; box: string; x: number; part: number; colour: string }

/** Rollers of some positions with their slots; side by side within a row. */
function separations(supports: readonly SupportData[], slots: Slots, shown: typeof positions): Separation[] {
  return slots.rows.flatMap(({ box, row, value }) => shown.flatMap(({ name, colour }, part) => {
    const roller = rollerAt(supports, box, row, name);
    return roller ? [{ roller, box: supports[box]!.name, x: value - kHalfBar + (part * 2 * kHalfBar) / shown.length, part, colour }] : [];
  }));
}

/** Beyond the end of a roller and behind it the separation of the pipe has no meaning: a cross is drawn. */
function SeparationChart({ supports, title, shown }: { supports: SupportData[]; title: string; shown: typeof positions }) {
  const units = useUnits();
  const slots = makeSlots(supports);
  const all = separations(supports, slots, shown);
  if (all.length === 0) return null;
  const width = (2 * kHalfBar) / shown.length;
  const near = all.filter(({ roller }) => !roller.passed);
  const passed = all.filter(({ roller }) => roller.passed);
  const values = near.map(({ roller }) => roller.separation);
  const [lo, hi] = [Math.min(0, ...values), Math.max(0, ...values)];
  const room = 0.12 * (hi - lo || 1e-3);
  const away = 'the pipe is beyond the end of the roller';
  const least = near.find(({ roller }) => roller.separation === Math.min(...values));
  // In the title: a label would not fit among so many bars.
  const smallest = least
    ? `${units.shown(least.roller.separation, 'section', 2)} at ${least.box}, ${least.roller.position}`
    : 'none, the pipe is outside the rollers';
  const text = ({ box, roller }: Separation, what: string) => `${box}, ${roller.position}: ${what}`;
  const legend: LegendEntry[] = shown.length > 1 ? shown.map(({ name, colour }) => ({ text: name, colour, look: 'block' })) : [];
  const y: Axis = { range: [lo < 0 ? lo - room : 0, hi + room], label: 'Separation', si: 'section' };
  return (
    <BoxChart
      slots={slots}
      title={`${title}; smallest ${smallest}`}
      y={y}
      bars={near.map((item) => ({
        x: [item.x, item.x + width],
        y: [Math.min(item.roller.separation, 0), Math.max(item.roller.separation, 0)],
        colour: item.colour,
        title: text(item, units.shown(item.roller.separation, 'section', 2)),
      }))}
      legend={legend}
    >
      {(frame) => passed.length > 0 && (
        <g>
          {passed.map((item) => <Cross frame={frame} x={item.x + width / 2} colour={item.colour} title={text(item, away)} />)}
          <text class="soft" x={frame.left + 8} y={frame.top + 16}>{`\u00d7  ${away}`}</text>
        </g>
      )}
    </BoxChart>
  );
}

/** Bottom rollers; side rollers, whose gap is of a different magnitude, in a separate chart. */
export const Separations: DrawFigure = ({ data }) => {
  const { supports } = data as PipeData;
  return (
    <>
      <SeparationChart supports={supports} title="Bottom rollers" shown={positions.slice(0, 1)} />
      <SeparationChart supports={supports} title="Side rollers" shown={positions.slice(1)} />
    </>
  );
};
