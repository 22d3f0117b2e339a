// Comparison of runs: differing keys of their models, and results with their difference from the first.
import type { ComponentChildren } from 'preact';
import { change, differenceTable, modelDifferences, resultRows, resultTable, runColours, shownFactor, shownUnitName, type KeyDifference, type ResultRow } from '../../logic/runCompare';
import { keyName } from '../../logic/findings';
import { tidy } from '../../logic/units';
import { compared, runParts } from '../../state/compare';
import { runName } from '../../state/runs';
import { TableTools } from '../TableTools';

function Names() {
  return <>{compared.value.map((run, i) => <th key={run.id} scope="col" title={runName(run)}><i class="runkey" style={{ background: runColours[i] }} />{runName(run)}</th>)}</>;
}

function Keys({ list }: { list: KeyDifference[] }) {
  return (
    <table class="compare">
      <thead><tr><th scope="col">key of the model</th><Names /></tr></thead>
      <tbody>
        {list.map(({ path, values }) => (
          <tr key={path}>
            <th scope="row" title={path}>{keyName(path)} <small>{path}</small></th>
            {values.map((value, i) => <td key={i} class={i && value !== values[0] ? 'differs' : undefined}>{value ?? <small>not given</small>}</td>)}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Value({ row, i }: { row: ResultRow; i: number }) {
  const value = row.values[i] ?? null, percent = i ? change(row.values[0]!, value) : null;
  return (
    <td>
      {value === null ? '–' : tidy(value * shownFactor(row.unit), 4)}
      {percent === null ? null : <small class={Math.abs(percent) >= 0.05 ? 'differs' : undefined}> {percent > 0 ? '+' : ''}{Math.abs(percent) < 0.05 ? '0' : tidy(percent, 2)} %</small>}
    </td>
  );
}

function Results({ rows }: { rows: ResultRow[] }) {
  return (
    <table class="compare numbers">
      <thead><tr><th scope="col">result</th><Names /></tr></thead>
      <tbody>{rows.map((row) => <tr key={row.name}><th scope="row">{row.name} <small>{shownUnitName(row.unit)}</small></th>{row.values.map((_v, i) => <Value key={i} row={row} i={i} />)}</tr>)}</tbody>
    </table>
  );
}

function Section({ title, tools, children }: { title: string; tools?: ComponentChildren; children: ComponentChildren }) {
  return <section aria-label={title}><h3>{title} {tools}</h3>{children}</section>;
}

export function Differences() {
  const list = compared.value, parts = list.map((run) => runParts.value.get(run.id));
  if (list.length === 0) return <p class="empty">Select one run in the table above to see its results, or two to four to compare them.</p>;
  if (parts.some((part) => part === undefined)) return <p class="empty">Loading…</p>;
  const names = list.map(runName), models = parts.map((part) => part!.fields), known = models.filter((fields) => fields !== null);
  const keys = list.length > 1 && known.length === list.length ? modelDifferences(known) : [], rows = resultRows(parts.map((part) => part!.summary));
  return (
    <div class="comparetab">
      {list.length > 1 ? (
        <Section title="Differences in the model" tools={keys.length ? <TableTools table={() => differenceTable(names, keys)} file="model-differences" /> : null}>
          {known.length < list.length ? <p class="brief">No copy of the model is available for one of the runs.</p> : keys.length ? <Keys list={keys} /> : <p class="brief">The models have the same keys and values.</p>}
        </Section>
      ) : null}
      <Section title="Results" tools={rows.length ? <TableTools table={() => resultTable(names, rows)} file="run-results" /> : null}>
        {rows.length ? <Results rows={rows} /> : <p class="brief">No results to compare. Results of several seeds and of studies are in Storm and Study.</p>}
      </Section>
    </div>
  );
}
