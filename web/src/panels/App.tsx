import { useEffect } from 'preact/hooks';
import { hasModel, redo, undo } from '../state/model';
import { dialog, leftTab, leftWidth, pane } from '../state/look';
import { isStudy } from '../logic/runs';
import { dismiss, notices } from '../state/notices';
import { runs, selected } from '../state/runs';
import { AnimationBar } from './AnimationBar';
import { Checks } from './Checks';
import { Diagrams } from './Diagrams';
import { ConflictDialog, OpenDialog, OverwriteDialog, SaveAsDialog, UnsavedDialog } from './Files';
import { Form } from './Form';
import { Header, saveNow } from './Header';
import { MatrixResults } from './MatrixResults';
import { OperationTab } from './Operation';
import { LayTablePanel } from './LayTable';
import { Picture } from './Picture';
import { Results } from './Results';
import { RunResults } from './RunResults';
import { StudyResults } from './StudyResults';
import { StudyTab } from './StudyTab';
import { Runs } from './Runs';
import { Sliders } from './Sliders';
import { SeekDialog } from './SeekDialog';
import { SpreadDialog } from './SpreadDialog';
import { StageBar } from './StageBar';
import { StartDialog } from './StartDialog';
import { Yaml } from './Yaml';

const tabs = [['form', 'Form'], ['yaml', 'YAML'], ['operation', 'Operation'], ['laytable', 'Lay table'], ['study', 'Study'], ['runs', 'Runs']] as const;

function Left() {
  const going = runs.value.filter((r) => r.state === 'running' || r.state === 'queued').length;
  return (
    <aside class="left" aria-label="Model and runs">
      <div role="tablist" class="tabs" onKeyDown={(e) => {
        const i = tabs.findIndex((t) => t[0] === leftTab.value);
        const step = e.key === 'ArrowRight' ? 1 : e.key === 'ArrowLeft' ? -1 : 0;
        if (!step) return;
        leftTab.value = tabs[(i + step + tabs.length) % tabs.length]![0];
        document.getElementById(`tab-${leftTab.value}`)?.focus();
      }}>
        {tabs.map(([id, name]) => <button key={id} id={`tab-${id}`} type="button" role="tab" tabIndex={leftTab.value === id ? 0 : -1} aria-selected={leftTab.value === id} aria-controls="tabpanel" onClick={() => { leftTab.value = id; }}>{name}{id === 'runs' && going ? <span class="dot" title="running" /> : null}</button>)}
      </div>
      <div id="tabpanel" role="tabpanel" aria-labelledby={`tab-${leftTab.value}`} class={`panel ${leftTab.value}`}>
        {leftTab.value === 'runs' ? <Runs /> : !hasModel.value ? <p class="empty">No model yet.</p> : leftTab.value === 'form' ? <Form /> : leftTab.value === 'operation' ? <OperationTab /> : leftTab.value === 'laytable' ? <LayTablePanel /> : leftTab.value === 'study' ? <StudyTab /> : <Yaml />}
      </div>
    </aside>
  );
}

const clampLeft = (px: number): number => Math.round(Math.min(Math.max(px, 200), 0.5 * innerWidth));

/** Between left pane and picture: dragged, or moved with the arrow keys; double click or Home puts it back. */
function Handle() {
  const now = (): number => document.querySelector('.left')!.getBoundingClientRect().width;
  return (
    <div class="handle" role="separator" tabIndex={0} aria-orientation="vertical" aria-label="Width of the left pane" aria-valuemin={200} aria-valuemax={Math.round(0.5 * innerWidth)} aria-valuenow={leftWidth.value || undefined} title="Drag to change the width, double click to put it back"
      onPointerDown={(e) => { e.currentTarget.setPointerCapture(e.pointerId); e.preventDefault(); e.currentTarget.focus(); }}
      onPointerMove={(e) => { if (e.currentTarget.hasPointerCapture(e.pointerId)) leftWidth.value = clampLeft(e.clientX); }}
      onDblClick={() => { leftWidth.value = 0; }}
      onKeyDown={(e) => {
        const step = e.key === 'ArrowRight' ? 16 : e.key === 'ArrowLeft' ? -16 : 0;
        if (step) { e.preventDefault(); leftWidth.value = clampLeft(now() + step); } else if (e.key === 'Home') leftWidth.value = 0;
      }} />
  );
}

const panes = [['model', 'Model'], ['picture', 'Picture'], ['diagrams', 'Diagrams'], ['results', 'Results']] as const;

/** On small screens one pane is seen at a time. */
function Panes() {
  return (
    <div class="panes" role="tablist" aria-label="Panes">
      {panes.map(([id, name]) => <button key={id} type="button" role="tab" aria-selected={pane.value === id} onClick={() => { pane.value = id; }}>{name}</button>)}
    </div>
  );
}

export function App() {
  useEffect(() => {
    const keys = (e: KeyboardEvent): void => {
      if (!(e.ctrlKey || e.metaKey) || e.altKey) return;
      const key = e.key.toLowerCase();
      const writing = (e.target as HTMLElement).closest('.cm-editor');
      if (key === 's') { e.preventDefault(); saveNow(); }
      else if (!writing && !document.querySelector('dialog[open]')) {
        // in a field that is being typed in, the browser's own undo comes first
        const field = e.target instanceof HTMLInputElement && e.target.type !== 'range' && e.target.value !== (e.target.dataset.written ?? '');
        if (field) return;
        if (key === 'z') { e.preventDefault(); if (e.shiftKey) redo(); else undo(); }
        else if (key === 'y') { e.preventDefault(); redo(); }
      }
    };
    addEventListener('keydown', keys);
    return () => removeEventListener('keydown', keys);
  }, []);
  return (
    <>
      <Header />
      <Panes />
      <main data-pane={pane.value} style={leftWidth.value ? { '--left': `${clampLeft(leftWidth.value)}px` } : undefined}>
        <Left />
        <Handle />
        <div class="centre"><Picture /><AnimationBar /><StageBar /></div>
        <aside class="right" aria-label="Results and sliders">{selected.value?.kind === 'study' ? <MatrixResults run={selected.value} /> : selected.value && isStudy(selected.value) ? <StudyResults run={selected.value} /> : selected.value ? <><RunResults /><Checks /></> : <><Results /><Checks /><Sliders /></>}</aside>
        <Diagrams />
      </main>
      {dialog.value === 'start' ? <StartDialog /> : dialog.value === 'open' ? <OpenDialog /> : dialog.value === 'saveas' ? <SaveAsDialog /> : dialog.value === 'spread' ? <SpreadDialog /> : dialog.value === 'seek' ? <SeekDialog /> : null}
      <ConflictDialog />
      <OverwriteDialog />
      <UnsavedDialog />
      <div class="notices" role="status">{notices.value.map((n) => <div key={n.id} class={`notice ${n.kind}`}><span>{n.text}{n.hint ? <small> {n.hint}</small> : null}</span><button type="button" class="tiny" aria-label="Dismiss" onClick={() => dismiss(n.id)}>✕</button></div>)}</div>
    </>
  );
}
