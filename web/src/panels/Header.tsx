// Name, files, undo, theme, and in a word how things stand.
import { canRedo, canUndo, errors, fileName, hasModel, info, redo, save, saved, title, undo, unsaved } from '../state/model';
import { calm, failure } from '../state/live';
import { asking, dialog, theme, type DialogName } from '../state/look';
import { leadToFault } from '../state/lead';
import { connected } from '../state/connection';
import { unitSystem } from '../logic/show';
import { tidy } from '../logic/units';
import { post } from '../api/client';
import { sayError } from '../state/notices';
import { keyName } from '../logic/findings';

export function saveNow(): void {
  if (!hasModel.value) return;
  if (fileName.value) void save(fileName.value); else dialog.value = 'saveas';
}

/** New and Open put another model in the place of this one: what is not saved is asked about first. */
export function ask(next: DialogName): void {
  if (unsaved.value) asking.value = next; else dialog.value = next;
}

/** The program prints in these units from now on, and the page is loaded anew in them. */
const chooseUnits = (units: 'metric' | 'us'): Promise<void> => post('units', { units }).then(() => location.reload()).catch(sayError);

function Status() {
  if (!connected.value) return <span class="status bad">no connection to the program</span>;
  const first = errors.value[0];
  if (first) return <button type="button" class="status bad" title={`${first.key || `line ${first.line}`}: ${first.message}`} onClick={() => leadToFault(first)}>{errors.value.length === 1 ? '1 error' : `${errors.value.length} errors`}: {first.key ? keyName(first.key) : `line ${first.line}`}</button>;
  if (failure.value) return <span class="status bad">no solution</span>;
  if (calm.value) return <span class="status good">solved in {tidy(calm.value.solve_ms ?? calm.value.elapsed_ms, 2)} ms</span>;
  return <span class="status">{hasModel.value ? 'solving…' : 'no model'}</span>;
}

export function Header() {
  const none = !hasModel.value;
  return (
    <header class="top">
      <span class="brand" title={`Overbend ${info.value?.version ?? ''}`}>Overbend</span>
      <h1 title={fileName.value || 'not saved yet'}>{none ? '' : title.value}{!none && !saved.value ? <i title="Changed since it was saved"> •</i> : null}</h1>
      <nav aria-label="Model">
        <button type="button" onClick={() => ask('start')}>New…</button>
        <button type="button" onClick={() => ask('open')}>Open…</button>
        <button type="button" disabled={none} title="Ctrl+S" onClick={saveNow}>Save</button>
        <button type="button" disabled={none} onClick={() => { dialog.value = 'saveas'; }}>Save as…</button>
        <button type="button" disabled={!canUndo.value} aria-label="Undo" title="Undo (Ctrl+Z)" onClick={undo}>↶</button>
        <button type="button" disabled={!canRedo.value} aria-label="Redo" title="Redo (Ctrl+Y)" onClick={redo}>↷</button>
      </nav>
      <Status />
      <button type="button" aria-label={`Units: ${unitSystem === 'us' ? 'US customary' : 'metric'}`} title={`Results, tables and reports in ${unitSystem === 'us' ? 'metric units' : 'US customary units'}; the model keeps the units in which it is written`} onClick={() => void chooseUnits(unitSystem === 'us' ? 'metric' : 'us')}>{unitSystem === 'us' ? 'US' : 'SI'}</button>
      <button type="button" aria-label={theme.value === 'dark' ? 'Light colours' : 'Dark colours'} title="Light or dark" onClick={() => { theme.value = theme.value === 'dark' ? 'light' : 'dark'; }}>{theme.value === 'dark' ? '☀' : '☾'}</button>
    </header>
  );
}
