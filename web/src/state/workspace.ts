// Where the user is: the workspace, the object of the model that is selected, and the tab of the dock. Workspace and
// object are kept in the address, so that reload and back return there.
import { batch, effect, signal } from '@preact/signals';
import type { WorkspaceId } from '../workspaces/workspace';
import { kept } from './look';

export const workspaceIds: readonly WorkspaceId[] = ['lay', 'operation', 'storm', 'study', 'runs', 'report'];
export const workspace = signal<WorkspaceId>('lay');
/** Path of the selected object in the model, like "supports.stinger" or "supports.stinger.boxes[2]"; empty: none. */
export const object = signal('');
/** The tab of the dock that each workspace shows. */
export const dockTabs = kept<Partial<Record<WorkspaceId, string>>>('docktabs', {});
/** Picture and dock side by side, or the one that fills the middle. */
export const middle = kept<'both' | 'picture' | 'dock'>('middle', 'both');
/** On narrow screens the side columns are drawers: the one that is open. */
export const drawer = signal<'model' | 'results' | null>(null);

export function goTo(id: WorkspaceId): void { workspace.value = id; }
export function selectObject(path: string): void { object.value = path; }

export function showDockTab(id: WorkspaceId, tab: string): void {
  batch(() => {
    dockTabs.value = { ...dockTabs.value, [id]: tab };
    workspace.value = id;
    if (middle.value === 'picture') middle.value = 'both';
  });
}

const addressOf = (): string => `#/${workspace.value}${object.value ? `/${encodeURI(object.value)}` : ''}`;

function readAddress(): void {
  const [, id, path] = /^#\/(\w+)(?:\/(.*))?$/.exec(location.hash) ?? [];
  batch(() => {
    workspace.value = workspaceIds.find((w) => w === id) ?? 'lay';
    object.value = path ? decodeURI(path) : '';
  });
}

export function startWorkspace(): void {
  readAddress();
  addEventListener('popstate', readAddress);
  addEventListener('hashchange', readAddress);
  let last = workspace.value;
  effect(() => {
    const address = addressOf();
    // a step back leads to the workspace before; objects on the way do not count as steps
    if (address !== location.hash) history[workspace.value === last ? 'replaceState' : 'pushState'](null, '', address);
    last = workspace.value;
  });
}
