// Reason for the missing solution, with a link to the error; the last valid solution is shown in grey.
import { keyName, withoutPaths } from '../../logic/findings';
import { leadToDiagnostic } from '../../state/lead';
import { errors } from '../../state/model';
import { calmLay, shownFailure } from '../../state/shown';

export function Failure() {
  const bad = shownFailure.value, error = errors.value[0];
  if (!bad) return null;
  return (
    <div class="failure" role="alert" data-clear>
      <b>{bad.what || 'No solution'}{bad.where ? `: ${bad.where}` : ''}</b>
      <p>{withoutPaths(bad.why)}</p>
      {error ? <button type="button" onClick={() => leadToDiagnostic(error)}>Show {error.key ? keyName(error.key) : `line ${error.line}`}</button> : null}
      {calmLay.value !== null ? <p class="brief">The last valid solution is shown in grey.</p> : null}
    </div>
  );
}
