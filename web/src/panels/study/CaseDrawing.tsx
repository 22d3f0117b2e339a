// Cases of a study in a drawing: a curve over one key, a map over two, bars for one key at a time.
import type { Matrix, MatrixCase } from '../../api/types';
import { Chart } from '../../components/Chart';
import type { Frame } from '../../components/chart/types';
import { resultLimit, valueScale } from '../../components/colourScale';
import { HeatMap, stateLabels } from '../../components/HeatMap';
import { axisPlaces, keyAxis, roomAround } from '../../components/keyAxis';
import { TwoSidedBars } from '../../components/TwoSidedBars';
import { keyLabel, resultName, resultTitle, resultUnit, resultValue, swings, type Cell } from '../../logic/studies';
import { tidy } from '../../logic/units';

type Input = Matrix['inputs'][number];

export const axisName = (input: { key: string; unit: string }): string => `${keyLabel(input.key)}${input.unit ? ` [${input.unit}]` : ''}`;

export function axisWord(input: { words: string[]; values: (number | null)[] }, i: number): string {
  const value = input.values[i];
  return value === null || value === undefined ? input.words[i] ?? '' : tidy(value, 4);
}

export const stateNames: Record<Cell['state'], string> = {
  passed: 'passes', reserved: 'passes with reservations', exceeded: 'a check is exceeded', 'not judged': 'not judged', failed: 'no solution',
  open: 'not computed yet' };

export interface Drawn { m: Matrix; axes: number[]; cells: Cell[][]; output: number; chosen: number | null; choose?: (cell: Cell) => void; width?: number }

/** "water_depth 80 m, tension 250 kN: 0.71, passes" */
export function describeCell({ m, axes, output }: Pick<Drawn, 'm' | 'axes' | 'output'>, cell: Cell, i: number, j: number): string {
  const places = axes.map((a, k) => `${keyLabel(m.inputs[a]!.key)} ${axisWord(m.inputs[a]!, k ? j : i)} ${m.inputs[a]!.unit}`.trim());
  const value = cell.value === null ? '' : `${tidy(cell.value, 4)} ${resultUnit(m, output)}`.trim();
  const check = cell.cases[0]?.governing;
  return `${places.join(', ')}: ${value ? `${value}, ` : ''}${stateNames[cell.state]}${check ? `; governing: ${check}` : ''}`;
}

const named = (input: Input) => ({ name: axisName(input), words: input.words, values: input.values });

export const isChosen = (cell: Cell, chosen: number | null): boolean => chosen !== null && cell.cases.some((c) => c.number === chosen);

function CasePoint({ drawn, frame, cell, x, i }: { drawn: Drawn; frame: Frame; cell: Cell; x: number; i: number }) {
  const { chosen, choose } = drawn;
  const [px, py] = [frame.x(x), cell.value === null ? frame.bottom : frame.y(cell.value)];
  const title = describeCell(drawn, cell, i, 0);
  return (
    <g
      class={`point ${cell.state.replace(' ', '-')}${isChosen(cell, chosen) ? ' chosen' : ''}`} role="button" tabIndex={0} aria-label={title}
      onClick={() => choose?.(cell)} onKeyDown={(e) => { if (e.key === 'Enter') choose?.(cell); }}
    >
      <title>{title}</title>
      {cell.state === 'passed' ? <circle cx={px} cy={py} r="3.6" /> : <path d={`M${px - 3.5} ${py - 3.5}l7 7m0 -7l-7 7`} />}
      <rect class="hit" x={px - 5} y={py - 7} width="10" height="14" />
    </g>
  );
}

export function CaseCurve(drawn: Drawn) {
  const { m, axes, cells, output, width = 760 } = drawn;
  const axis = named(m.inputs[axes[0]!]!), { places } = axisPlaces(axis), limit = resultLimit(resultName(m, output));
  const row = cells[0]!.map((cell, i) => ({ cell, i, x: places[i]! })).sort((a, b) => a.x - b.x);
  const range = roomAround(row.flatMap(({ cell }) => (cell.value === null ? [] : [cell.value])), 0.08);
  return (
    <Chart
      small interactive title={resultTitle(m, output)} width={width} height={Math.round(0.5 * width)} x={{ ...keyAxis(axis), ticks: width < 500 ? 5 : 9 }} y={{ range }}
      levels={limit !== null && limit < range[1] ? [{ value: limit, colour: 'var(--bad)', dash: '7 4', name: 'limit' }] : []}
      curves={[{ points: row.map(({ cell, x }) => [x, cell.value]), colour: 'var(--pipe)' }]}
    >
      {(frame) => row.map((place) => <CasePoint key={place.i} drawn={drawn} frame={frame} {...place} />)}
    </Chart>
  );
}

export const marksText = (cells: Cell[][]): string => stateLabels(cells.flat().map((cell) => cell.state));

export function CaseMap(drawn: Drawn) {
  const { m, axes, cells, output, chosen, choose, width = 760 } = drawn;
  const [x, y] = axes.map((a) => m.inputs[a]!) as [Input, Input];
  const values = cells.flat().flatMap((cell) => (cell.value === null ? [] : [cell.value]));
  const axis = (input: Input) => ({ name: axisName(input), labels: axisPlaces(named(input)).labels });
  return (
    <HeatMap
      label={`${resultTitle(m, output)} over ${keyLabel(x.key)} and ${keyLabel(y.key)}`} title={resultTitle(m, output)} width={width} row={30}
      x={axis(x)} y={axis(y)} scale={valueScale(values, resultLimit(resultName(m, output)))}
      cells={cells.map((row, j) => row.map((cell, i) => (
        { value: cell.value, state: cell.state, title: describeCell(drawn, cell, i, j), chosen: isChosen(cell, chosen) })))}
      choose={choose && ((i, j) => choose(cells[j]![i]!))}
    />
  );
}

/** Effect of each key on a result while the others keep the values of the model. */
export function CaseSwings({ m, base, output, width = 760 }: { m: Matrix; base: MatrixCase; output: number; width?: number }) {
  const middle = resultValue(base, output), bars = swings(m, base, output);
  if (middle === null) return <p class="empty">The base case has no such result.</p>;
  const [low, high] = [Math.min(middle, ...bars.map((bar) => bar.low)), Math.max(middle, ...bars.map((bar) => bar.high))];
  const room = 0.05 * (high - low) || 0.5, number = (value: number): string => tidy(value, 4);
  return (
    <TwoSidedBars
      title={resultTitle(m, output)} label={`${resultUnit(m, output) || 'value'}; the line is the value of the model, ${number(middle)}`} width={width} middle={middle}
      range={[low - room, high + room]} lowColour="#c77700" highColour="var(--pipe)"
      bars={bars.map(({ key, ...bar }) => (
        { name: keyLabel(key), low: bar.low, high: bar.high, title: `${key}: ${number(bar.low)} at ${bar.lowWord}, ${number(bar.high)} at ${bar.highWord}` }))}
    />
  );
}
