// Above the picture: the type of operation, and the commands that solve and design it.
import { missingPart } from '../../logic/firstOperation';
import { canSeek, operationTypes, stageCount } from '../../logic/operationKeys';
import { byPath, errors, hasModel } from '../../state/model';
import { addOperation, chosenStage, designProcedure, hasOperation, operation, operationParts, outdated, progress, solveOperation, solving, typeName } from '../../state/operation';
import { startRun } from '../../state/runs';
import { goTo } from '../../state/workspace';
import { PartFields, StagesField, TensionField, TypeField } from './StripFields';
import '../../styles/operation.css';

function Offers() {
  if (!hasModel.value) return <div class="opstrip"><p class="brief">Open or make a model first.</p></div>;
  return (
    <div class="opstrip offers" role="group" aria-label="First operation">
      <p class="brief">The model has no operation on the line. Begin with</p>
      {operationTypes.map((type) => {
        const missing = missingPart(type.id, operationParts.value);
        return <button key={type.id} type="button" disabled={missing !== ''} title={`${type.text}${missing ? `: ${missing}` : ''}`} onClick={() => void addOperation(type.id)}>{type.name}</button>;
      })}
    </div>
  );
}

/** A dynamic run of the selected stage. */
function SeaButton() {
  const stage = chosenStage.value, ready = byPath.value.get('analysis.dynamic')?.given === true;
  if (!operation.value || stage < 0) return null;
  const start = (): void => { goTo('storm'); void startRun({ kind: 'dynamic', stage: String(stage + 1) }); };
  return <button type="button" disabled={!ready} title={ready ? 'Dynamic analysis of the stage shown, with the settings of analysis.dynamic' : 'The model has no analysis.dynamic'} onClick={start}>Run dynamics for this stage</button>;
}

function Progress() {
  const p = progress.value;
  if (!solving.value) return null;
  return (
    <div class="solving" role="status">
      <div class="bar"><i style={{ width: `${p ? (100 * p.done) / p.of : 0}%` }} /></div>
      <small>{p ? `${p.done} of ${p.of} stages: ${p.name}` : 'solving…'}</small>
    </div>
  );
}

function Commands() {
  const count = stageCount(byPath.value), unready = solving.value || errors.value.length > 0;
  return (
    <div class="commands">
      <button type="button" class="main" disabled={unready || count === 0} onClick={() => void solveOperation()}>{solving.value ? 'Solving…' : count === 1 ? 'Solve the stage' : `Solve ${count} stages`}</button>
      {canSeek(typeName.value) ? <button type="button" disabled={unready || count < 2} title="Find the minimum tension within the limits for every stage, and solve all stages" onClick={() => void designProcedure()}>Design the procedure</button> : null}
      <SeaButton />
      {outdated.value && !solving.value ? <span class="note">The model has changed since these stages were solved.</span> : null}
      {errors.value.length > 0 ? <span class="failuretext">The model has errors.</span> : null}
      <Progress />
    </div>
  );
}

export function OperationStrip() {
  if (!hasOperation.value) return <Offers />;
  return (
    <div class="opstrip" role="group" aria-label="Operation on the line">
      <TypeField />
      <PartFields />
      <StagesField />
      {canSeek(typeName.value) ? <TensionField /> : null}
      <Commands />
    </div>
  );
}
