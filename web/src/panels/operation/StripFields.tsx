// Settings of an operation in the strip: each as a summary, with its keys in a popover.
import { cableText, headText, isStageList, operationType, operationTypes, sameKeys, stagesText, tensionMode, tensionText, type TensionMode } from '../../logic/operationKeys';
import { missingPart } from '../../logic/firstOperation';
import { write } from '../../logic/units';
import type { Change } from '../../api/types';
import { Popover } from '../../components/Popover';
import { byPath, diagnostics, setKeys } from '../../state/model';
import { sayError } from '../../state/notices';
import { addOperation, designProcedure, listStages, operation, operationParts, outdated, typeName } from '../../state/operation';
import { selectObject } from '../../state/workspace';
import { FieldRow } from '../FieldRow';

const isError = (...groups: string[]): boolean => diagnostics.value.some((d) => d.severity === 'error' && groups.some((group) => d.key === group || d.key.startsWith(`${group}.`) || d.key.startsWith(`${group}[`)));

/** Note on errors in these keys, for the mark of their button. */
const errorNote = (...groups: string[]): string | undefined => (isError(...groups) ? 'has an error' : undefined);

/** Closes the panel of a button. */
const closePanel = (event: { currentTarget: HTMLElement }): void => { event.currentTarget.closest<HTMLElement>('[popover]')?.hidePopover(); };

const set = (changes: Change[]): Promise<unknown> => setKeys(changes).catch(sayError);

/** Keys of a group that the form has, without those of nested groups. */
function Rows({ paths }: { paths: string[] }) {
  return <>{paths.map((path) => byPath.value.get(path)).filter((f) => f !== undefined).map((f) => <FieldRow key={f.path} field={f} />)}</>;
}

