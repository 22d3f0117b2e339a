// Commands for the selected runs.
import { useState } from 'preact/hooks';
import type { Run } from '../../api/types';
import { maxCompared } from '../../logic/runCompare';
import { checked } from '../../state/compare';
import { cancelRun, deleteRuns, reportPath, resumeRun, runs, tablePath } from '../../state/runs';
import { isGoing, look, openRunModel, runWorkspace } from '../../state/runActions';
import { workspaceNames } from '../../logic/workspaceNames';
import { FileLink } from '../../components/FileLink';
import { ReportLinks } from '../ReportLinks';
import { renaming } from './RunRow';

/** With confirmation: files cannot be restored. */
function Delete({ list }: { list: Run[] }) {
  const [sure, setSure] = useState(''), ids = list.map((run) => run.id).join(' ');
  // removed from the comparison first, so that no request refers to a deleted run
  const drop = (): void => {
    setSure('');
    checked.value = [];
    void deleteRuns(list.map((run) => run.id));
  };
  if (sure !== ids) return <button type="button" onClick={() => setSure(ids)}>Delete…</button>;
  return (
    <span class="sure" role="alertdialog" aria-label="Delete">
      {list.length === 1 ? 'Delete the run with all of its files?' : `Delete ${list.length} runs with all of their files?`}
      <button type="button" class="danger" onClick={drop}>Delete</button>
      <button type="button" onClick={() => setSure('')}>Keep</button>
    </span>
  );
}

function One({ run }: { run: Run }) {
  const place = runWorkspace(run);
  return (
    <>
      {place === 'runs' ? null : <button type="button" class="main" onClick={() => look(run)}>Open in {workspaceNames[place]}</button>}
      <button type="button" title="Open the model of this run as a new, unsaved model" onClick={() => void openRunModel(run)}>Open its model</button>
      {run.has_results && run.kind !== 'seeds' ? <ReportLinks path={reportPath(run.id)} name={`${run.id}.html`} /> : null}
      {run.has_results ? <FileLink path={tablePath(run.id)} name={`${run.id}.csv`}>CSV</FileLink> : null}
      {run.parent ? null : <button type="button" onClick={() => { renaming.value = run.id; }}>Rename</button>}
      {run.resumable && !isGoing(run) ? <button type="button" title="Continue from the last checkpoint" onClick={() => void resumeRun(run.id)}>Resume</button> : null}
    </>
  );
}

export function RunActions() {
  const list = checked.value.map((id) => runs.value.find((run) => run.id === id)).filter((run) => run !== undefined);
  const going = list.filter((run) => isGoing(run) && !run.parent), ended = list.filter((run) => !isGoing(run) && !run.parent);
  return (
    <div class="runacts" role="toolbar" aria-label="Chosen runs">
      {list.length === 0 ? <span class="brief">Select a run to see its results, or two to {maxCompared} to compare them.</span> : null}
      {list.length === 1 ? <One run={list[0]!} /> : null}
      {list.length > 1 ? <span class="brief">{list.length > maxCompared ? `The first ${maxCompared} of ${list.length} are compared below.` : `${list.length} runs are compared below.`}</span> : null}
      {going.length ? <button type="button" onClick={() => { for (const run of going) void cancelRun(run.id); }}>{going.length === 1 ? 'Cancel' : `Cancel ${going.length}`}</button> : null}
      {ended.length ? <Delete list={ended} /> : null}
    </div>
  );
}
