// Above the report: subject, document control, parts, paper, and files.
import '../../styles/report.css';
import { signal } from '@preact/signals';
import { useEffect, useRef, useState } from 'preact/hooks';
import { get } from '../../api/client';
import type { Lay, Matrix, Run } from '../../api/types';
import { FileLink } from '../../components/FileLink';
import { download } from '../../components/download';
import type { TableData } from '../../components/document';
import { tableCsv } from '../../components/tableText';
import { makeSheet, workbook } from '../../components/workbook';
import { prepareReport } from '../../logic/reportPage';
import { stagesTable } from '../../logic/stagesTable';
import { studySheets } from '../../logic/studyTables';
import { unitSystem } from '../../logic/show';
import { byPath, errors, setKeys } from '../../state/model';
import { sayError } from '../../state/notices';
import { hasOperation, operation } from '../../state/operation';
import { busy, canMake, chooseSubject, files, leftOut, makeReport, outdated, paper, reported, subject } from '../../state/report';
import { runName, runs } from '../../state/runs';
import { StripField } from '../study/StripField';
import { printReport } from './print';
import { useUpdate } from '../useUpdate';

/** Headings of the report that is shown. */
export const headings = signal<string[]>([]);

const control: [string, string, string][] = [
  ['title', 'title', ''], ['report.client', 'client', ''], ['report.project', 'project', ''], ['report.document', 'document', 'number'],
  ['report.revision', 'revision', ''], ['report.prepared', 'prepared', 'name, date'], ['report.checked', 'checked', 'name, date']];

/** A key of the document control, written into the model when the field is left. */
function ControlField({ path, label, hint }: { path: string; label: string; hint: string }) {
  const written = String(byPath.value.get(path)?.value ?? '');
  const [typed, setTyped] = useState(written);
  useUpdate(() => setTyped(written), [written]);
  const send = (): void => { if (typed.trim() !== written) setKeys([{ path, value: typed.trim() || null }]).catch((error: unknown) => { setTyped(written); sayError(error); }); };
  return (
    <StripField id={`rp-${label}`} label={label} title={byPath.value.get(path)?.text}>
      <input
        id={`rp-${label}`} class={label} value={typed} placeholder={hint} autocomplete="off" data-written={written} onInput={(e) => setTyped(e.currentTarget.value)} onBlur={send}
        onKeyDown={(e) => { if (e.key === 'Enter') send(); if (e.key === 'Escape') setTyped(written); }}
      />
    </StripField>
  );
}

const kinds = { static: 'static run', dynamic: 'dynamic run', comparison: 'comparison', study: 'study', seeds: 'seeds' };

function optionName(run: Run): string {
  const study = run.parent && runs.value.find(({ id }) => id === run.parent);
  return `${study ? `${runName(study)}, ` : ''}${runName(run)}, ${kinds[run.kind]}`;
}

function SubjectField() {
  const value = typeof subject.value === 'string' ? subject.value : subject.value.run;
  return (
    <StripField id="rp-subject" label="report of">
      <select id="rp-subject" value={value} onChange={(e) => { const id = e.currentTarget.value; chooseSubject(id === 'statics' || id === 'operation' ? id : { run: id }); }}>
        <option value="statics">statics of the model</option>
        {hasOperation.value ? <option value="operation">stages of the operation</option> : null}
        {reported.value.length ? (
          <optgroup label="Runs and studies">
            {reported.value.map((run) => <option key={run.id} value={run.id}>{optionName(run)}</option>)}
          </optgroup>
        ) : null}
      </select>
    </StripField>
  );
}

