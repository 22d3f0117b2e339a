// A result over two keys as a table: colour and mark show the check status, a letter the governing check.
import type { Matrix } from '../../api/types';
import { limitBroken } from '../../logic/layGrid';
import { foremost, governingChecks, keyLabel, kUtilisation, type Cell } from '../../logic/studies';
import { tidy } from '../../logic/units';
import { limits } from '../../state/studies';
import { axisName, axisWord, describeCell, isChosen } from './CaseDrawing';

/** Passes its checks, but not the limits of the lay table. */
const isBeyond = (m: Matrix, cell: Cell): boolean =>
  (cell.state === 'passed' || (cell.state === 'reserved' && limits.value.reserved)) && limitBroken(m, foremost(cell), limits.value) !== null;

const marks: Partial<Record<Cell['state'], string>> = { exceeded: '✕', reserved: '○', 'not judged': '·' };

interface GridProps { m: Matrix; axes: number[]; cells: Cell[][]; output: number; chosen: number | null; choose: (cell: Cell) => void; open: (cell: Cell) => void }

/** Arrow keys move between the cells, which are one tab stop. */
function move(event: KeyboardEvent): void {
  const step = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowDown: [0, 1], ArrowUp: [0, -1] }[event.key];
  const cell = (event.target as HTMLElement).closest('td'), row = cell?.parentElement as HTMLTableRowElement | null;
  if (!step || !cell || !row) return;
  event.preventDefault();
  const rows = [...(row.parentElement as HTMLTableSectionElement).rows];
  const next = rows[rows.indexOf(row) + step[1]!]?.cells[cell.cellIndex + step[0]!]?.querySelector('button');
  next?.focus();
}

function GridCell({ grid, i, j, letter, stop }: { grid: GridProps; i: number; j: number; letter: string; stop: boolean }) {
  const cell = grid.cells[j]![i]!, { value, state } = cell;
  const number = value === null ? (state === 'failed' ? 'none' : '') : grid.output === kUtilisation ? value.toFixed(2) : tidy(value, 4);
  const beyond = isBeyond(grid.m, cell);
  return (
    <td role="gridcell" class={`${beyond ? 'beyond' : state.replace(' ', '-')}${isChosen(cell, grid.chosen) ? ' chosen' : ''}`}>
      <button
        type="button" tabIndex={stop ? 0 : -1} aria-label={describeCell(grid, cell, i, j)} title={describeCell(grid, cell, i, j)}
        aria-pressed={isChosen(cell, grid.chosen)} onClick={() => grid.choose(cell)} onDblClick={() => grid.open(cell)}
      >
        <b>{number}</b><i>{beyond ? '△' : marks[state] ?? ''}</i><small>{letter}</small>
      </button>
    </td>
  );
}

export function CaseGrid(grid: GridProps) {
  const { m, axes, cells, chosen } = grid;
  const [x, y] = axes.map((a) => m.inputs[a]!) as [Matrix['inputs'][number], Matrix['inputs'][number]];
  const letters = new Map(governingChecks(m).map(({ name, letter }) => [name, letter]));
  const place = cells.map((row) => row.findIndex((cell) => isChosen(cell, chosen)));
  const stopRow = Math.max(0, place.findIndex((i) => i >= 0)), stopColumn = Math.max(0, place[stopRow] ?? 0);
  return (
    <div class="casegrid">
      <table role="grid" aria-label={`Cases over ${keyLabel(x.key)} and ${keyLabel(y.key)}`} onKeyDown={move}>
        <thead>
          <tr><th scope="col" class="corner">{axisName(y)}<span>{axisName(x)}</span></th>{x.words.map((_, i) => <th key={i} scope="col">{axisWord(x, i)}</th>)}</tr>
        </thead>
        <tbody>
          {y.words.map((_, j) => (
            <tr key={j}>
              <th scope="row">{axisWord(y, j)}</th>
              {x.words.map((_w, i) => (
                <GridCell key={i} grid={grid} i={i} j={j} letter={letters.get(cells[j]![i]!.cases[0]?.governing ?? '') ?? ''} stop={j === stopRow && i === stopColumn} />
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

/** Legend of letters and marks. */
export function GridKey({ m, cells }: { m: Matrix; cells: Cell[][] }) {
  const checks = governingChecks(m), states = new Set(cells.flat().map((cell) => cell.state));
  return (
    <p class="gridkey">
      {states.has('exceeded') ? <span><i class="exceeded">✕</i> a check is exceeded</span> : null}
      {states.has('reserved') ? <span><i class="reserved">○</i> passes with reservations</span> : null}
      {cells.flat().some((cell) => isBeyond(m, cell)) ? <span><i class="beyond">△</i> passes, beyond the limits above</span> : null}
      {states.has('not judged') ? <span><i>·</i> not judged</span> : null}
      {states.has('failed') ? <span><i class="failed">none</i> no solution</span> : null}
      {checks.map(({ name, letter, count }) => <span key={name}><b>{letter}</b> {name} ({count})</span>)}
    </p>
  );
}
