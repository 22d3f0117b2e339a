// Names of the workspaces.
import type { WorkspaceId } from '../workspaces/workspace';

export const workspaceNames: Record<WorkspaceId, string> = { lay: 'Lay', operation: 'Operation', storm: 'Storm', study: 'Study', runs: 'Runs', report: 'Report' };
