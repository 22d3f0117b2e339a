// Above the table: the study and result shown, its progress, and its files.
import type { VNode } from 'preact';
import type { Run } from '../../api/types';
import { download } from '../../components/download';
import { makeSheet, workbook } from '../../components/workbook';
import { depthLimits } from '../../logic/layGrid';
import { duration } from '../../logic/show';
import { baseCase, kUtilisation, resultTitle } from '../../logic/studies';
import { studySheets } from '../../logic/studyTables';
import { sayError } from '../../state/notices';
import { cancelRun, reportPath, resumeRun, runName, tablePath, timeToFinish } from '../../state/runs';
import { fixed, layTable, limits, matrix, output, showStudy, shownId, shownRun, studies } from '../../state/studies';
import { FileLink } from '../../components/FileLink';
import { ReportLinks } from '../ReportLinks';
import { CaseCurve, CaseMap, CaseSwings } from './CaseDrawing';
import { limitsDrawing } from './Limits';
import { saveDrawing } from './saveDrawing';
import { axes, cells, isLayGrid, shape } from './shown';

function when(run: Run): string {
  const date = new Date(1000 * run.started), today = new Date().toDateString() === date.toDateString();
  return run.started ? date.toLocaleString([], today ? { hour: '2-digit', minute: '2-digit' } : { day: 'numeric', month: 'short', hour: '2-digit', minute: '2-digit' }) : 'waiting';
}

/** Studies of the folder. */
export function StudyChoice() {
  if (studies.value.length === 0) return null;
  return (
    <select aria-label="Study shown" value={shownId.value ?? ''} onChange={(e) => showStudy(e.currentTarget.value || null)}>
      <option value="">{layTable.value ? 'lay table' : 'earlier studies …'}</option>
      {studies.value.map((run) => <option key={run.id} value={run.id}>{runName(run)}, {run.kind === 'study' ? 'study' : run.kind === 'seeds' ? 'seeds' : `comparison, ${run.of}`}, {when(run)}</option>)}
    </select>
  );
}

export function ResultChoice() {
  const m = matrix.value!;
  return (
    <select class="resultchoice" aria-label="Result" value={output.value} onChange={(e) => { output.value = Number(e.currentTarget.value); }}>
      <option value={kUtilisation}>{resultTitle(m, kUtilisation)}</option>
      {m.outputs.map((o, i) => <option key={o.name} value={i} title={o.name}>{resultTitle(m, i)}</option>)}
    </select>
  );
}

export function Progress({ run }: { run: Run }) {
  const going = run.state === 'running' || run.state === 'queued', left = run.state === 'running' ? timeToFinish(run) : null;
  if (run.state === 'done') return null;
  return (
    <div class={`studyprogress ${run.state}`} role="status">
      {going ? <div class="bar" role="progressbar" aria-label="Progress" aria-valuemin={0} aria-valuemax={100} aria-valuenow={Math.round(100 * run.progress)}><i style={{ width: `${100 * run.progress}%` }} /></div> : null}
      <span>{run.state === 'queued' ? 'waiting for the previous run' : run.message || run.state}{left === null ? '' : `, about ${duration(left)} left`}</span>
      {going ? <button type="button" onClick={() => void cancelRun(run.id)}>Cancel</button> : null}
      {run.resumable ? <button type="button" onClick={() => void resumeRun(run.id)}>Resume</button> : null}
    </div>
  );
}

/** Content of PNG and SVG; null if there is no drawing. */
function drawing(): VNode | null {
  const m = matrix.value, drawn = m && { m, axes: axes.value, cells: cells.value, output: output.value, chosen: null, width: 760 };
  if (!m || !drawn) return null;
  if (m.operability) return limitsDrawing(m.operability);
  const base = baseCase(m);
  if (base) return <CaseSwings m={m} base={base} output={output.value} width={760} />;
  return shape.value === 'grid' ? <CaseMap {...drawn} /> : shape.value === 'curve' ? <CaseCurve {...drawn} /> : null;
}

function saveWorkbook(name: string): void {
  const m = matrix.value!, [x, y] = axes.value;
  const tensions = isLayGrid.value ? depthLimits(m, x!, y!, fixed.value, limits.value) : null;
  download(`${name}.xlsx`, workbook(studySheets(m, axes.value, fixed.value, tensions).map((table) => makeSheet(table))));
}

function MatrixFiles({ run }: { run: Run }) {
  const save = (kind: 'png' | 'svg'): void => { const drawn = drawing(); if (drawn) saveDrawing(drawn, run.id, kind).catch(sayError); };
  const drawable = shape.value !== 'list' && !(matrix.value!.operability && matrix.value!.operability.axes.length === 0);
  return (
    <>
      {run.has_results ? <FileLink path={tablePath(run.id)} name={`${run.id}.csv`} title="A row for every case">CSV</FileLink> : null}
      <button type="button" title="A workbook: the table, what governs, the tensions, all cases" onClick={() => saveWorkbook(run.id)}>XLSX</button>
      {drawable ? <><button type="button" onClick={() => save('png')}>PNG</button><button type="button" onClick={() => save('svg')}>SVG</button></> : null}
    </>
  );
}

export function Files() {
  const run = shownRun.value;
  if (!run) {
    return layTable.value ? (
      <>
        <FileLink path="lay-table.csv" name="lay-table.csv">CSV</FileLink>
        <FileLink path="lay-table.xlsx" name="lay-table.xlsx">XLSX</FileLink>
      </>
    ) : null;
  }
  return (
    <>
      {matrix.value ? <MatrixFiles run={run} /> : run.has_results ? <FileLink path={tablePath(run.id)} name={`${run.id}.csv`}>CSV</FileLink> : null}
      {run.has_results && run.kind !== 'seeds' ? <ReportLinks path={reportPath(run.id)} name={`${run.id}.html`} /> : null}
    </>
  );
}
