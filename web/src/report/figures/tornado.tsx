// Effects of the tolerances of inputs on a result: bars to both sides of its value.
import { Chart } from '../../components/Chart';
import type { Bar } from '../../components/chart/types';
import { colours } from '../../components/colours';
import type { TornadoData } from '../data';
import type { DrawFigure } from '../figures';

const kRow = 26;
const increased = '#2f6f9f';
const decreased = '#a9c8de';

export const Tornado: DrawFigure = ({ data }) => {
  const { title, unit, bars, notes } = data as TornadoData;
  const max = 1.02 * Math.max(...bars.flatMap(({ low, high }) => [Math.abs(low), Math.abs(high)]));
  const middle = (row: number) => bars.length - row - 0.5;
  const bar = (row: number, effect: number, colour: string, title: string): Bar => (
    { x: [Math.min(effect, 0), Math.max(effect, 0)], y: [middle(row) - 0.33, middle(row) + 0.33], colour, title });
  return (
    <>
      <Chart
        title={title}
        height={kRow * bars.length + 84}
        right={150}
        x={{ range: [-max, max], label: `Effect [${unit || '-'}]` }}
        y={{ range: [0, bars.length], names: bars.map(({ name }, row) => ({ value: middle(row), text: name })) }}
        bars={bars.flatMap(({ name, low, high, low_label: down, high_label: up }, row) => [
          bar(row, low, decreased, `${name}, decreased: ${down}`),
          bar(row, high, increased, `${name}, increased: ${up}`),
        ])}
        verticals={[{ x: 0, colour: colours.zero, dash: 'none' }]}
        legend={[{ text: 'input decreased', colour: decreased, look: 'block' }, { text: 'input increased', colour: increased, look: 'block' }]}
      >
        {(frame) => bars.map((effect, row) => (
          <text class="soft" text-anchor="end" x={frame.width - 6} y={frame.y(middle(row)) + 5}>{effect.high_label}</text>
        ))}
      </Chart>
      {notes.length > 0 && <p>* One-sided:</p>}
      {notes.length > 0 && <ul>{notes.map((note) => <li>{note}</li>)}</ul>}
    </>
  );
};
