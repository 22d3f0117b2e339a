// Key results in columns: static, storm extremes, and the change relative to a reference.
import { changeText, resultRows, type ResultRow } from '../logic/resultRows';
import { numberIn, text, unitName } from '../logic/show';
import { tidy, twin } from '../logic/units';
import { comparison, compareWithNow, compareWithRun } from '../state/comparison';
import { calmLay, shownFailure, shownRun } from '../state/shown';
import { runName, runs, runSummary } from '../state/runs';
import { openMenuBelow } from './Menu';
import { SeekButton } from './SeekDialog';

/** Solver round-off is shown as zero. */
const quiet = (value: number): number => (Math.abs(value) < 1e-9 ? 0 : value);
const shown = (value: number | null, unit: string): string => (value === null ? '' : unit === '%' ? tidy(100 * value, 3) : numberIn(quiet(value), unit));
const unit = (row: ResultRow): string => (row.unit === '%' ? '%' : unitName(row.unit));

function Row({ row, storm, compared }: { row: ResultRow; storm: boolean; compared: boolean }) {
  const { name, result, compared: reference } = row, value = row.static!;
  return (
    <tr class="kv" title={`${row.title ?? ''} ${row.unit === '%' ? '' : twin(text(value, row.unit, 6))}`.trim()}>
      <th scope="row">
        {name} <small>{unit(row)}</small>
        {result ? <SeekButton goal={{ name, result, unit: unitName(row.unit), si: value }} /> : null}
      </th>
      <td>{shown(value, row.unit)}</td>
      {storm ? <td>{shown(row.storm, row.unit)}</td> : null}
      {compared ? <td title={reference === null ? undefined : `was ${shown(reference, row.unit)} ${unit(row)}`}>{reference === null ? '' : changeText(value, reference)}</td> : null}
    </tr>
  );
}

function chooseComparison(element: Element): void {
  const known = runs.value.filter((run) => run.has_results && !run.parent && (run.kind === 'static' || run.kind === 'dynamic'));
  openMenuBelow([
    { name: 'No comparison', act: () => { comparison.value = null; } },
    { name: 'The present model', act: compareWithNow },
    ...known.slice(0, 15).map((run) => ({ name: runName(run), act: () => void compareWithRun(run.id, runName(run)) })),
  ], element);
}

export function ResultsTable() {
  const lay = calmLay.value;
  if (!lay) return null;
  const storm = (shownRun.value && runSummary.value?.dynamic) || null, compared = comparison.value;
  const rows = resultRows(lay, storm, compared?.lay ?? null);
  if (rows.length === 0) return null;
  return (
    <section class={`results${shownFailure.value ? ' old' : ''}`} aria-label="Key results">
      <h3>
        Results
        <button type="button" class="link" aria-haspopup="menu" onClick={(e) => chooseComparison(e.currentTarget)}>{compared ? `compared with ${compared.name}` : 'compare with'} ▾</button>
      </h3>
      <table class="keyresults">
        <thead>
          <tr><th scope="col" /><th scope="col">static</th>{storm ? <th scope="col">storm worst</th> : null}{compared ? <th scope="col">change</th> : null}</tr>
        </thead>
        <tbody>{rows.map((row) => <Row key={row.name} row={row} storm={storm !== null} compared={compared !== null} />)}</tbody>
      </table>
    </section>
  );
}
