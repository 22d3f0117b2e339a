// Above the dock: the run and seed shown, its progress, and whether it is outdated.
import { withoutPaths } from '../../logic/findings';
import { duration as timeText, numberIn, unitName } from '../../logic/show';
import { tidy } from '../../logic/units';
import type { Run } from '../../api/types';
import { cancelRun, runName, select, selected, timeToFinish } from '../../state/runs';
import { stormCases, storms, stormStudy } from '../../state/storm';
import { Stale } from '../Stale';

const stateNames: Record<Run['state'], string> = { queued: 'waiting', running: 'running', done: '', failed: 'failed', cancelled: 'cancelled' };

function Progress({ run }: { run: Run }) {
  const left = timeToFinish(run), percent = Math.round(100 * run.progress);
  return (
    <>
      <div class="bar" role="progressbar" aria-label="Progress of the run" aria-valuemin={0} aria-valuemax={100} aria-valuenow={percent}>
        <i style={{ width: `${percent}%` }} />
      </div>
      <span>
        {run.state === 'queued' ? 'waiting for the previous run' : `${percent} %`}
        {left === null ? '' : `, ${timeText(left)} left`}
        {run.time === undefined ? '' : ` · t = ${tidy(run.time, 5)} s`}
        {run.top_tension === undefined ? '' : ` · tension ${numberIn(run.top_tension, 'N')} ${unitName('N')}`}
      </span>
      <button type="button" onClick={() => void cancelRun(run.id)}>Cancel</button>
    </>
  );
}

const withState = (text: string, run: Run): string => (stateNames[run.state] ? `${text}, ${stateNames[run.state]}` : text);

/** "seed 2 of 10"; with its title if that is more specific. */
function caseText(run: Run, index: number, count: number, noun: string): string {
  const place = `${noun} ${index + 1} of ${count}`;
  return withState(run.title === `Seed ${index + 1}` ? place : `${place}: ${run.title}`, run);
}

function listedName(run: Run): string {
  const kind = run.kind === 'seeds' ? ', seeds' : run.kind === 'comparison' ? `, ${run.of ?? 'comparison'}` : '';
  return withState(`${runName(run)}${kind}`, run);
}

function Seeds() {
  const cases = stormCases.value, index = cases.findIndex((item) => item.id === selected.value?.id);
  if (cases.length === 0) return null;
  const noun = stormStudy.value?.kind === 'seeds' ? 'seed' : 'variant';
  return (
    <select aria-label={noun === 'seed' ? 'Seed shown' : 'Variant shown'} value={selected.value?.id} onChange={(e) => select(e.currentTarget.value)}>
      {index < 0 ? <option value={selected.value?.id}>no {noun} yet</option> : null}
      {cases.map((item, i) => <option key={item.id} value={item.id} disabled={!item.has_results}>{caseText(item, i, cases.length, noun)}</option>)}
    </select>
  );
}

export function StormBar() {
  const list = storms.value, whole = stormStudy.value ?? selected.value;
  if (list.length === 0) return null;
  const going = whole && (whole.state === 'running' || whole.state === 'queued');
  return (
    <div class="stormbar" role="group" aria-label="Run shown">
      <select aria-label="Run shown" value={whole?.id ?? ''} onChange={(e) => select(e.currentTarget.value || null)}>
        <option value="">static state of the model</option>
        {list.map((run) => <option key={run.id} value={run.id}>{listedName(run)}</option>)}
      </select>
      <Seeds />
      {going ? <Progress run={whole} /> : null}
      {whole?.state === 'failed' ? <span class="failuretext" role="alert">{withoutPaths(whole.message)}</span> : null}
      {whole ? <Stale /> : null}
    </div>
  );
}
