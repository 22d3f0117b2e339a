// The stages as a table: inputs, results and status.
import { signal } from '@preact/signals';
import type { HoldPoint, Operation, OperationStage } from '../../api/types';
import { bullets } from '../../logic/findings';
import { cell, stageColumns, columnUnit, isSetting, stageLevel, stageLights, stageName, stageTable, whyNot, type StageColumn } from '../../logic/operation';
import { isStageList, listIndex, operationType } from '../../logic/operationKeys';
import { fixedIn, unitName } from '../../logic/show';
import { byPath } from '../../state/model';
import { chooseStage, chosenStage, listStages, operation, outdated, typeName } from '../../state/operation';
import { selectObject } from '../../state/workspace';
import { ListGrid } from '../grid/ListGrid';
import { NotSolved } from './NotSolved';
import { SettingCell } from './SettingCell';
import { TableTools } from '../TableTools';

const holdText = (hold: HoldPoint): string => `${hold.what}${hold.out === null ? '' : ` (at ${fixedIn(hold.out, 'm', 1)} ${unitName('m')})`}`;

export function Light({ stage }: { stage: OperationStage }) {
  const level = stageLevel(stage), light = stageLights[level];
  return <i class={`light ${level}`} role="img" aria-label={light.text} title={light.text}>{light.mark}</i>;
}

/** Without its reasons: they are the findings below. */
const shortVerdict = (text: string): string => text.split(':')[0]!.toLowerCase();

function NameCell({ stage, index, holds }: { stage: OperationStage; index: number; holds: HoldPoint[] }) {
  const chosen = chosenStage.value === index;
  return (
    <th scope="row">
      <Light stage={stage} />
      <button type="button" class="linkname" aria-pressed={chosen} disabled={!stage.values} title={stage.values ? stage.values.check || 'Show this stage' : whyNot(stage)} onClick={(e) => { e.stopPropagation(); void chooseStage(index); }}>
        {stageName(stage, index)}
      </button>
      {holds.length ? <abbr class="hold" title={`Hold before this stage: ${holds.map(holdText).join('; ')}`}>hold</abbr> : null}
    </th>
  );
}

/** Edits the list of the model as a whole: rows added, removed, pasted. */
const listEdited = signal(false);

/** Model key of an input of a listed stage; empty if stages are generated. */
function settingPath(column: StageColumn, index: number, count: number): string {
  if (!isStageList(byPath.value)) return '';
  const key = column.setting === 'tension' ? 'tension' : operationType(typeName.value)?.out;
  return key ? `operation.stages[${listIndex(typeName.value, index, count)}].${key}` : '';
}

function Row({ stage, index, columns, holds, count }: { stage: OperationStage; index: number; columns: StageColumn[]; holds: HoldPoint[]; count: number }) {
  const show = (): void => { if (stage.values) void chooseStage(index); };
  const title = (column: StageColumn): string => (column.name === 'use' ? stage.values?.check ?? '' : column.name === 'roller' ? stage.values?.largest_reaction_support ?? '' : column.title);
  const settings = columns.filter(isSetting), results = columns.filter((column) => !isSetting(column));
  return (
    <tr class={`${stageLevel(stage)}${chosenStage.value === index ? ' chosen' : ''}`} onClick={show}>
      <NameCell stage={stage} index={index} holds={holds} />
      {settings.map((column) => <SettingCell key={column.name} text={cell(column, stage)} path={settingPath(column, index, count)} title={column.title} />)}
      {stage.values
        ? results.map((column) => <td key={column.name} title={title(column)}>{cell(column, stage)}</td>).concat(<td key="verdict" class="stageverdict" title={stage.values.verdict}>{shortVerdict(stage.values.verdict)}</td>)
        : <td class="why" colSpan={results.length + 1}><p>{whyNot(stage)}</p></td>}
    </tr>
  );
}

function Head({ columns }: { columns: StageColumn[] }) {
  const settings = columns.filter(isSetting).length;
  return (
    <thead>
      <tr class="groups"><th /><th scope="colgroup" colSpan={settings}>settings</th><th scope="colgroup" colSpan={columns.length - settings + 1}>results</th></tr>
      <tr>
        <th scope="col">stage</th>
        {columns.map((column) => <th key={column.name} scope="col" title={column.title}>{column.name}<small>{columnUnit(column) || '–'}</small></th>)}
        <th scope="col" class="stageverdict" title="Verdict of the checks and findings of the stage">verdict</th>
      </tr>
    </thead>
  );
}

function Holds({ list }: { list: HoldPoint[] }) {
  if (list.length === 0) return null;
  return (
    <section class="holds" aria-label="Hold points">
      <h3>Hold points</h3>
      <ul>{list.map((hold, i) => <li key={i}><button type="button" class="link" onClick={() => void chooseStage(hold.stage)}>before stage {hold.stage + 1}</button> {holdText(hold)}</li>)}</ul>
    </section>
  );
}

/** Findings of all stages; each leads to its stage. */
function StageFindings({ stages }: { stages: OperationStage[] }) {
  const list = stages.flatMap((stage, i) => bullets(stage.findings, []).map((finding) => ({ finding, i, name: stageName(stage, i) })));
  if (list.length === 0) return null;
  return (
    <section class="holds" aria-label="Findings of the stages">
      <h3>Findings</h3>
      <ul>{list.map(({ finding, i, name }) => <li key={`${i} ${finding.full}`} title={finding.full}><button type="button" class="link" onClick={() => void chooseStage(i)}>stage {name}</button> {finding.severity}: {finding.short}</li>)}</ul>
    </section>
  );
}

/** Definition of the stages, and how to change it. */
function Tools({ solved }: { solved: Operation }) {
  return (
    <div class="tabtools">
      {isStageList(byPath.value)
        ? <button type="button" onClick={() => { listEdited.value = true; }}>Add, remove or paste stages…</button>
        : <span class="brief">Stages at even steps: change them in <button type="button" class="link" onClick={() => selectObject('operation.stages')}>their fields</button>, or <button type="button" class="link" disabled={outdated.value} onClick={() => void listStages()}>list them individually</button>.</span>}
      <TableTools table={() => stageTable(solved)} file="stages" />
    </div>
  );
}

function Stages({ solved }: { solved: Operation }) {
  const all = stageColumns(solved), columns = [...all.filter(isSetting), ...all.filter((column) => !isSetting(column))];
  return (
    <div class="scrolled">
      <table class={`stages${outdated.value ? ' old' : ''}`} aria-label="Stages of the operation">
        <Head columns={columns} />
        <tbody>
          {solved.stages.map((stage, i) => <Row key={i} stage={stage} index={i} columns={columns} holds={solved.hold_points.filter((hold) => hold.stage === i)} count={solved.stages.length} />)}
        </tbody>
      </table>
    </div>
  );
}

export function StageTable() {
  const solved = operation.value, listed = isStageList(byPath.value);
  if (listed && (listEdited.value || !solved)) {
    return (
      <div class="stagetab">
        {solved ? <div class="tabtools"><button type="button" onClick={() => { listEdited.value = false; }}>Back to the results</button></div> : <NotSolved />}
        <ListGrid path="operation.stages" />
      </div>
    );
  }
  if (!solved) return <NotSolved />;
  return (
    <div class="stagetab">
      <Tools solved={solved} />
      <Stages solved={solved} />
      <div class="below"><Holds list={solved.hold_points} /><StageFindings stages={solved.stages} /></div>
    </div>
  );
}
