// Other tabs of the dock: the result as a table, governing checks, all cases, the study file.
import { Table } from '../../components/Table';
import { download } from '../../components/download';
import { rangeText } from '../../logic/laytable';
import { casesTable, governingCounts, governingTable, limitsTable, resultTable } from '../../logic/studyTables';
import { fileName } from '../../state/model';
import { chosenCase, editedFile, file, isPlainTable, lay, layTable, matrix, output, plainFile, rejection } from '../../state/studies';
import { LayRows } from './LayRows';
import { axes, cells, shape } from './shown';

const nothing = <p class="empty">No results yet.</p>;

const kShown = 1000;

const chooseAction = (name: string) => (
  { act: () => { chosenCase.value = Number(name); }, title: 'Show this case', chosen: name === String(chosenCase.value) });

export function CasesTab() {
  const m = matrix.value;
  if (!m) return layTable.value ? <LayRows of={layTable.value.of} /> : nothing;
  return (
    <>
      {m.cases.length > kShown ? <p class="brief">The first {kShown} of {m.cases.length} cases; all are in the files.</p> : null}
      <Table table={casesTable(m, m.cases.slice(0, kShown))} sortable copyable file="cases" rowAction={chooseAction} />
    </>
  );
}

export function TableTab() {
  const m = matrix.value;
  if (!m) return layTable.value ? <LayRows of={layTable.value.of} /> : nothing;
  if (m.operability) return <Table table={limitsTable(m.operability)} sortable copyable file="limits" />;
  return shape.value === 'grid' ? <Table table={resultTable(m, axes.value, cells.value, output.value)} copyable file="table" /> : <CasesTab />;
}

export function GoverningTab() {
  const m = matrix.value;
  if (!m || m.cases.length === 0) return nothing;
  return (
    <>
      {shape.value === 'grid' ? <Table table={governingTable(m, axes.value, cells.value)} copyable file="governing" /> : null}
      <Table table={governingCounts(m)} sortable copyable />
    </>
  );
}

/** The lay table over one key has no study file, but a command line. */
function command(): string {
  const option = { tension: '--tension', lay_back: '--lay-back', depth: '--depth' }[lay.value.vary];
  return `overbend lay-table ${fileName.value || 'model.yaml'} ${option} '${rangeText(lay.value)}' -o table`;
}

export function StudyFileTab() {
  const text = isPlainTable.value && editedFile.value === null ? command() : file.value;
  if (isPlainTable.value && editedFile.value === null) return <div class="studyfile"><p class="brief">This table at the command line:</p><pre>{text}</pre></div>;
  return (
    <div class="studyfile">
      <div class="acts">
        <button type="button" onClick={() => void navigator.clipboard.writeText(text)}>Copy</button>
        <button type="button" title="For the command line, or a cluster: overbend study study.yaml" onClick={() => download('study.yaml', new Blob([text], { type: 'text/yaml' }))}>Download</button>
        <button type="button" disabled={editedFile.value === null} onClick={() => { editedFile.value = null; rejection.value = ''; }}>Back to the fields above</button>
      </div>
      <textarea
        aria-label="Study file" spellcheck={false} rows={Math.max(8, text.split('\n').length)} value={text}
        onInput={(e) => { const typed = e.currentTarget.value; editedFile.value = typed === plainFile.value ? null : typed; }}
      />
    </div>
  );
}
