// The verdict on the results shown: its kind, the governing check, and its utilisation.
import { governing, ranked, regionName } from '../logic/checks';
import { keyName, withoutPaths } from '../logic/findings';
import { tidy } from '../logic/units';
import type { Check, Verdict } from '../api/types';
import { leadToDiagnostic } from '../state/lead';
import { canUndo, errors, undo } from '../state/model';
import { changes, resetLive } from '../state/live';
import { openedCheck, shownChecks, shownVerdict } from '../state/verdict';
import { canFindNearest, findingNearest, takeNearest } from '../state/nearest';
import { shownFailure } from '../state/shown';
import { showDockTab, workspace } from '../state/workspace';

const titles: Record<Verdict['kind'], string> = { passed: 'Passes', reserved: 'Passes with reservations', exceeded: 'Fails', 'not judged': 'Not judged' };

/** "laying criterion I in the overbend". */
const where = (check: Check): string => `${check.name}${check.line ? `, ${check.line}` : check.region === 'line' ? '' : ` in the ${regionName(check.region)}`}`;

function showSheet(check: Check): void {
  openedCheck.value = check.id;
  showDockTab(['lay', 'operation', 'storm'].includes(workspace.value) ? workspace.value : 'lay', 'checks');
}

function Governing({ check }: { check: Check }) {
  const used = check.utilisation ?? 0;
  return (
    <>
      <p class="governing">governing: {where(check)}</p>
      <div class="bar" role="presentation"><i style={{ width: `${Math.min(100, 100 * used)}%` }} /></div>
      <p>
        <b class="used">{tidy(used, 3)}</b> of the limit ·{' '}
        <button type="button" class="link" onClick={() => showSheet(check)}>calculation sheet ›</button>
      </p>
    </>
  );
}

/** Reason for the missing solution, and ways to restore one. */
function NotSolved({ what, where: place, why }: { what: string; where: string; why: string }) {
  const error = errors.value[0], trying = changes.value.length > 0;
  return (
    <div class="verdict unsolved" role="alert">
      <h2>Not solved</h2>
      <p><b>{what}{place ? `: ${place}` : ''}</b></p>
      <p>{withoutPaths(why)}</p>
      <p class="acts">
        {error ? <button type="button" onClick={() => leadToDiagnostic(error)}>Show {error.key ? keyName(error.key) : `line ${error.line}`}</button> : null}
        {trying ? <button type="button" onClick={resetLive}>Reset to the model values</button> : canUndo.value ? <button type="button" onClick={undo}>Undo the last change</button> : null}
        {canFindNearest.value ? (
          <button type="button" disabled={findingNearest.value} title="Between the last solved state and the present one" onClick={() => void takeNearest()}>
            {findingNearest.value ? 'Searching…' : 'Find the nearest solution'}
          </button>
        ) : null}
      </p>
      <p class="brief">The picture shows the last solution, dimmed.</p>
    </div>
  );
}

export function VerdictCard() {
  const failure = shownFailure.value, verdict = shownVerdict.value;
  if (failure) return <NotSolved {...failure} />;
  if (!verdict) return null;
  const worst = ranked(governing(shownChecks.value))[0];
  return (
    <div class={`verdict ${verdict.kind.replace(' ', '-')}`} title={verdict.words} role="status">
      <h2>{titles[verdict.kind]}</h2>
      {verdict.because && verdict.kind !== 'passed' ? <p class="because">{verdict.because}</p> : null}
      {worst ? <Governing check={worst} /> : null}
    </div>
  );
}
