// Frame of the page: header, model on the left, workspace in the middle, verdict on the right.
import type { ComponentChildren } from 'preact';
import { useEffect } from 'preact/hooks';
import type { Signal } from '@preact/signals';
import { hasModel, redo, undo } from '../state/model';
import { dialog, dockHeight, leftWidth, rightWidth } from '../state/look';
import { saveNow } from '../state/files';
import { dismiss, notices } from '../state/notices';
import { drawer, middle, workspace } from '../state/workspace';
import { workspaces } from '../workspaces/all';
import type { WorkspaceParts } from '../workspaces/workspace';
import { ChangedOutside } from './ChangedOutside';
import { Dock, DockHandle, shownTabs } from './Dock';
import { ConflictDialog, OpenDialog, OverwriteDialog, SaveAsDialog, UnsavedDialog } from './Files';
import { ImportDialog } from './ImportDialog';
import { Header } from './Header';
import { KeySensitivity } from './KeySensitivity';
import { Menu } from './Menu';
import { ModelTree } from './ModelTree';
import { Picture } from './Picture';
import { Properties } from './Properties';
import { ResultsColumn } from './ResultsColumn';
import { Search } from './Search';
import { SeekDialog } from './SeekDialog';
import { SpreadDialog } from './SpreadDialog';
import { StartDialog } from './StartDialog';
import '../styles/frame.css';

const clampWidth = (px: number): number => Math.round(Math.min(Math.max(px, 200), 0.4 * innerWidth));

interface HandleProps { side: 'left' | 'right'; name: string; width: Signal<number> }

/** Separator between a side column and the middle: dragged, or moved with the arrow keys; double click or Home resets it. */
function Handle({ side, name, width }: HandleProps) {
  const currentWidth = (): number => document.querySelector(`main > .${side}`)!.getBoundingClientRect().width;
  const wider = side === 'left' ? 'ArrowRight' : 'ArrowLeft';
  return (
    <div
      class="handle"
      data-side={side}
      role="separator"
      tabIndex={0}
      aria-orientation="vertical"
      aria-label={`Width of the ${name}`}
      aria-valuemin={200}
      aria-valuemax={Math.round(0.4 * innerWidth)}
      aria-valuenow={width.value || undefined}
      title="Drag to change the width, double-click to reset"
      onPointerDown={(e) => { e.currentTarget.setPointerCapture(e.pointerId); e.preventDefault(); e.currentTarget.focus(); }}
      onPointerMove={(e) => { if (e.currentTarget.hasPointerCapture(e.pointerId)) width.value = clampWidth(side === 'left' ? e.clientX : innerWidth - e.clientX); }}
      onDblClick={() => { width.value = 0; }}
      onKeyDown={(e) => {
        const step = e.key === wider ? 16 : /^Arrow(Left|Right)$/.test(e.key) ? -16 : 0;
        if (step) { e.preventDefault(); width.value = clampWidth(currentWidth() + step); } else if (e.key === 'Home') width.value = 0;
      }}
    />
  );
}

function Drawer({ side, children }: { side: 'model' | 'results'; children: ComponentChildren }) {
  return (
    <aside class={`${side === 'model' ? 'left' : 'right'}${drawer.value === side ? ' open' : ''}`} aria-label={side === 'model' ? 'Model' : 'Verdict and results'}>
      {children}
    </aside>
  );
}

/** Picture and dock. The picture stays mounted in every workspace, so that nothing has to be drawn again. */
function Middle({ parts }: { parts: WorkspaceParts }) {
  const { Strip, Middle: Own, Bar } = parts;
  const docked = hasModel.value && shownTabs(parts).length > 0, fill = Own ? 'both' : middle.value;
  const sideBySide = Own !== undefined && parts.picture?.value === true;
  return (
    <div class={`middle ${docked ? fill : 'picture'}`} style={dockHeight.value ? { '--dock': `${dockHeight.value}px` } : undefined}>
      {Strip && hasModel.value ? <div class="strip"><Strip /></div> : null}
      <div class={`work${sideBySide ? ' beside' : ''}`}>
        {Own ? <div class="ownmiddle"><Own /></div> : null}
        <div class={`centre${Own && !sideBySide ? ' away' : ''}`}><Picture /></div>
      </div>
      {Bar && hasModel.value ? <div class="underpicture"><Bar /></div> : null}
      {docked ? <><DockHandle /><Dock parts={parts} /></> : null}
    </div>
  );
}

/** Undo, redo and save outside text fields. */
function useKeys(): void {
  useEffect(() => {
    const keys = (e: KeyboardEvent): void => {
      if (e.key === 'Escape' && drawer.value) { drawer.value = null; return; }
      if (!(e.ctrlKey || e.metaKey) || e.altKey) return;
      const key = e.key.toLowerCase();
      const writing = (e.target as HTMLElement).closest('.cm-editor');
      if (key === 's') { e.preventDefault(); saveNow(); }
      else if (!writing && !document.querySelector('dialog[open]')) {
        // in a text field, the undo of the browser takes precedence
        const field = e.target instanceof HTMLInputElement && e.target.type !== 'range' && e.target.value !== (e.target.dataset.written ?? '');
        if (field) return;
        if (key === 'z') { e.preventDefault(); if (e.shiftKey) redo(); else undo(); }
        else if (key === 'y') { e.preventDefault(); redo(); }
      }
    };
    addEventListener('keydown', keys);
    return () => removeEventListener('keydown', keys);
  }, []);
}

function Dialogs() {
  switch (dialog.value) {
    case 'start': return <StartDialog />;
    case 'open': return <OpenDialog />;
    case 'saveas': return <SaveAsDialog />;
    case 'import': return <ImportDialog />;
    case 'spread': return <SpreadDialog />;
    case 'seek': return <SeekDialog />;
    default: return null;
  }
}

function Notices() {
  return (
    <div class="notices" role="status">
      {notices.value.map((n) => (
        <div key={n.id} class={`notice ${n.kind}`}>
          <span>{n.text}{n.hint ? <small> {n.hint}</small> : null}</span>
          <button type="button" class="tiny" aria-label="Dismiss" onClick={() => dismiss(n.id)}>✕</button>
        </div>
      ))}
    </div>
  );
}

export function App() {
  useKeys();
  const parts = workspaces.find((w) => w.id === workspace.value)!;
  const widths = { ...(leftWidth.value ? { '--left': `${clampWidth(leftWidth.value)}px` } : {}), ...(rightWidth.value ? { '--right': `${clampWidth(rightWidth.value)}px` } : {}) };
  return (
    <>
      <Header />
      <ChangedOutside />
      <main data-workspace={parts.id} style={widths}>
        <Drawer side="model"><Search />{hasModel.value ? <><ModelTree /><Properties /></> : <p class="empty">No model yet.</p>}</Drawer>
        <Handle side="left" name="model" width={leftWidth} />
        <Middle parts={parts} />
        <Handle side="right" name="results" width={rightWidth} />
        <Drawer side="results">{hasModel.value ? <ResultsColumn /> : null}</Drawer>
      </main>
      <Dialogs />
      <KeySensitivity />
      <ConflictDialog />
      <OverwriteDialog />
      <UnsavedDialog />
      <Menu />
      <Notices />
    </>
  );
}
