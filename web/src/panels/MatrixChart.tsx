// Cases of a study in a drawing: a curve over one key, or a map over two.
import type { Matrix } from '../api/types';
import { Chart } from '../components/Chart';
import type { Frame } from '../components/chart/types';
import { resultLimit, valueScale } from '../components/colourScale';
import { HeatMap, stateWords } from '../components/HeatMap';
import { axisPlaces, keyAxis, roomAround } from '../components/keyAxis';
import type { Cell } from '../logic/studies';
import { tidy } from '../logic/units';

const kWide = 340;

type Axis = Matrix['inputs'][number];
export const axisName = (input: { key: string; unit: string }): string =>
  `${input.key.split('.').at(-1)!.replace(/_/g, ' ')}${input.unit ? ` [${input.unit}]` : ''}`;

export function axisWord(input: { words: string[]; values: (number | null)[] }, i: number): string {
  const value = input.values[i];
  return value === null || value === undefined ? input.words[i] ?? '' : tidy(value, 4);
}

const words: Record<Cell['state'], string> = {
  passed: 'passes', reserved: 'passes with reservations', exceeded: 'a check is exceeded', 'not judged': 'not judged', failed: 'no solution',
  open: 'not computed yet' };

interface Drawn { m: Matrix; axes: number[]; cells: Cell[][]; output: number; chosen: Cell | null; choose: (cell: Cell) => void }

const describe = ({ m, axes, output }: Drawn, cell: Cell, i: number, j: number): string => {
  const places = axes.map((a, k) => `${m.inputs[a]!.key} ${axisWord(m.inputs[a]!, k ? j : i)} ${m.inputs[a]!.unit}`.trim());
  return `${places.join(', ')}: ${cell.value === null ? words[cell.state] : `${tidy(cell.value, 4)} ${m.outputs[output]!.unit}, ${words[cell.state]}`}`;
};

const named = (input: Axis) => ({ name: axisName(input), words: input.words, values: input.values });

const isChosen = (cell: Cell, chosen: Cell | null): boolean => chosen !== null && chosen.cases[0] === cell.cases[0];

function CasePoint({ drawn, frame, cell, x, i }: { drawn: Drawn; frame: Frame; cell: Cell; x: number; i: number }) {
  const { chosen, choose } = drawn;
  const [px, py] = [frame.x(x), cell.value === null ? frame.bottom : frame.y(cell.value)];
  const title = describe(drawn, cell, i, 0);
  return (
    <g
      class={`point ${cell.state.replace(' ', '-')}${isChosen(cell, chosen) ? ' chosen' : ''}`} role="button" tabIndex={0} aria-label={title}
      onClick={() => choose(cell)} onKeyDown={(e) => { if (e.key === 'Enter') choose(cell); }}
    >
      <title>{title}</title>
      {cell.state === 'passed' ? <circle cx={px} cy={py} r="3.6" /> : <path d={`M${px - 3.5} ${py - 3.5}l7 7m0 -7l-7 7`} />}
      <rect class="hit" x={px - 5} y={py - 7} width="10" height="14" />
    </g>
  );
}

export function Curve(drawn: Drawn) {
  const { m, axes, cells, output } = drawn;
  const axis = named(m.inputs[axes[0]!]!), { places } = axisPlaces(axis);
  const row = cells[0]!.map((cell, i) => ({ cell, i, x: places[i]! })).sort((a, b) => a.x - b.x);
  return (
    <div class="matrix drawn">
      <Chart
        small interactive width={kWide} height={220} x={{ ...keyAxis(axis), ticks: 5 }}
        y={{ range: roomAround(row.flatMap(({ cell }) => (cell.value === null ? [] : [cell.value])), 0.08), label: m.outputs[output]!.unit }}
        curves={[{ points: row.map(({ cell, x }) => [x, cell.value]), colour: 'var(--pipe)' }]}
      >
        {(frame) => row.map((place) => <CasePoint key={place.i} drawn={drawn} frame={frame} {...place} />)}
      </Chart>
    </div>
  );
}

export function CaseMap(drawn: Drawn) {
  const { m, axes, cells, output, chosen, choose } = drawn;
  const [x, y] = axes.map((a) => m.inputs[a]!) as [Axis, Axis], { name, unit } = m.outputs[output]!;
  const values = cells.flat().flatMap((cell) => (cell.value === null ? [] : [cell.value]));
  const axis = (input: Axis) => ({ name: axisName(input), words: axisPlaces(named(input)).words });
  const marks = stateWords(cells.flat().map((cell) => cell.state));
  return (
    <div class="matrix drawn">
      <HeatMap
        label={`${name} over ${x.key} and ${y.key}`} width={kWide} x={axis(x)} y={axis(y)} scale={valueScale(values, resultLimit(name))}
        cells={cells.map((row, j) => row.map((cell, i) => (
          { value: cell.value, state: cell.state, title: describe(drawn, cell, i, j), chosen: isChosen(cell, chosen) })))}
        choose={(i, j) => choose(cells[j]![i]!)}
      />
      <p class="brief">{unit ? `Colours in ${unit}. ` : ''}{marks ? `Cells ${marks}.` : ''}</p>
    </div>
  );
}
