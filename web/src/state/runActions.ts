// Commands for runs selected in the list.
import { get } from '../api/client';
import type { Run } from '../api/types';
import { openNew } from './model';
import { say, sayError } from './notices';
import { runName, runs, select } from './runs';
import { openStudy } from './studies';
import { goTo } from './workspace';
import type { WorkspaceId } from '../workspaces/workspace';

export const isGoing = (run: Run): boolean => run.state === 'running' || run.state === 'queued';

/** Workspace that shows a run; a static one is shown in the list itself. */
export function runWorkspace(run: Run): WorkspaceId {
  return run.kind === 'study' ? 'study' : run.kind === 'static' ? 'runs' : 'storm';
}

export function look(run: Run): void {
  if (runWorkspace(run) === 'study') { openStudy(run.id); return; }
  select(run.id);
  goTo(runWorkspace(run));
}

/** Opens the model of a run as a new model without a file: the present file may differ. */
export async function openRunModel(run: Run): Promise<void> {
  try {
    const { text } = await get<{ text: string }>(`runs/${run.id}/model`);
    const name = runName(run);
    await openNew(text);
    say(`The model of ${name} is open as a new, unsaved model. Undo restores the previous one.`);
    goTo('lay');
  } catch (error) { sayError(error); }
}

/** The run and, for a study, its cases. */
export const runCases = (run: Run): Run[] => runs.value.filter((item) => item.parent === run.id);
