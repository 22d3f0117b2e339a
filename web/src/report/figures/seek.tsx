// The path of a goal seek: the result over the key, or over the steps for several keys.
import { Chart } from '../../components/Chart';
import { extent, withRoom } from '../../components/chart/scale';
import { colours } from '../../components/colours';
import { significant } from '../../components/units';
import type { SeekData, SeekGoalData } from '../data';
import type { DrawFigure } from '../figures';

/** Solved models, in shown units; over the key they are sorted by it. */
export function pathPoints({ keys, goals, path }: SeekData, goal: SeekGoalData): [number, number][] {
  const place = goals.indexOf(goal);
  if (keys.length > 1) return path.map((step, i) => [i + 1, step.results[place]! * goal.factor]);
  return path.map((step): [number, number] => [step.values[0]! * keys[0]!.factor, step.results[place]! * goal.factor]).sort((a, b) => a[0] - b[0]);
}

function SeekPath({ seek, goal }: { seek: SeekData; goal: SeekGoalData }) {
  const several = seek.keys.length > 1;
  const key = seek.keys[0]!;
  const points = pathPoints(seek, goal);
  const wanted = goal.wanted === null ? null : goal.wanted * goal.factor;
  const reached = goal.reached === null ? null : goal.reached * goal.factor;
  const answer = several ? points.length : key.answer * key.factor;
  const label = several ? `${significant(reached ?? 0, 5)} ${goal.unit}` : `${significant(answer, 6)} ${key.unit}`;
  return (
    <Chart
      title={goal.name} height={300}
      x={{
        range: withRoom(extent(points.map(([x]) => x)), 0.03),
        ticks: several && points.length < 10 ? points.map(([step]) => step) : 10,
        label: several ? 'Step of the search' : `${key.name}${key.unit ? ` [${key.unit}]` : ''}`,
      }}
      y={{ range: withRoom(extent([...points.map(([, y]) => y), wanted]), 0.12), label: goal.unit ? `[${goal.unit}]` : '' }}
      levels={wanted === null ? [] : [{ value: wanted, colour: colours.accent, dash: '7 4', width: 1.4 }]}
      curves={[{ points, colour: colours.pipe, width: 1.8, marks: 3 }]}
      points={reached === null ? [] : [{ x: answer, y: reached, colour: colours.accent, label: label.trim() }]}
    />
  );
}

export const seekFigures: Record<string, DrawFigure> = {
  seek_path: ({ part, data }) => {
    const { seek } = data as { seek: SeekData };
    return <SeekPath seek={seek} goal={seek.goals[Number(part)]!} />;
  },
};
