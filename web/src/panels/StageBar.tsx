// Slider over the stages of the operation, under the picture.
import { columnUnit, stageColumns, cell, stagePlace } from '../logic/operation';
import { ofRun } from '../state/shown';
import { chooseStage, chosenStage, nextStage, operation, outdated, playing } from '../state/operation';
import { Light } from './operation/StageTable';
import { ReportLinks } from './ReportLinks';

/** Key values of a stage: progress, tension, head, clearance, utilisation. */
function Readings() {
  const solved = operation.value!, stage = solved.stages[chosenStage.value];
  if (!stage) return null;
  const all = stageColumns(solved), columns = all.filter((c) => c === all[0] || ['top', 'head z', 'end z', 'tip', 'use'].includes(c.name)).slice(0, 5);
  return <span class="readings">{columns.map((c) => <span key={c.name} class="reading" title={c.title}><small>{c.name}</small> {cell(c, stage)} {columnUnit(c)}</span>)}</span>;
}

function step(wanted: number): void {
  const index = chosenStage.value;
  void chooseStage(operation.value?.stages[wanted]?.values ? wanted : nextStage(index, wanted > index ? 1 : -1));
}

export function StageBar() {
  const solved = operation.value, i = chosenStage.value, stage = solved?.stages[i];
  if (!solved || ofRun.value) return null;
  const name = stage ? `stage ${stagePlace(stage, i, solved.stages.length)}` : 'the lay';
  return (
    <div class="animation stagebar" role="group" aria-label="Stages of the operation">
      <button type="button" class="main" aria-label={playing.value ? 'Pause' : 'Play the stages'} onClick={() => { playing.value = !playing.value; }}>{playing.value ? '❚❚' : '▶'}</button>
      <input type="range" aria-label="Stage" min={0} max={solved.stages.length - 1} step={1} value={Math.max(0, i)} aria-valuetext={name} onInput={(e) => step(Number(e.currentTarget.value))} />
      <output class="which" title={name}>
        {stage ? <><Light stage={stage} /> stage <b>{stagePlace(stage, i, solved.stages.length)}</b></> : <>{solved.stages.length} stages <small>the lay is shown</small></>}
      </output>
      <Readings />
      {stage ? <button type="button" class="tiny" aria-label="Back to the lay" title="Back to the lay" onClick={() => void chooseStage(-1)}>✕</button> : null}
      <span class={`sheet${outdated.value ? ' old' : ''}`} title={outdated.value ? 'Report of the solved stages' : undefined}>
        <ReportLinks path="operation/report.html" name="operation.html" label="Procedure sheet" title="Report of all stages, with the procedure sheet for use on board" />
      </span>
    </div>
  );
}
