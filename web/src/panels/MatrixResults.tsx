// What the cases of a study gave so far: counts, a chart, the case that is chosen, limits of operability.
import { useState } from 'preact/hooks';
import type { Matrix, MatrixCase, MatrixLimits, Run } from '../api/types';
import { cellsOver, spreadAxes, tally, type Cell } from '../logic/studies';
import { tidy } from '../logic/units';
import { bullets, withoutPaths } from '../logic/findings';
import { setKeys } from '../state/model';
import { say, sayError } from '../state/notices';
import { reportAddress, reportToShow, runName, select, tableAddress } from '../state/runs';
import { matrix } from '../state/studies';
import { axisName, axisWord, CaseMap, Curve } from './MatrixChart';
import { ReportLinks } from './ReportLinks';
import { Standing } from './RunResults';
import { Findings } from './Findings';

/** A key of one item; a pattern stands for several. */
const plain = (key: string): boolean => !/[*]|\[[^\]\d]/.test(key);

async function put(m: Matrix, one: MatrixCase): Promise<void> {
  try {
    await setKeys(m.inputs.map((input, i) => ({ path: input.key, value: one.words[i]! })));
    select(null);
    say(`The model has the values of case ${one.number}`);
  } catch (error) { sayError(error); }
}

function Chosen({ m, cell }: { m: Matrix; cell: Cell }) {
  const one = cell.cases.find((c) => c.state === 'failed') ?? cell.cases.reduce<MatrixCase | undefined>((a, b) => (a && (a.utilisation ?? 0) >= (b.utilisation ?? 0) ? a : b), undefined);
  if (!one) return null;
  return (
    <section class="chosencase" aria-label="Case">
      <h3>Case {one.number}{one.seed === null ? '' : `, seed ${one.seed}`}{cell.cases.length > 1 ? ` (worst of ${cell.cases.length})` : ''}</h3>
      <table class="minmax"><tbody>
        {m.inputs.map((input, i) => <tr key={input.key}><th scope="row">{input.key}</th><td>{one.words[i]}</td></tr>)}
        {m.outputs.map((output, i) => <tr key={output.name}><th scope="row" title={output.name}>{output.name.replace(/^(static|dynamic|operation)\./, '')} <small>{output.unit}</small></th><td>{one.values[i] === null || one.values[i] === undefined ? '–' : tidy(one.values[i]!, 4)}</td></tr>)}
      </tbody></table>
      {one.state === 'failed' ? <p class="fault">{withoutPaths(one.reason)}</p> : one.state === 'open' ? <p class="brief">Not computed yet.</p> : <p class={one.passed ? 'brief' : one.verdict === 'reserved' ? 'note' : 'fault'}>{one.governing ? `${one.governing}: ${one.utilisation === null ? '' : tidy(one.utilisation, 3)}` : ''}{one.verdict === 'exceeded' ? ', exceeded' : one.obstacle ? `; passes with reservations: ${one.obstacle}` : ''}</p>}
      <button type="button" disabled={!m.inputs.every((i) => plain(i.key))} title="Sets the keys of the open model to the values of this case" onClick={() => void put(m, one)}>Open this case</button>
    </section>
  );
}

