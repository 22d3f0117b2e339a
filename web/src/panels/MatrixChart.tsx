// Cases of a study in a drawing: a curve over one key, or a map over two.
import type { Matrix } from '../api/types';
import { nameStep } from '../logic/labelRoom';
import { ticks } from '../logic/laytable';
import type { Cell } from '../logic/studies';
import { tidy } from '../logic/units';

const kWide = 300, kLetter = 5.6, kRight = 8, kBottom = 34, kTop = 8;

type Axis = Matrix['inputs'][number];
export const axisName = (input: { key: string; unit: string }): string => `${input.key.split('.').at(-1)!.replace(/_/g, ' ')}${input.unit ? ` [${input.unit}]` : ''}`;
export const axisWord = (input: { words: string[]; values: (number | null)[] }, i: number): string => { const v = input.values[i]; return v === null || v === undefined ? input.words[i] ?? '' : tidy(v, 4); };

const words: Record<Cell['state'], string> = { passed: 'passes', reserved: 'passes with reservations', exceeded: 'a check is exceeded', 'not judged': 'not judged', failed: 'no solution', open: 'not computed yet' };

/** Room for the longest word beside the axis. */
const leftOf = (words: readonly string[]): number => Math.min(Math.max(52, kLetter * Math.max(...words.map((w) => w.length)) + 10), 130);

interface Chart { m: Matrix; axes: number[]; cells: Cell[][]; output: number; chosen: Cell | null; choose: (cell: Cell) => void }

const titleOf = ({ m, axes, output }: Chart, cell: Cell, i: number, j: number): string => {
  const places = axes.map((a, k) => `${m.inputs[a]!.key} ${axisWord(m.inputs[a]!, k ? j : i)} ${m.inputs[a]!.unit}`.trim());
  return `${places.join(', ')}: ${cell.value === null ? words[cell.state] : `${tidy(cell.value, 4)} ${m.outputs[output]!.unit}, ${words[cell.state]}`}`;
};

/** Values along the axis, or one beside the other where they are words. */
function positions(axis: Axis): { at: number[]; marks: { at: number; text: string }[] } {
  const numbers = axis.values.length === axis.words.length && axis.values.every((v) => v !== null) ? (axis.values as number[]) : null;
  if (!numbers) return { at: axis.words.map((_w, i) => i), marks: axis.words.map((text, at) => ({ at, text })) };
  return { at: numbers, marks: ticks(Math.min(...numbers), Math.max(...numbers), 5).map((at) => ({ at, text: String(at) })) };
}

export function Curve(chart: Chart) {
  const { m, axes, cells, output, chosen, choose } = chart;
  const axis = m.inputs[axes[0]!]!, { at, marks } = positions(axis), row = cells[0]!;
  const values = row.map((c) => c.value).filter((v): v is number => v !== null);
  const tall = 190, [low, high] = values.length ? [Math.min(...values), Math.max(...values)] : [0, 1], room = 0.08 * (high - low) || 0.05 * Math.abs(high) || 1;
  const [x0, x1] = [Math.min(...at), Math.max(...at)], [y0, y1] = [low >= 0 && low < 0.35 * high ? 0 : low - room, high + room];
  const kLeft = leftOf(ticks(y0, y1).map(String)), wide = kWide - kLeft - kRight, everyMark = nameStep(marks.map((m2) => m2.text), wide / Math.max(marks.length, 1), kLetter);
  const px = (x: number): number => kLeft + (x1 > x0 ? (x - x0) / (x1 - x0) : 0.5) * (kWide - kLeft - kRight - 8) + 4;
  const py = (y: number): number => tall - kBottom - ((y - y0) / (y1 - y0)) * (tall - kBottom - kTop);
  const order = row.map((_c, i) => i).sort((a, b) => at[a]! - at[b]!);
  let path = '', on = false;
  for (const i of order) { const v = row[i]!.value; if (v === null) on = false; else { path += `${on ? 'L' : 'M'}${px(at[i]!)} ${py(v)}`; on = true; } }
  return (
    <svg viewBox={`0 0 ${kWide} ${tall}`} class="matrix" role="group" aria-label={`${m.outputs[output]!.name} over ${axis.key}`}>
      {ticks(y0, y1).map((y) => <g key={y}><line class="grid" x1={kLeft} x2={kWide - kRight} y1={py(y)} y2={py(y)} /><text x={kLeft - 4} y={py(y) + 4} text-anchor="end">{y}</text></g>)}
      {marks.map((mark, i) => (i % everyMark ? null : <text key={mark.text} x={px(mark.at)} y={tall - kBottom + 14} text-anchor="middle">{mark.text}</text>))}
      <text class="title" x={(kLeft + kWide - kRight) / 2} y={tall - 4} text-anchor="middle">{axisName(axis)}</text>
      <path class="line k0" d={path} />
      {row.map((cell, i) => (
        <g key={i} class={`point ${cell.state.replace(' ', '-')}${chosen?.cases[0] === cell.cases[0] ? ' chosen' : ''}`} role="button" tabIndex={0} aria-label={titleOf(chart, cell, i, 0)} onClick={() => choose(cell)} onKeyDown={(e) => { if (e.key === 'Enter') choose(cell); }}>
          <title>{titleOf(chart, cell, i, 0)}</title>
          {cell.state === 'passed' ? <circle cx={px(at[i]!)} cy={py(cell.value ?? y0)} r="3.6" /> : <path d={`M${px(at[i]!) - 3.5} ${py(cell.value ?? y0) - 3.5}l7 7m0 -7l-7 7`} />}
          <rect class="hit" x={px(at[i]!) - 5} y={py(cell.value ?? y0) - 7} width="10" height="14" />
        </g>
      ))}
    </svg>
  );
}

