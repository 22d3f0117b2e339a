// Limits of operability: a table over one or two keys, a chart, a rose over a direction, the workable time.
import type { VNode } from 'preact';
import type { MatrixLimits } from '../../api/types';
import { headingAxis, OperabilityChart, OperabilityRose, Workability, type OperabilityData } from '../../components/Operability';
import { Table } from '../../components/Table';
import { limitsTable } from '../../logic/studyTables';
import { tidy } from '../../logic/units';
import { axisName, axisWord } from './CaseDrawing';

/** Data in the format of the report drawings. */
export function operabilityData(of: MatrixLimits): OperabilityData {
  const values = of.cells.flatMap(({ limit }) => (limit === null ? [] : [limit]));
  return {
    over: axisName({ key: of.over, unit: of.unit }), least: null, largest: Math.max(0, ...values) || 1, alpha: of.alpha,
    axes: of.axes.map((axis) => ({ name: axisName(axis), words: axis.words, values: axis.values })), cells: of.cells,
    months: of.months.map((part) => 100 * part), year: of.year === null ? undefined : 100 * of.year,
  };
}

/** The drawing to save: the rose if a key is a direction, otherwise the chart; null without a key. */
export function limitsDrawing(of: MatrixLimits): VNode | null {
  if (of.axes.length === 0) return null;
  const data = operabilityData(of);
  return headingAxis(data) >= 0 ? <OperabilityRose all={data} /> : <OperabilityChart all={data} />;
}

function Crossed({ of }: { of: MatrixLimits }) {
  const [rows, columns] = of.axes;
  const cellAt = (place: number[]) => of.cells.find((c) => c.at.every((i, k) => i === place[k]));
  const cellText = (place: number[]): string => {
    const cell = cellAt(place);
    if (!cell || !cell.decided) return '?';
    return `${cell.limit === null ? 'none' : `${cell.beyond ? '≥ ' : ''}${tidy(cell.limit, 4)}`}${cell.reason ? ' *' : ''}`;
  };
  const why = (place: number[]): string => { const cell = cellAt(place); return cell ? [cell.governing, cell.reason].filter(Boolean).join('; ') : ''; };
  return (
    <div class="table">
      <table class="plain limits">
        <thead><tr><th scope="col">{axisName(rows!)} \ {axisName(columns!)}</th>{columns!.words.map((_, i) => <th key={i} scope="col">{axisWord(columns!, i)}</th>)}</tr></thead>
        <tbody>
          {rows!.words.map((_, j) => (
            <tr key={j}><th scope="row">{axisWord(rows!, j)}</th>{columns!.words.map((_c, i) => <td key={i} title={why([j, i])}>{cellText([j, i])}</td>)}</tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

export function Limits({ of }: { of: MatrixLimits }) {
  const data = operabilityData(of), table = limitsTable(of);
  return (
    <section aria-label="Operability">
      <h3>Largest {of.over} that passes <small>{of.unit}</small></h3>
      {of.axes.length === 2 ? <Crossed of={of} /> : <Table table={{ ...table, title: '', look: 'plain limits' }} sortable copyable />}
      {of.cells.some((c) => c.decided && c.reason) ? <p class="brief">* {of.cells.find((c) => c.decided && c.reason)!.reason}</p> : null}
      {of.alpha === null ? null : <p class="brief">The limit times alpha = {of.alpha} is in the report.</p>}
      {of.axes.length ? (
        <div class="limitdrawings drawn">
          <div><OperabilityChart all={data} /></div>
          {headingAxis(data) >= 0 ? <div><OperabilityRose all={data} /></div> : null}
          {of.months.length ? <div><Workability months={data.months!} year={data.year ?? 0} /></div> : null}
        </div>
      ) : null}
    </section>
  );
}