/** One key varied: a list of limits; two: a table, rows over the first. */
function Limits({ of }: { of: MatrixLimits }) {
  const [rows, columns] = of.axes;
  const shown = (at: number[]): string => {
    const cell = of.cells.find((c) => c.at.every((i, k) => i === at[k]));
    if (!cell || !cell.decided) return '?';
    return `${cell.limit === null ? 'none' : `${cell.beyond ? '≥ ' : ''}${tidy(cell.limit, 4)}`}${cell.reason ? ' *' : ''}`;
  };
  const why = (at: number[]): string => {
    const cell = of.cells.find((c) => c.at.every((i, k) => i === at[k]));
    return cell ? (cell.decided ? cell.governing : cell.reason) : '';
  };
  const remarked = of.cells.filter((c) => c.decided && c.reason);
  return (
    <section aria-label="Operability">
      <h3>Largest {of.over} that passes <small>{of.unit}</small></h3>
      {of.axes.length > 2 ? <p class="brief">{of.cells.length} limits, in the report.</p> : (
        <div class="scrolled"><table class="minmax limits">
          {columns ? null : rows ? <thead><tr><th scope="col">{axisName(rows)}</th><th scope="col">limit</th><th scope="col">then exceeded</th></tr></thead> : null}
          {columns ? <thead><tr><th scope="col">{rows!.key.split('.').at(-1)}\{columns.key.split('.').at(-1)}</th>{columns.words.map((_w, i) => <th key={i} scope="col">{axisWord(columns, i)}</th>)}</tr></thead> : null}
          <tbody>{(rows?.words ?? ['']).map((_w, j) => (
            <tr key={j}><th scope="row">{rows ? axisWord(rows, j) : ''}</th>{columns ? columns.words.map((_c, i) => <td key={i} title={why([j, i])}>{shown([j, i])}</td>) : <><td>{shown(rows ? [j] : [])}</td><td class="plain">{why(rows ? [j] : [])}</td></>}</tr>
          ))}</tbody>
        </table></div>
      )}
      {remarked.length ? (
        <details class="remarks"><summary>* {remarked.length === 1 ? '1 limit has' : `${remarked.length} limits have`} to be read with care</summary>
          <ul class="events">{remarked.map((c, i) => <li key={i}>{c.at.map((j, k) => axisWord(of.axes[k]!, j)).join(', ')}: {c.reason}</li>)}</ul>
        </details>
      ) : null}
      {of.alpha === null ? null : <p class="brief">Before the alpha factor of {of.alpha}.</p>}
      {of.year === null ? null : <p class="brief">Workable {tidy(100 * of.year, 3)} % of the year{of.months.length === 12 ? `; by month ${of.months.map((p) => tidy(100 * p, 2)).join(', ')} %` : ''}.</p>}
    </section>
  );
}

function Charts({ m }: { m: Matrix }) {
  const [output, setOutput] = useState(0);
  const [fixed, setFixed] = useState<Record<number, number>>({});
  const [cell, setCell] = useState<Cell | null>(null);
  const spread = spreadAxes(m), axes = spread.slice(0, 2).reverse(), rest = spread.slice(2);
  if (m.outputs.length === 0) return null;
  const cells = cellsOver(m, axes, fixed, output);
  const chart = { m, axes, cells, output, chosen: cell, choose: setCell };
  const now = cell ? cells.flat().find((c) => c.cases[0]?.number === cell.cases[0]?.number) ?? null : null;
  return (
    <>
      <select class="wide" aria-label="Result" value={output} onChange={(e) => setOutput(Number(e.currentTarget.value))}>{m.outputs.map((o, i) => <option key={o.name} value={i}>{o.name}{o.unit ? ` [${o.unit}]` : ''}</option>)}</select>
      {rest.map((a) => (
        <div key={a} class="row wide"><label for={`fix-${a}`}>{m.inputs[a]!.key}</label>
          <select id={`fix-${a}`} value={fixed[a] ?? 0} onChange={(e) => setFixed({ ...fixed, [a]: Number(e.currentTarget.value) })}>{m.inputs[a]!.words.map((word, i) => <option key={i} value={i}>{word}</option>)}</select></div>
      ))}
      {axes.length === 2 ? <CaseMap {...chart} /> : axes.length === 1 ? <Curve {...chart} /> : null}
      {now ? <Chosen m={m} cell={now} /> : axes.length ? <p class="brief">Choose a case in the chart to see it.</p> : null}
    </>
  );
}

export function MatrixResults({ run }: { run: Run }) {
  const m = matrix.value;
  return (
    <section class="results ofrun" aria-label="Results of the study">
      <h2>{runName(run)} <small>study{m ? `, ${m.analysis}` : ''}</small></h2>
      {run.note ? <p class="note">{run.note}</p> : null}
      {run.state === 'done' ? null : <Standing run={run} />}
      {m ? (
        <>
          {m.cases.length ? <p class="standing">{tally(m)}</p> : null}
          {m.operability ? <Limits of={m.operability} /> : null}
          {m.cases.length ? <Charts m={m} /> : null}
          {run.has_results ? <div class="acts"><ReportLinks file={reportAddress(run.id)} show={reportToShow(run.id)} name={`${run.id}.html`} /><a class="button" href={tableAddress(run.id)} download={`${run.id}.csv`}>Table (CSV)</a></div> : null}
          <Findings list={bullets(m.findings, [])} />
        </>
      ) : run.has_results ? <p class="brief">Loading…</p> : null}
      <button type="button" class="back" onClick={() => select(null)}>Back to the model</button>
    </section>
  );
}
