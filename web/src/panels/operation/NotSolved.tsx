// Shown if there are no solved stages: the reason, and what to do.
import { stageCount } from '../../logic/operationKeys';
import { byPath, errors } from '../../state/model';
import { hasOperation, solveOperation, solving } from '../../state/operation';

export function NotSolved() {
  if (!hasOperation.value) return <p class="empty">The model has no operation on the line: select one above the picture.</p>;
  if (solving.value) return <p class="empty">The stages are being solved.</p>;
  if (errors.value.length > 0) return <p class="empty">The model has errors. Correct them, then solve the stages.</p>;
  return <p class="empty">The stages are not solved yet. <button type="button" disabled={stageCount(byPath.value) === 0} onClick={() => void solveOperation()}>Solve them</button></p>;
}
