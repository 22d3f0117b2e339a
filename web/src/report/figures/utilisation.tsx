// Utilisation of the code checks and damage rate of welds along the pipe.
import { lowerBound } from '../../components/chart/scale';
import { colours } from '../../components/colours';
import { fixed, useUnits } from '../../components/units';
import type { PipeData } from '../data';
import type { DrawFigure } from '../figures';
import { AlongChart, largest, partEnd, upTo } from './along';

const checkLooks = [
  { key: 'api', name: 'API RP 1111', colour: colours.third, dash: '9 3' },
  { key: 'stress', name: 'stress', colour: colours.second, dash: '5 3' },
  { key: 'load', name: 'DNV load', colour: colours.dynamic },
  { key: 'strain', name: 'DNV strain', colour: colours.pipe },
  { key: 'laying', name: 'laying strain', colour: colours.port, dash: '3 3' },
] as const;

/** Index of the first list entry at or after an arc length. */
const placeAfter = (list: readonly number[], s: number) => Math.min(lowerBound(list, s), list.length - 1);

export const Checks: DrawFigure = ({ part, data }) => {
  const pipe = data as PipeData;
  const units = useUnits();
  const { checks } = pipe;
  if (!checks) return null;
  const { s, governing } = checks;
  const indices = upTo(s, partEnd(pipe, part));
  const used = checkLooks.filter(({ key }) => indices.some((i) => checks[key][i]! > 0));
  const max = Math.max(1, ...used.flatMap(({ key }) => indices.map((i) => checks[key][i]!)));
  const worst = largest(indices, (i) => governing[i]!);
  return (
    <AlongChart
      pipe={pipe}
      kind={{ name: 'Utilisation', unit: '-', zero: true }}
      part={part}
      range={[0, max]}
      curves={used.map((check) => ({ ...check, width: 1.9, points: indices.map((i) => [s[i]!, checks[check.key][i]! > 0 ? checks[check.key][i]! : null]) }))}
      levels={[{ value: 1, name: 'full capacity', colour: colours.accent, dash: '8 4' }]}
      legend={used.map((check) => ({ ...check, text: check.name })).reverse()}
      points={[{ x: s[worst]!, y: governing[worst]!, colour: colours.pipe, label: `${fixed(governing[worst]!, 3)} at ${units.shown(s[worst]!, 'm', 1)}` }]}
      hover={(place) => {
        const i = placeAfter(s, place);
        return used.filter(({ key }) => checks[key][i]! > 0).map(({ key, name }) => `${name} ${fixed(checks[key][i]!, 3)}`).join(', ');
      }}
    />
  );
};

const spotLooks = [
  { colour: colours.pipe }, { colour: colours.second, dash: '5 3' }, { colour: colours.third, dash: '9 3' },
  { colour: colours.port, dash: '3 3' }, { colour: colours.dynamic },
];

const rateText = (rate: number) => (rate > 0 ? rate.toExponential(2) : '0');

export const Fatigue: DrawFigure = ({ part, data }) => {
  const pipe = data as PipeData;
  const fatigue = pipe.dynamic?.fatigue;
  if (!fatigue) return null;
  const { s } = fatigue;
  const indices = upTo(s, partEnd(pipe, part));
  const spots = fatigue.spots.map((spot, i) => ({ ...spot, ...spotLooks[i % spotLooks.length]! }));
  const max = Math.max(0, ...spots.flatMap(({ rate }) => indices.map((i) => rate[i]!)));
  // The power of ten is shown once, at the axis.
  const power = max > 0 ? Math.floor(Math.log10(max)) : 0;
  const factor = 10 ** -power;
  return (
    <AlongChart
      pipe={pipe}
      kind={{ name: 'Damage rate', axis: 'Damage per hour', unit: power === 0 ? '-' : `1e${power}`, zero: true }}
      part={part}
      range={[0, (max || 1) * factor]}
      curves={spots.map(({ rate, ...look }) => ({ ...look, width: 1.9, points: indices.map((i) => [s[i]!, rate[i]! * factor]) }))}
      legend={spots.map(({ name, curve, colour, dash }) => ({ text: `${name}, ${curve}`, colour, dash }))}
      points={[]}
      hover={(place) => spots.map(({ name, rate }) => `${name} ${rateText(rate[placeAfter(s, place)]!)} per hour`).join(', ')}
    />
  );
};
