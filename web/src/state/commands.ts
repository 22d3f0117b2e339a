// All commands of the page, for the search; other modules add theirs with `addCommands`.
import { computed, signal } from '@preact/signals';
import { post } from '../api/client';
import { unitSystem } from '../logic/show';
import { saveNow, askFor } from './files';
import { applyLive, changes, resetLive } from './live';
import { theme, dialog } from './look';
import { canRedo, canUndo, errors, hasModel, redo, text, undo } from './model';
import { sayError } from './notices';
import { hasOperation, solveOperation } from './operation';
import { startRun } from './runs';
import { openSeek } from './seek';
import { findSensitivities } from './sensitivities';
import { goTo, workspace, workspaceIds } from './workspace';

export interface Command {
  id: string;
  name: string;
  /** Synonyms for the search. */
  more?: string;
  /** Shortcut, as shown. */
  keys?: string;
  able?: () => boolean;
  act: () => void;
}

const tables = signal<readonly (readonly Command[])[]>([]);

/** Adds commands and returns the function that removes them. */
export function addCommands(list: readonly Command[]): () => void {
  tables.value = [...tables.value, list];
  return () => { tables.value = tables.value.filter((table) => table !== list); };
}

/** Commands that are currently available. */
export const commands = computed<Command[]>(() => tables.value.flat().filter((command) => command.able?.() ?? true));

function downloadModel(): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text.value], { type: 'application/yaml' }));
  link.download = 'model.yaml';
  link.click();
  URL.revokeObjectURL(link.href);
}

const otherUnits = unitSystem === 'us' ? 'metric' : 'us';
const ready = (): boolean => hasModel.value && errors.value.length === 0;
const title = (id: string): string => id[0]!.toUpperCase() + id.slice(1);

addCommands([
  { id: 'new', name: 'New model …', more: 'start dialog', act: () => askFor('start') },
  { id: 'open', name: 'Open …', more: 'file example load', act: () => askFor('open') },
  { id: 'save', name: 'Save', keys: 'Ctrl S', able: () => hasModel.value, act: saveNow },
  { id: 'saveas', name: 'Save as …', more: 'file name copy', able: () => hasModel.value, act: () => { dialog.value = 'saveas'; } },
  { id: 'download', name: 'Download the model', more: 'export yaml file', able: () => hasModel.value, act: downloadModel },
  { id: 'undo', name: 'Undo', keys: 'Ctrl Z', able: () => canUndo.value, act: undo },
  { id: 'redo', name: 'Redo', keys: 'Ctrl Y', able: () => canRedo.value, act: redo },
  { id: 'seek', name: 'Goal seek …', more: 'goal seek target utilisation tension', able: ready, act: () => openSeek() },
  { id: 'apply', name: 'Apply to model', more: 'write trial values', able: () => changes.value.length > 0, act: () => void applyLive() },
  { id: 'reset', name: 'Reset the trial values', more: 'back to the model', able: () => changes.value.length > 0, act: resetLive },
  { id: 'sensitivities', name: 'Compute the sensitivities', more: 'tornado tolerance effect', able: ready, act: () => void findSensitivities() },
  { id: 'stages', name: 'Solve the stages of the operation', more: 'abandonment recovery pull start-up', able: () => ready() && hasOperation.value, act: () => { goTo('operation'); void solveOperation(); } },
  { id: 'storm', name: 'Run the storm', more: 'dynamic run sea waves', able: ready, act: () => { goTo('storm'); void startRun({ kind: 'dynamic' }); } },
  { id: 'static', name: 'Static run with report', more: 'export results html', able: ready, act: () => { goTo('runs'); void startRun({ kind: 'static' }); } },
  { id: 'theme', name: 'Dark or light colours', more: 'theme mode night', act: () => { theme.value = theme.value === 'dark' ? 'light' : 'dark'; } },
  {
    id: 'units',
    name: otherUnits === 'us' ? 'Results in US customary units' : 'Results in metric units',
    more: 'units system feet kip ksi metric si',
    act: () => { post('units', { units: otherUnits }).then(() => location.reload()).catch(sayError); },
  },
  ...workspaceIds.map((id) => ({ id: `go-${id}`, name: `Go to ${title(id)}`, more: 'workspace', able: () => workspace.value !== id, act: () => goTo(id) })),
]);
