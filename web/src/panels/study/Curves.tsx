// Curves of the dock: every result over the key, over two keys a curve for each row, and the tensions over the depth.
import type { Matrix } from '../../api/types';
import { Chart } from '../../components/Chart';
import { curveLook } from '../../components/colours';
import { axisPlaces, keyAxis, roomAround } from '../../components/keyAxis';
import { LayTableCharts } from '../../components/LayTableCharts';
import { depthLimits, type LimitEnd } from '../../logic/layGrid';
import { baseCase, cellsOver, kUtilisation, resultTitle } from '../../logic/studies';
import { chosenCase, fixed, layTable, limits, matrix } from '../../state/studies';
import { axisName, axisWord, CaseCurve, CaseSwings } from './CaseDrawing';
import { axes, chooseCell, isLayGrid, shape } from './shown';

const kWide = 420, kTall = 240;

/** In the colours of the theme. */
const layLook = { curves: ['var(--pipe)', '#e07b1a'], limit: 'var(--bad)', passing: 'var(--range)' };

const inPage = (k: number): { colour: string; dash?: string } => { const look = curveLook(k); return look.colour === '#000000' ? { ...look, colour: 'var(--ink)' } : look; };

/** Maximum number of distinguishable curves. */
const kRows = 9;

const results = (m: Matrix): number[] => [kUtilisation, ...m.outputs.map((_, i) => i)];

/** A result over the columns, a curve for each row. */
function RowCurves({ m, output }: { m: Matrix; output: number }) {
  const [x, y] = axes.value as [number, number], cells = cellsOver(m, [x, y], fixed.value, output), down = m.inputs[y]!;
  const axis = { name: axisName(m.inputs[x]!), words: m.inputs[x]!.words, values: m.inputs[x]!.values }, { places } = axisPlaces(axis);
  const step = Math.ceil(cells.length / kRows), rows = cells.map((row, j) => ({ row, j })).filter(({ j }) => j % step === 0);
  const values = rows.flatMap(({ row }) => row.flatMap(({ value }) => (value === null ? [] : [value])));
  if (values.length === 0) return null;
  return (
    <Chart
      small title={resultTitle(m, output)} width={kWide} height={kTall} x={{ ...keyAxis(axis), ticks: 5 }} y={{ range: roomAround(values, 0.08) }}
      curves={rows.map(({ row, j }, k) => (
        { ...inPage(k), marks: 2, title: `${axisName(down)} ${axisWord(down, j)}`, points: row.map((cell, i) => [places[i]!, cell.value] as const).sort((a, b) => a[0] - b[0]) }))}
      legend={rows.map(({ j }, k) => ({ ...inPage(k), text: `${axisWord(down, j)} ${down.unit}`.trim() }))}
    />
  );
}

/** Minimum and maximum tension, and the lay-back there, over the depth. */
function TensionCurves({ m }: { m: Matrix }) {
  const [x, y] = axes.value as [number, number], list = depthLimits(m, x, y, fixed.value, limits.value), down = m.inputs[y]!;
  const axis = { name: axisName(down), words: down.words, values: down.values }, { places } = axisPlaces(axis);
  const curve = (pick: 'least' | 'most', value: (end: LimitEnd) => number | null) => list.map((row, j) => [places[j]!, row[pick] ? value(row[pick]!) : null] as const);
  const back = m.outputs.find(({ name }) => name.endsWith('.lay_back'))?.unit ?? '';
  const charts: [string, (end: LimitEnd) => number | null][] = [
    [`Tension over depth [${m.inputs[x]!.unit}]`, (end) => end.tension], [`Lay-back over depth [${back}]`, (end) => end.layBack]];
  return (
    <>
      {charts.map(([title, value]) => {
        const [least, most] = [curve('least', value), curve('most', value)], values = [...least, ...most].flatMap(([, v]) => (v === null ? [] : [v]));
        return values.length === 0 ? null : (
          <Chart
            key={title} small title={title} width={kWide} height={kTall} x={{ ...keyAxis(axis), ticks: 5 }} y={{ range: roomAround(values, 0.1) }}
            areas={[{ points: least.map(([place, low], i) => [place, low, most[i]![1]] as const), colour: 'var(--range)' }]}
            curves={[{ points: least, colour: 'var(--pipe)', marks: 2.2 }, { points: most, colour: '#e07b1a', marks: 2.2 }]}
            legend={[{ text: 'least', colour: 'var(--pipe)' }, { text: 'most', colour: '#e07b1a' }]}
          />
        );
      })}
    </>
  );
}

function MatrixCurves({ m }: { m: Matrix }) {
  const base = baseCase(m);
  if (base) return <>{results(m).map((output) => <div key={output}><CaseSwings m={m} base={base} output={output} width={kWide} /></div>)}</>;
  if (shape.value === 'grid') return <>{isLayGrid.value ? <TensionCurves m={m} /> : null}{results(m).map((output) => <RowCurves key={output} m={m} output={output} />)}</>;
  if (shape.value !== 'curve') return <p class="empty">{m.operability ? 'Limits of operability are drawn above.' : 'These cases do not vary over a single key.'}</p>;
  return <>{results(m).map((output) => <CaseCurve key={output} m={m} axes={axes.value} cells={cellsOver(m, axes.value, fixed.value, output)} output={output} chosen={chosenCase.value} choose={chooseCell} width={kWide} />)}</>;
}

export function Curves() {
  const m = matrix.value, table = layTable.value;
  if (m?.cases.length || m?.operability) return <div class="studydrawings drawn matrix"><MatrixCurves m={m} /></div>;
  if (!table || m) return <p class="empty">Curves appear here when cases are solved.</p>;
  const { curves } = table.of;
  return (
    <>
      <p class="brief">{curves.axis}; shaded where the lay passes.</p>
      <div class="studydrawings laycurves drawn"><LayTableCharts table={curves} look={layLook} width={kWide} /></div>
    </>
  );
}
