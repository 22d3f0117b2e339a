// Slider over the stages of the operation, under the picture.
import { columnUnit, columnsOf, cell, stageName } from '../logic/operation';
import { ofRun } from '../state/shown';
import { chooseStage, chosenStage, nextStage, operation, playing } from '../state/operation';

export function StageBar() {
  const o = operation.value, i = chosenStage.value, stage = o?.stages[i];
  if (!o || !stage || ofRun.value) return null;
  const columns = columnsOf(o).filter((c) => ['top', 'head z', 'tip', 'use'].includes(c.name) || c === columnsOf(o)[0]);
  return (
    <div class="animation stagebar" role="group" aria-label="Stages of the operation">
      <button type="button" class="main" aria-label={playing.value ? 'Pause' : 'Play the stages'} onClick={() => { playing.value = !playing.value; }}>{playing.value ? '❚❚' : '▶'}</button>
      <input type="range" aria-label="Stage" min={0} max={o.stages.length - 1} step={1} value={i} aria-valuetext={`stage ${stageName(stage, i)}`}
        onInput={(e) => { const wanted = Number(e.currentTarget.value); void chooseStage(o.stages[wanted]?.values ? wanted : nextStage(i, wanted > i ? 1 : -1)); }} />
      <output class="which" title={`stage ${stageName(stage, i)}`}>stage <b>{stageName(stage, i)}</b> of {o.stages.length}</output>
      <span class="readings">{columns.slice(0, 5).map((c) => <span key={c.name} class="reading" title={c.title}><small>{c.name}</small> {cell(c, stage)} {columnUnit(c)}</span>)}</span>
      <button type="button" class="tiny" aria-label="Back to the lay" title="Back to the lay" onClick={() => void chooseStage(-1)}>✕</button>
    </div>
  );
}
