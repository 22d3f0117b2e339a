// Status of a run: waiting, running, failed, or its computed duration.
import type { Run, RunSummary } from '../api/types';
import { withoutPaths } from '../logic/findings';
import { tidy } from '../logic/units';
import { cancelRun, runSummary } from '../state/runs';
import { calmLay } from '../state/shown';

/** Only with a pipe. */
function impacts(d: NonNullable<RunSummary['dynamic']>): string {
  if (!calmLay.value?.key) return '';
  return d.impact_count === 1 ? ', 1 impact' : `, ${d.impact_count} impacts`;
}

export function Standing({ run }: { run: Run }) {
  const d = runSummary.value?.dynamic;
  switch (run.state) {
    case 'failed': return <p class="standing bad" role="alert"><b>This run failed.</b> {withoutPaths(run.message)}</p>;
    case 'queued': return <p class="standing">Waiting for the previous run.</p>;
    case 'running': return <p class="standing">Running: {Math.round(100 * run.progress)} %{run.time !== undefined ? `, t = ${tidy(run.time, 4)} s` : ''}. Results are available when it is finished. {run.parent ? null : <button type="button" onClick={() => void cancelRun(run.id)}>Cancel</button>}</p>;
    case 'cancelled': return <p class="standing warn"><b>Cancelled.</b> {d ? `Results of the first ${tidy(d.duration, 5)} s are shown.` : run.message}</p>;
    default: return d ? <p class="standing">{tidy(d.duration, 5)} s, seed {d.seed}{impacts(d)}</p> : null;
  }
}