/** Dark is more. Cells that exceed a check are struck through, those that pass with reservations ringed, those without a solution are crossed out. */
export function HeatMap(chart: Chart) {
  const { m, axes, cells, output, chosen, choose } = chart;
  const [x, y] = [m.inputs[axes[0]!]!, m.inputs[axes[1]!]!];
  const values = cells.flat().map((c) => c.value).filter((v): v is number => v !== null);
  const [low, high] = values.length ? [Math.min(...values), Math.max(...values)] : [0, 1];
  const columns = x.words.length, rows = y.words.length;
  const height = Math.max(10, Math.min(22, 220 / rows)), tall = kTop + rows * height + kBottom;
  const kLeft = leftOf(y.words.map((_word, j) => axisWord(y, j)));
  const w = (kWide - kLeft - kRight) / columns, every = nameStep(x.words.map((_word, i) => axisWord(x, i)), w, kLetter), everyRow = Math.ceil(11 / height);
  const shade = (v: number): number => (high > low ? (v - low) / (high - low) : 0.5);
  return (
    <>
      <svg viewBox={`0 0 ${kWide} ${tall}`} class="matrix" role="group" aria-label={`${m.outputs[output]!.name} over ${x.key} and ${y.key}`}>
        {cells.map((row, j) => row.map((cell, i) => {
          const [px, py] = [kLeft + i * w, kTop + (rows - 1 - j) * height];
          return (
            <g key={`${i} ${j}`} class={`cell ${cell.state.replace(' ', '-')}${chosen && chosen.cases[0] === cell.cases[0] ? ' chosen' : ''}`} role="button" tabIndex={0} aria-label={titleOf(chart, cell, i, j)} onClick={() => choose(cell)} onKeyDown={(e) => { if (e.key === 'Enter') choose(cell); }}>
              <title>{titleOf(chart, cell, i, j)}</title>
              <rect x={px} y={py} width={w - 0.7} height={height - 0.7} style={cell.value === null ? undefined : { fill: `hsl(212 70% ${90 - 62 * shade(cell.value)}%)` }} />
              {cell.state === 'reserved' ? <circle class="mark" cx={px + 0.5 * w} cy={py + 0.5 * height} r={Math.min(4, 0.3 * height)} /> : null}
              {cell.state === 'exceeded' || cell.state === 'failed' ? <path class="mark" d={`M${px + 0.2 * w} ${py + 0.8 * height}L${px + 0.8 * w} ${py + 0.2 * height}${cell.state === 'failed' ? `M${px + 0.2 * w} ${py + 0.2 * height}L${px + 0.8 * w} ${py + 0.8 * height}` : ''}`} /> : null}
            </g>
          );
        }))}
        {x.words.map((_word, i) => (i % every ? null : <text key={i} x={kLeft + (i + 0.5) * w} y={kTop + rows * height + 13} text-anchor="middle">{axisWord(x, i)}</text>))}
        {y.words.map((_word, j) => (j % everyRow ? null : <text key={j} x={kLeft - 4} y={kTop + (rows - 0.5 - j) * height + 4} text-anchor="end">{axisWord(y, j)}</text>))}
        <text class="title" x={(kLeft + kWide - kRight) / 2} y={tall - 4} text-anchor="middle">{axisName(x)}</text>
      </svg>
      <p class="brief">Up: {axisName(y)}. Light is {tidy(low, 4)}, dark {tidy(high, 4)} {m.outputs[output]!.unit}; struck through: a check is exceeded; ringed: passes with reservations; crossed out: no solution.</p>
    </>
  );
}
