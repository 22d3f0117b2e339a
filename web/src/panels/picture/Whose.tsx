// Shows that the picture is of a run, with a link back to the model.
import { ofRun } from '../../state/shown';
import { runName, select, selected } from '../../state/runs';

export function Whose() {
  const run = selected.value;
  if (!ofRun.value || !run) return null;
  return (
    <div class="whose" title={runName(run)} data-clear>
      run: <b>{runName(run)}</b>
      <button type="button" class="tiny" aria-label="Back to the model" title="Back to the model" onClick={() => select(null)}>✕</button>
    </div>
  );
}
