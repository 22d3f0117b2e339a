// Results of a study over its keys: curves, maps, ranges, rank correlations, scatter.
import { Chart } from '../../components/Chart';
import type { LegendEntry, Point } from '../../components/chart/types';
import { colours } from '../../components/colours';
import { axisPlaces, keyAxis, roomAround } from '../../components/keyAxis';
import { TwoSidedBars } from '../../components/TwoSidedBars';
import type { CorrelationData, StudyData, StudyGroupData, SwingData } from '../data';
import type { DrawFigure } from '../figures';
import { describeGroup, groupsWith, valueText } from './study_cases';
import { kMaxMultiples, StudyMaps } from './study_maps';

const kSeedBand = '#c9dbea';

/** Colour, edge and label of a point; passed cases need no label. */
const kLooks: Partial<Record<StudyGroupData['state'], { colour: string; edge: string; text: string }>> = {
  reserved: { colour: '#fff', edge: colours.second, text: 'with reservations' },
  exceeded: { colour: '#fff', edge: colours.accent, text: 'check exceeded' },
};

function groupPoint(study: StudyData, group: StudyGroupData, x: number, output: number, radius: number): Point {
  const { colour, edge } = kLooks[group.state] ?? { colour: colours.pipe, edge: colours.pipe };
  return { x, y: group.mean[output]!, radius, colour, edge, title: describeGroup(study, group) };
}

const stateLegend = (groups: readonly StudyGroupData[]): LegendEntry[] =>
  Object.entries(kLooks).filter(([state]) => groups.some((group) => group.state === state)).map(([, look]) => ({ ...look, look: 'dot' }));

function StudyCurves({ study }: { study: StudyData }) {
  const key = study.axes[0]!;
  const { places } = axisPlaces(study.inputs[key]!);
  const findX = (group: StudyGroupData): number => places[group.at[key]!]!;
  return (
    <>
      {study.outputs.map(({ name, at: index }) => {
        const groups = groupsWith(study, index).sort((a, b) => findX(a) - findX(b));
        if (groups.length === 0) return null;
        const spread = groups.map((group) => [findX(group), group.low[index]!, group.high[index]!] as const);
        return (
          <Chart
            small title={name} height={250} x={keyAxis(study.inputs[key]!)}
            y={{ range: roomAround(spread.flatMap(([, low, high]) => [low, high]), 0.08) }}
            areas={[{ points: spread, colour: kSeedBand }]}
            curves={[{ points: groups.map((group) => [findX(group), group.mean[index]!]), colour: colours.pipe }]}
            points={groups.map((group) => groupPoint(study, group, findX(group), index, 3.2))}
            legend={stateLegend(groups)}
          />
        );
      })}
    </>
  );
}

function StudySwings({ all }: { all: SwingData[] }) {
  return (
    <>
      {all.map(({ output, base, bars }) => {
        const sorted = [...bars].sort((a, b) => (b.high - b.low) - (a.high - a.low));
        const [low, high] = [Math.min(base, ...bars.map((bar) => bar.low)), Math.max(base, ...bars.map((bar) => bar.high))];
        const room = 0.05 * (high - low) || 0.5;
        const barTitle = (bar: (typeof bars)[number]): string =>
          `${bar.name}: ${valueText(bar.low)} at ${bar.low_word}, ${valueText(bar.high)} at ${bar.high_word}`;
        return (
          <TwoSidedBars
            title={output} label="value; the line is the base case" middle={base} range={[low - room, high + room]}
            bars={sorted.map((bar) => ({ ...bar, title: barTitle(bar) }))}
          />
        );
      })}
    </>
  );
}

function StudyCorrelations({ all }: { all: CorrelationData[] }) {
  return (
    <>
      {all.filter(({ bars }) => bars.length > 0).map(({ output, bars }) => (
        <TwoSidedBars
          title={output} label="rank correlation" middle={0} range={[-1, 1]}
          bars={[...bars].sort((a, b) => Math.abs(b.value) - Math.abs(a.value)).map(({ name, value }) => (
            { name, low: Math.min(value, 0), high: Math.max(value, 0), title: `${name}: ${value.toFixed(2)}` }))}
        />
      ))}
    </>
  );
}

function StudyScatter({ study }: { study: StudyData }) {
  const charts = study.outputs.flatMap((output) => study.inputs.map((input, key) => (
    { output, input, key, groups: groupsWith(study, output.at).filter((group) => group.x[key] !== null) }))).filter(({ groups }) => groups.length > 0);
  const rest = charts.length - kMaxMultiples;
  return (
    <>
      {charts.slice(0, kMaxMultiples).map(({ output, input, key, groups }) => (
        <Chart
          small title={output.name} height={250} x={{ range: roomAround(groups.map((group) => group.x[key]!), 0.04), label: input.name }}
          y={{ range: roomAround(groups.map((group) => group.mean[output.at]!), 0.08) }}
          points={groups.map((group) => groupPoint(study, group, group.x[key]!, output.at, 2.6))} legend={stateLegend(groups)}
        />
      ))}
      {rest > 0 ? <p class="small">{`${rest} more diagrams are not shown; the table of cases has their numbers.`}</p> : null}
    </>
  );
}

const readStudy = (data: unknown): StudyData => (data as { study: StudyData }).study;

export const studyFigures: Record<string, DrawFigure> = {
  study_correlations: ({ data }) => <StudyCorrelations all={(readStudy(data).tornado ?? []) as CorrelationData[]} />,
  study_curves: ({ data }) => <StudyCurves study={readStudy(data)} />,
  study_maps: ({ data }) => <StudyMaps study={readStudy(data)} />,
  study_scatter: ({ data }) => <StudyScatter study={readStudy(data)} />,
  study_swings: ({ data }) => <StudySwings all={(readStudy(data).tornado ?? []) as SwingData[]} />,
};
