// Navigation state: workspace, selected object of the model, and tab of the dock. Workspace and
// object are stored in the address, so that reload and back restore them.
import { batch, effect, signal } from '@preact/signals';
import type { WorkspaceId } from '../workspaces/workspace';
import { kept } from './look';

export const workspaceIds: readonly WorkspaceId[] = ['lay', 'operation', 'storm', 'study', 'runs', 'report'];
export const workspace = signal<WorkspaceId>('lay');
/** Path of the selected object in the model, such as "supports.stinger" or "supports.stinger.boxes[2]"; empty: none. */
export const object = signal('');
/** Dock tab of each workspace. */
export const dockTabs = kept<Partial<Record<WorkspaceId, string>>>('docktabs', {});
/** Picture and dock together, or the one that is maximised. */
export const middle = kept<'both' | 'picture' | 'dock'>('middle', 'both');
/** The open drawer: side columns are drawers on narrow screens. */
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

const pageAddress = (): string => `#/${workspace.value}${object.value ? `/${encodeURI(object.value)}` : ''}`;

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
    const address = pageAddress();
    // back leads to the previous workspace; selected objects are not history entries
    if (address !== location.hash) history[workspace.value === last ? 'replaceState' : 'pushState'](null, '', address);
    last = workspace.value;
  });
}
