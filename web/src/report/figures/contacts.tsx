// Rollers over time: fraction of time in contact, reactions, and impacts.
import type { VNode } from 'preact';
import { Chart } from '../../components/Chart';
import { colours } from '../../components/colours';
import { fixed, useUnits } from '../../components/units';
import type { Position } from '../../components/lay';
import type { DynamicRollerData, ImpactData, PipeData } from '../data';
import type { DrawFigure } from '../figures';
import { BoxChart, Cross, kHalfBar, positions, roundBar, makeSlots, type Slots } from './boxes';

interface Seen { box: string; x: number; roller: DynamicRollerData }

type PositionLook = (typeof positions)[number];

const upperFirst = (text: string) => text[0]!.toUpperCase() + text.slice(1);

/** A chart for every position with rollers. */
function chartsByPosition(pipe: PipeData, draw: (look: PositionLook, slots: Slots, seen: Seen[]) => VNode | null): VNode {
  const { supports, dynamic } = pipe;
  const slots = makeSlots(supports);
  const seenAt = (position: Position) => slots.rows.flatMap(({ box, row, value }) => {
    const roller = dynamic!.supports[box]?.rows[row]?.[position];
    return roller ? [{ box: supports[box]!.name, x: value, roller }] : [];
  });
  const draws = (look: PositionLook) => {
    const seen = seenAt(look.name);
    return seen.length > 0 ? draw(look, slots, seen) : null;
  };
  return <>{positions.map(draws)}</>;
}

/** Fraction of the time in which each roller carries. */
export const Shares: DrawFigure = ({ data }) => chartsByPosition(data as PipeData, (look, slots, seen) => (
  <BoxChart
    slots={slots}
    height={218}
    title={`${upperFirst(look.name)} rollers`}
    y={{ range: [0, 118], label: '% of time', ticks: [0, 25, 50, 75, 100] }}
    bars={seen.flatMap(({ box, x, roller }) => {
      const share = 100 * roller.contact_share;
      const title = `${box}: ${fixed(share, 1)} % of time in contact, ${roller.impact_count} impacts`;
      return [{ ...roundBar(x, 0, 100), colour: '#fff', edge: '#d5dce3', title }, { ...roundBar(x, 0, share), colour: look.colour, title }];
    })}
    points={seen.filter(({ roller }) => roller.static_reaction > 0).map(({ x }) => ({ x, y: 109, colour: colours.ink, radius: 3.6 }))}
    legend={[
      { text: 'fraction of time in contact', colour: look.colour, look: 'block' },
      { text: 'in contact in the static state', colour: colours.ink, look: 'dot' },
    ]}
  >
    {(frame) => seen.filter(({ roller }) => roller.contact_share <= 0).map(({ x }) => <Cross frame={frame} x={x} colour={colours.accent} />)}
  </BoxChart>
));

export const Ranges: DrawFigure = ({ data }) => {
  const units = useUnits();
  return chartsByPosition(data as PipeData, (look, slots, all) => {
    const seen = all.filter(({ roller }) => roller.reaction.max > 0 || roller.static_reaction > 0);
    if (seen.length === 0) return null;
    const max = Math.max(...seen.map(({ roller }) => Math.max(roller.reaction.max, roller.static_reaction)));
    const largest = seen.reduce((best, item) => (item.roller.reaction.max > best.roller.reaction.max ? item : best));
    const title = ({ box, roller: { reaction, static_reaction: before } }: Seen) => `${box}, ${look.name}: ${units.number(reaction.min, 'N', 1)} to `
      + `${units.shown(reaction.max, 'N', 1)}, mean ${units.shown(reaction.mean, 'N', 1)}, static ${units.shown(before, 'N', 1)}`;
    const side = (x: number, sign: number) => x + sign * kHalfBar;
    const peak = largest.roller.reaction.max;
    return (
      <BoxChart
        slots={slots}
        height={250}
        title={`${upperFirst(look.name)} rollers`}
        y={{ range: [0, 1.15 * max], label: 'Reaction', si: 'N' }}
        bars={seen.map((item) => ({
          ...roundBar(item.x, item.roller.reaction.min, item.roller.reaction.max), colour: colours.band, edge: colours.dynamic, title: title(item),
        }))}
        curves={seen.map(({ x, roller: { reaction } }) => ({
          points: [[side(x, -1), reaction.mean], [side(x, 1), reaction.mean]], colour: colours.second, covered: true,
        }))}
        points={[
          ...seen.filter(({ roller }) => roller.static_reaction > 0).map(({ x, roller }) => ({ x, y: roller.static_reaction, colour: colours.pipe })),
          { x: largest.x, y: peak, colour: colours.dynamic, label: `${units.shown(peak, 'N', 1)} (${largest.box})` },
        ]}
        legend={[
          { text: 'min to max', colour: colours.band, look: 'block', edge: colours.dynamic },
          { text: 'mean', colour: colours.second },
          { text: 'static', colour: colours.pipe, look: 'dot' },
        ]}
      />
    );
  });
};

const positionColour = (name: Position) => positions.find((look) => look.name === name)!.colour;

export const Impacts: DrawFigure = ({ part, data }) => {
  const units = useUnits();
  const { impacts, duration } = (data as PipeData).dynamic!;
  if (impacts.length === 0) return null;
  const overTime = part === 'time';
  const across = (hit: ImpactData) => (overTime ? hit.time : hit.approach_velocity);
  const last = Math.max(...impacts.map(across));
  const title = (hit: ImpactData) => `${hit.box}, row ${hit.row}, ${hit.position}: ${units.shown(hit.peak_force, 'N', 1)} `
    + `at ${units.shown(hit.approach_velocity, 'm/s', 3)}, t = ${fixed(hit.time, 1)} s`;
  const hardest = impacts[0]!;
  const hits = impacts.length > 1 ? `${impacts.length} hardest impacts` : 'hardest impact';
  // The hardest on top.
  const points = impacts.map((hit) => (
    { x: across(hit), y: hit.peak_force, colour: positionColour(hit.position), radius: 3.6, opacity: 0.7, title: title(hit) })).reverse();
  const label = `${units.shown(hardest.peak_force, 'N', 1)} (${hardest.box}, row ${hardest.row})`;
  return (
    <Chart
      height={290}
      title={`Peak force of the ${hits}, ${overTime ? 'over time' : 'against the velocity of approach'}`}
      x={overTime
        ? { range: [0, Math.max(duration, last)], label: 'Time from the end of the build-up [s]' }
        : { range: [0, 1.08 * last || 1], label: 'Normal velocity at first contact', si: 'm/s' }}
      y={{ range: [0, 1.14 * hardest.peak_force], label: 'Peak force', si: 'N' }}
      points={[...points, { x: across(hardest), y: hardest.peak_force, colour: positionColour(hardest.position), label, title: title(hardest) }]}
      legend={positions.filter(({ name }) => impacts.some((hit) => hit.position === name)).map(({ name, colour }) => ({ text: name, colour, look: 'dot' }))}
    />
  );
};
