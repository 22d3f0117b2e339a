// Tables of the storm's dock: statistics and extremes of the run and over seeds, roller boxes over time.
import { signal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { reactions } from '../../charts/data';
import type { TableData } from '../../components/document';
import { Table, type RowAction } from '../../components/Table';
import { withTwin } from '../../logic/show';
import { boxesTable, extremesTable, rollersTable, seedExtremes, statisticsTable, studyTable } from '../../logic/stormTables';
import { calmLay } from '../../state/shown';
import { cursor } from '../../state/look';
import { runSummary } from '../../state/runs';
import { acrossCases, stormStudy } from '../../state/storm';
import { selectObject } from '../../state/workspace';
import { FatigueResults } from '../FatigueResults';
import { Plot } from '../Plot';
import { History } from './Histories';
import { TabFrame } from './TabFrame';

interface SetProps { table: TableData; file: string; rowAction?: (name: string) => RowAction | undefined }

function Set({ table, file, rowAction }: SetProps) {
  return <Table table={table} sortable copyable file={file} rowAction={rowAction} numberTitle={(number, { unit }) => withTwin(number, unit)} />;
}

/** Switch between all seeds or variants and the single run, if both are available. */
const across = signal(true);

function Between({ whole, single }: { whole: ComponentChildren; single: ComponentChildren }) {
  const seeds = stormStudy.value?.kind === 'seeds';
  if (!stormStudy.value) return <>{single}</>;
  return (
    <>
      <div class="stormhead" role="group" aria-label="Statistics of">
        <button type="button" aria-pressed={across.value} onClick={() => { across.value = true; }}>{seeds ? 'all seeds' : 'all variants'}</button>
        <button type="button" aria-pressed={!across.value} onClick={() => { across.value = false; }}>{seeds ? 'this seed' : 'this variant'}</button>
      </div>
      {across.value ? whole : single}
    </>
  );
}

export function Statistics() {
  const d = runSummary.value?.dynamic, study = acrossCases.value;
  const more = Object.entries(calmLay.value?.run_tables ?? {});
  const single = d ? (
    <>
      <Set table={statisticsTable(d, calmLay.value)} file="storm-statistics" />
      <FatigueResults />
      {more.map(([name, table]) => <Set key={name} table={table} file={`storm-${name}`} />)}
    </>
  ) : <p class="empty">Loading…</p>;
  return (
    <TabFrame ready={d !== undefined || study !== null}>
      <Between whole={study ? <Set table={studyTable(study)} file="storm-seeds" /> : <p class="empty">Available when all have ended.</p>} single={single} />
    </TabFrame>
  );
}

export function Extremes() {
  const d = runSummary.value?.dynamic, study = acrossCases.value;
  const seeds = study ? seedExtremes(study) : null;
  const none = !d ? 'Loading…' : d.non_stationary ? `No extremes: ${d.non_stationary}.` : '';
  const single = none || !d ? <p class="empty">{none}</p> : <Set table={extremesTable(d)} file="storm-extremes" />;
  const few = <p class="empty">Extremes over seeds require at least ten seeds and a stationary storm.</p>;
  return (
    <TabFrame ready={d !== undefined || study !== null}>
      <Between whole={seeds ? <Set table={seeds} file="storm-seed-extremes" /> : few} single={single} />
    </TabFrame>
  );
}

const chosenBox = signal('');
const byRoller = signal(false);

/** Path of a box in the model: its index among those of its structure. */
function boxPath(name: string): string {
  const boxes = calmLay.value?.supports ?? [], box = boxes.find((support) => support.name === name);
  if (!box) return '';
  return `supports.${box.structure}.boxes[${boxes.filter((support) => support.structure === box.structure).indexOf(box)}]`;
}

type BoxDiagramKind = 'reaction' | 'separation' | 'all';
const boxDiagram = signal<BoxDiagramKind>('reaction');

/** Next to the table: histories of the selected box, or the maximum reactions of all. */
function BoxDiagram({ box }: { box: string }) {
  const lay = calmLay.value, kind = boxDiagram.value;
  const choice = (
    <select aria-label="Diagram of boxes" value={kind} onChange={(e) => { boxDiagram.value = e.currentTarget.value as BoxDiagramKind; }}>
      <option value="reaction">{box}: reaction</option>
      <option value="separation">{box}: separation</option>
      <option value="all">reactions of all boxes</option>
    </select>
  );
  if (kind === 'all') return <Plot data={lay ? reactions(lay, runSummary.value?.dynamic) : null} empty="Loading…" legend>{choice}</Plot>;
  return <History name={`support/${box}/${kind}`}>{choice}</History>;
}

export function Boxes() {
  const d = runSummary.value?.dynamic;
  const worst = d?.supports.length ? d.supports.reduce((best, box) => (box.reaction.max > best.reaction.max ? box : best)).name : '';
  const shown = d?.supports.some((box) => box.name === chosenBox.value) ? chosenBox.value : worst;
  const choose = (name: string): void => {
    chosenBox.value = name;
    selectObject(boxPath(name));
    cursor.value = calmLay.value?.supports.find((box) => box.name === name)?.s ?? null;
  };
  const action = (name: string): RowAction => ({ act: () => choose(name), title: 'Show this box and its reaction over time', chosen: name === shown });
  return (
    <TabFrame ready={d !== undefined && d.supports.length > 0}>
      <div class="stormhead" role="group" aria-label="Rows of the table">
        <button type="button" aria-pressed={!byRoller.value} onClick={() => { byRoller.value = false; }}>boxes</button>
        <button type="button" aria-pressed={byRoller.value} onClick={() => { byRoller.value = true; }}>rollers</button>
      </div>
      <div class="stormsplit">
        <div>
          {d && byRoller.value ? <Set table={rollersTable(d)} file="storm-rollers" rowAction={action} /> : null}
          {d && !byRoller.value ? <Set table={boxesTable(d, calmLay.value)} file="storm-boxes" rowAction={action} /> : null}
        </div>
        <div class="stormplots">{shown ? <BoxDiagram box={shown} /> : null}</div>
      </div>
    </TabFrame>
  );
}
