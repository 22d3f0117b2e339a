// The dock below the picture: tabs with tables and diagrams of the workspace; its height is dragged, either part can be maximised.
import { dockHeight } from '../state/look';
import { dockTabs, middle } from '../state/workspace';
import type { DockTab, WorkspaceParts } from '../workspaces/workspace';
import '../styles/dock.css';

/** Tabs with content for the model or its results. */
export const shownTabs = (parts: WorkspaceParts): DockTab[] => parts.tabs.filter((tab) => tab.shown?.() ?? true);
export const shownTab = (parts: WorkspaceParts): DockTab | undefined => shownTabs(parts).find((tab) => tab.id === dockTabs.value[parts.id]) ?? shownTabs(parts)[0];

const clampHeight = (px: number): number => Math.round(Math.min(Math.max(px, 110), innerHeight - 220));

/** Separator between picture and dock: dragged, or moved with the arrow keys; double click or Home resets it. */
export function DockHandle() {
  const currentHeight = (): number => document.querySelector('.dock')?.getBoundingClientRect().height ?? 0;
  return (
    <div
      class="dockhandle"
      role="separator"
      tabIndex={0}
      aria-orientation="horizontal"
      aria-label="Height of the dock"
      aria-valuemin={110}
      aria-valuemax={Math.round(innerHeight - 220)}
      aria-valuenow={dockHeight.value || undefined}
      title="Drag to change the height, double-click to reset"
      onPointerDown={(e) => { e.currentTarget.setPointerCapture(e.pointerId); e.preventDefault(); e.currentTarget.focus(); }}
      onPointerMove={(e) => { if (e.currentTarget.hasPointerCapture(e.pointerId)) dockHeight.value = clampHeight(innerHeight - e.clientY); }}
      onDblClick={() => { dockHeight.value = 0; }}
      onKeyDown={(e) => {
        const step = e.key === 'ArrowUp' ? 16 : e.key === 'ArrowDown' ? -16 : 0;
        if (step) { e.preventDefault(); dockHeight.value = clampHeight(currentHeight() + step); } else if (e.key === 'Home') dockHeight.value = 0;
      }}
    />
  );
}

export function Dock({ parts }: { parts: WorkspaceParts }) {
  const tabs = shownTabs(parts), tab = shownTab(parts);
  const choose = (id: string): void => { dockTabs.value = { ...dockTabs.value, [parts.id]: id }; };
  if (!tab) return null;
  const { View } = tab, full = middle.value === 'dock';
  return (
    <section class="dock" aria-label={`${parts.title}: tables and diagrams`}>
      <div
        class="docktabs"
        role="tablist"
        onKeyDown={(e) => {
          const step = e.key === 'ArrowRight' ? 1 : e.key === 'ArrowLeft' ? -1 : 0;
          if (!step) return;
          const next = tabs[(tabs.indexOf(tab) + step + tabs.length) % tabs.length]!;
          choose(next.id);
          document.getElementById(`docktab-${next.id}`)?.focus();
        }}
      >
        {tabs.map(({ id, title }) => (
          <button
            key={id}
            id={`docktab-${id}`}
            type="button"
            role="tab"
            tabIndex={id === tab.id ? 0 : -1}
            aria-selected={id === tab.id}
            aria-controls="dockpanel"
            onClick={() => choose(id)}
          >
            {title}
          </button>
        ))}
        {parts.Middle ? null : (
          <button type="button" class="tiny fill" aria-pressed={full} title={full ? 'Restore the picture' : 'Maximise the dock'} onClick={() => { middle.value = full ? 'both' : 'dock'; }}>
            {full ? '▾' : '▴'}<span class="hidden">{full ? 'Restore the picture' : 'Maximise'}</span>
          </button>
        )}
      </div>
      <div id="dockpanel" class={`dockpanel ${tab.id}`} role="tabpanel" aria-labelledby={`docktab-${tab.id}`}><View /></div>
    </section>
  );
}
