// What can be done with runs that are chosen in the list.
import { get } from '../api/client';
import type { Run } from '../api/types';
import { openNew } from './model';
import { say, sayError } from './notices';
import { runName, runs, select } from './runs';
import { openStudy } from './studies';
import { goTo } from './workspace';
import type { WorkspaceId } from '../workspaces/workspace';

export const isGoing = (run: Run): boolean => run.state === 'running' || run.state === 'queued';

/** The workspace that shows a run; a static one is shown in the list's own. */
export function placeOf(run: Run): WorkspaceId {
  return run.kind === 'study' ? 'study' : run.kind === 'static' ? 'runs' : 'storm';
}

export function look(run: Run): void {
  if (placeOf(run) === 'study') { openStudy(run.id); return; }
  select(run.id);
  goTo(placeOf(run));
}

/** The model with which a run was started, as a new one without a file: the file of today may be another. */
export async function openModelOf(run: Run): Promise<void> {
  try {
    const { text } = await get<{ text: string }>(`runs/${run.id}/model`);
    const name = runName(run);
    await openNew(text);
    say(`The model of ${name} is open without a file. Undo brings the other one back.`);
    goTo('lay');
  } catch (error) { sayError(error); }
}

/** The run itself and, of a study, its cases. */
export const casesOf = (run: Run): Run[] => runs.value.filter((one) => one.parent === run.id);