/** Sections to leave out, by their headings. */
function Parts() {
  const box = useRef<HTMLDetailsElement>(null);
  useEffect(() => {
    const close = (e: Event): void => { if (box.current && !box.current.contains(e.target as Node)) box.current.open = false; };
    addEventListener('pointerdown', close);
    return () => removeEventListener('pointerdown', close);
  }, []);
  const out = leftOut.value.filter((heading) => headings.value.includes(heading)).length;
  const toggle = (heading: string, kept: boolean): void => { leftOut.value = kept ? leftOut.value.filter((h) => h !== heading) : [...leftOut.value, heading]; };
  return (
    <div class="stripfield">
      <span class="label">parts</span>
      <details
        class="parts"
        ref={box}
        onKeyDown={(e) => { if (e.key === 'Escape' && box.current!.open) { e.stopPropagation(); box.current!.open = false; box.current!.querySelector('summary')?.focus(); } }}
      >
        <summary class="button">{headings.value.length === 0 ? 'all' : `${headings.value.length - out} of ${headings.value.length}`}</summary>
        <fieldset>
          <legend>For display and print; the HTML file contains all parts</legend>
          {headings.value.map((heading) => (
            <label key={heading}><input type="checkbox" checked={!leftOut.value.includes(heading)} onChange={(e) => toggle(heading, e.currentTarget.checked)} /> {heading}</label>
          ))}
        </fieldset>
      </details>
    </div>
  );
}

/** Commands for the report; that of the open model is made first if it is outdated. */
async function print(): Promise<void> {
  if (canMake.value && (!files.value || outdated.value)) await makeReport();
  if (files.value && !(canMake.value && outdated.value)) printReport(files.value.report, (page) => prepareReport(page, leftOut.value, paper.value));
}

/** Tables of the reported results. */
async function tables(): Promise<TableData[]> {
  if (subject.value === 'operation') return operation.value ? [stagesTable(operation.value)] : [];
  const run = runs.value.find(({ id }) => id === files.value?.name);
  if (!run) return [];
  if (run.kind === 'study') return studySheets(await get<Matrix>(`runs/${run.id}/matrix`), [], {}, null);
  if (run.kind === 'comparison') return [];
  const lay = await get<Lay>(`runs/${run.id}/statics`);
  return [...Object.values(lay.tables ?? {}), ...Object.values(lay.run_tables ?? {})];
}

async function saveWorkbook(): Promise<void> {
  const list = await tables();
  if (list.length && files.value) download(`${files.value.name}.xlsx`, workbook(list.map((table) => makeSheet(table))));
}

function Files() {
  const made = files.value, isComparison = runs.value.find(({ id }) => id === made?.name)?.kind === 'comparison';
  return (
    <div class="reportfiles">
      {canMake.value && made ? <button type="button" disabled={busy.value} onClick={() => void makeReport()}>{busy.value ? 'Making …' : 'Update'}</button> : null}
      <button type="button" class="main" disabled={busy.value || (!made && !canMake.value)} title={`Print: choose "Save as PDF" as the printer`} onClick={() => void print()}>PDF</button>
      {made ? (
        <>
          <FileLink path={made.report} name={`${made.name}.html`}>HTML</FileLink>
          {made.csv ? <FileLink path={made.csv} name={`${made.name}.csv`}>CSV</FileLink> : subject.value === 'operation' && operation.value ? <button type="button" onClick={() => download('operation.csv', new Blob([tableCsv(stagesTable(operation.value!))], { type: 'text/csv' }))}>CSV</button> : null}
          <button type="button" disabled={isComparison} title="Tables of the report as a workbook" onClick={() => void saveWorkbook().catch(sayError)}>XLSX</button>
        </>
      ) : null}
    </div>
  );
}

export function ReportStrip() {
  const usualPaper = unitSystem === 'us' ? 'Letter' : 'A4';
  return (
    <section class="studystrip reportstrip" aria-label="Report">
      <div class="stripfields">
        <SubjectField />
        <Parts />
        <StripField id="rp-paper" label="paper" title="Reports use the units of the page, on A4 paper, or Letter for US customary units. A different paper size applies to the PDF only.">
          <select id="rp-paper" value={paper.value} onChange={(e) => { paper.value = e.currentTarget.value as typeof paper.value; }}>
            <option value="own">{usualPaper} (default for the units)</option>
            {usualPaper === 'A4' ? <option value="letter">Letter</option> : <option value="A4">A4</option>}
          </select>
        </StripField>
        <Files />
      </div>
      <div class="stripfields control">{control.map(([path, label, hint]) => <ControlField key={path} path={path} label={label} hint={hint} />)}</div>
      {errors.value.length ? <p class="failuretext" role="alert">The model has errors: correct them first.</p> : null}
    </section>
  );
}
