// The right column: verdict, findings and key results of the content of the picture.
import { shownFindings } from '../state/findings';
import { stageName } from '../logic/operation';
import { chosenStage } from '../state/operation';
import { calmLay, ofRun, shownFailure, shownRun, shownStage } from '../state/shown';
import { runName, select } from '../state/runs';
import { Findings } from './Findings';
import { Stale } from './Stale';
import { Standing } from './Standing';
import { ResultsTable } from './ResultsTable';
import { VerdictCard } from './VerdictCard';
import '../styles/results.css';

/** Source of these results, if not the present model. */
function Whose() {
  const run = shownRun.value, stage = shownStage.value;
  if (run) {
    return (
      <div class="whoseresults">
        <h3>{runName(run)} <button type="button" class="tiny" aria-label="Back to the model" title="Back to the model" onClick={() => select(null)}>✕</button></h3>
        {run.note ? <p class="note">{run.note}</p> : null}
        <Standing run={run} />
        <Stale brief />
        {run.parent ? <button type="button" class="link" onClick={() => select(run.parent!)}>Back to the study</button> : null}
      </div>
    );
  }
  return stage ? <div class="whoseresults"><h3>Stage {stageName(stage, chosenStage.value)}</h3></div> : null;
}

export function ResultsColumn() {
  const none = !calmLay.value && !shownFailure.value;
  // for a run without results, those of the model would be mistaken for them
  if (shownRun.value && !ofRun.value) return <Whose />;
  return (
    <>
      <Whose />
      <VerdictCard />
      {none ? <p class="empty">Results appear here as soon as the model is complete.</p> : null}
      <Findings list={shownFindings.value} />
      <ResultsTable />
    </>
  );
}
