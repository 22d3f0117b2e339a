// Where the user is: the workspace, the object of the model that is selected, and the tab of the dock. Workspace and
// object are kept in the address, so that reload and back return there.
import { signal } from '@preact/signals';
import type { WorkspaceId } from '../workspaces/workspace';

export const workspaceIds: readonly WorkspaceId[] = ['lay', 'operation', 'storm', 'study', 'runs', 'report'];
export const workspace = signal<WorkspaceId>('lay');
/** Path of the selected object in the model, like "supports.stinger" or "supports.stinger.boxes[2]"; empty: none. */
export const object = signal('');

export function goTo(id: WorkspaceId): void { workspace.value = id; }
export function selectObject(path: string): void { object.value = path; }
