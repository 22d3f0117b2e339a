// Runs of this folder, and comparison of up to four of them.
import { Differences } from '../panels/runs/Differences';
import { RunDiagrams } from '../panels/runs/RunDiagrams';
import { RunNotes } from '../panels/runs/RunNotes';
import { RunsTable } from '../panels/runs/RunsTable';
import type { WorkspaceParts } from './workspace';

export const runs: WorkspaceParts = {
  id: 'runs',
  title: 'Runs',
  Middle: RunsTable,
  tabs: [
    { id: 'differences', title: 'Differences', View: Differences },
    { id: 'diagrams', title: 'Diagrams', View: RunDiagrams },
    { id: 'notes', title: 'Notes', View: RunNotes },
  ],
};