const directKeys = (group: string): string[] => [...byPath.value.values()]
  .filter((f) => f.path.startsWith(`${group}.`) && !/[.[]/.test(f.path.slice(group.length + 1)) && f.kind !== 'map' && f.kind !== 'list').map((f) => f.path);

function InTree({ path }: { path: string }) {
  return <div class="acts"><button type="button" onClick={(e) => { selectObject(path); closePanel(e); }}>All keys in the tree</button></div>;
}

function TypeChoices() {
  const current = typeName.value;
  const choose = (id: (typeof operationTypes)[number]['id']): void => {
    if (id === current) return;
    if (sameKeys(id, current)) void set([{ path: 'operation.type', value: id }]); else void addOperation(id);
  };
  return (
    <>
      <div class="choices">
        {operationTypes.map((type) => {
          const missing = type.id === current ? '' : missingPart(type.id, operationParts.value);
          return (
            <button key={type.id} type="button" aria-pressed={type.id === current} disabled={missing !== ''} onClick={(e) => { choose(type.id); closePanel(e); }}>
              <span>{type.name}</span><small>{missing || type.text}</small>
            </button>
          );
        })}
      </div>
      <p class="brief">Another type of operation starts with default values; undo restores this one.</p>
      <div class="acts"><button type="button" onClick={(e) => { void set([{ path: 'operation', value: null }]); closePanel(e); }}>Remove the operation</button></div>
    </>
  );
}

export function TypeField() {
  const current = typeName.value;
  return <Popover label="operation" value={operationType(current)?.name ?? current} note={errorNote('operation.type')} wide><TypeChoices /></Popover>;
}

function GroupField({ name, group, value }: { name: string; group: string; value: string }) {
  return <Popover label={name} value={value} placeholder="not given" note={errorNote(group)}><Rows paths={directKeys(group)} /><InTree path={group} /></Popover>;
}

const withHead = ['abandonment', 'recovery', 'lay_down', 'start_up', 'shore_pull', 'hold_back'];
const text = (path: string): string => String(byPath.value.get(path)?.value ?? '');
const texts = (group: string, keys: string[]): string => keys.map((key) => text(`operation.${group}.${key}`)).filter(Boolean).join(', ');

export function PartFields() {
  const fields = byPath.value, type = typeName.value, head = withHead.includes(type);
  return (
    <>
      {head ? <GroupField name="head" group="operation.head" value={headText(fields)} /> : null}
      {head ? <GroupField name="cable" group="operation.cable" value={cableText(fields)} /> : null}
      {type === 'shore_pull' || type === 'hold_back' ? <GroupField name="winch" group="operation.winch" value={texts('winch', ['distance', 'depth'])} /> : null}
      {type === 'start_up' ? <GroupField name="anchor" group="operation.anchor" value={texts('anchor', ['distance', 'depth'])} /> : null}
      {type === 'passage' ? <Popover label="structure" value={text('operation.structure')} note={errorNote('operation.structure')}><Rows paths={['operation.structure']} /></Popover> : null}
      {type === 'ballast' ? <Popover label="tank" value={text('operation.tank')} note={errorNote('operation.tank')}><Rows paths={['operation.tank']} /></Popover> : null}
    </>
  );
}

function EvenStages() {
  const ready = operation.value !== null && !outdated.value;
  return (
    <>
      <Rows paths={['operation.stages.from', 'operation.stages.to', 'operation.stages.steps']} />
      <div class="acts">
        <button type="button" disabled={!ready} title={ready ? 'Each stage with its own name, length and tension' : 'Solve the stages first'} onClick={(e) => { void listStages(); closePanel(e); }}>List them individually</button>
      </div>
    </>
  );
}

export function StagesField() {
  const fields = byPath.value;
  return (
    <Popover label="stages" value={stagesText(fields)} note={errorNote('operation.stages')}>
      {isStageList(fields) ? <><p class="brief">The stages are listed individually: edit them in the table below.</p><InTree path="operation.stages" /></> : <EvenStages />}
    </Popover>
  );
}

const modes: [TensionMode, string][] = [['hold', 'as in the lay'], ['force', 'constant'], ['bottom', 'from bottom tension'], ['seek', 'minimum within limits']];
const limits = ['utilisation', 'sagbend_strain', 'sagbend_stress', 'tip_clearance', 'roller_load'].map((key) => `operation.stages.limits.${key}`);

function chooseMode(mode: TensionMode): void {
  const held = byPath.value.get('tensioner.tension'), bottom = operation.value?.stages[0]?.values?.bottom_tension;
  const force = held?.si ? write(held.si, held.unit || 'kN') : '100 kN';
  if (mode === 'seek') void designProcedure();
  else if (mode === 'bottom') void set([{ path: 'operation.stages.tension', value: 'bottom' }, { path: 'operation.stages.bottom_tension', value: bottom ? write(bottom, 'kN', 3) : force }]);
  else void set([{ path: 'operation.stages.tension', value: mode === 'force' ? force : 'hold' }]);
}

/** A single force in place of a choice. */
function ForceRow() {
  const field = byPath.value.get('operation.stages.tension');
  return field ? <FieldRow field={{ ...field, kind: 'quantity', unit: 'kN' }} name="force" /> : null;
}

function TensionChoice({ mode }: { mode: TensionMode }) {
  return (
    <>
      <div class="row wide">
        <label for="tension-mode">tension</label>
        <select id="tension-mode" value={mode} onChange={(e) => chooseMode(e.currentTarget.value as TensionMode)}>
          {mode === 'forces' ? <option value="forces">several values, from the first stage to the last</option> : null}
          {modes.map(([id, name]) => <option key={id} value={id}>{name}</option>)}
        </select>
      </div>
      {mode === 'force' ? <ForceRow /> : null}
      {mode === 'bottom' ? <Rows paths={['operation.stages.bottom_tension']} /> : null}
      {mode === 'seek' ? <><h3>Limits</h3><Rows paths={limits} /><h3>Range</h3><Rows paths={['operation.stages.tension_from', 'operation.stages.tension_to']} /></> : null}
      {mode === 'hold' ? <div class="acts"><button type="button" onClick={(e) => { selectObject('tensioner'); closePanel(e); }}>Tensioner of the lay</button></div> : null}
    </>
  );
}

export function TensionField() {
  const fields = byPath.value, mode = tensionMode(fields);
  return (
    <Popover label="tension" value={tensionText(fields)} note={errorNote('operation.stages.tension', 'operation.stages.limits', 'operation.stages.bottom_tension')}>
      {mode === 'listed' ? <p class="brief">Each stage has its own tension. "Design the procedure" finds the minimum within all limits, at the same number of even steps.</p> : <TensionChoice mode={mode} />}
    </Popover>
  );
}
