// Name and file, workspaces, solver status, undo, files, units, theme.
import { canRedo, canUndo, errors, fileName, hasModel, info, redo, saved, title, undo } from '../state/model';
import { calm, failure, solvingNow } from '../state/live';
import { askFor, saveNow } from '../state/files';
import { dialog, theme } from '../state/look';
import { leadToDiagnostic } from '../state/lead';
import { connected } from '../state/connection';
import { unitSystem } from '../logic/show';
import { tidy } from '../logic/units';
import { post } from '../api/client';
import { newRuns, runs } from '../state/runs';
import { sayError } from '../state/notices';
import { keyName } from '../logic/findings';
import { drawer, goTo, workspace } from '../state/workspace';
import { workspaces } from '../workspaces/all';
import type { WorkspaceId } from '../workspaces/workspace';
import { openMenuBelow } from './Menu';
import '../styles/header.css';

/** Sets the unit system of the program and reloads the page in it. */
const chooseUnits = (units: 'metric' | 'us'): Promise<void> => post('units', { units }).then(() => location.reload()).catch(sayError);

function Status() {
  if (!connected.value) return <span class="status bad" role="status">no connection to the program</span>;
  const first = errors.value[0];
  if (first) {
    const text = errors.value.length === 1 ? '1 error' : `${errors.value.length} errors`;
    return (
      <button type="button" class="status bad" title={`${first.key || `line ${first.line}`}: ${first.message}`} onClick={() => leadToDiagnostic(first)}>
        {text}: {first.key ? keyName(first.key) : `line ${first.line}`}
      </button>
    );
  }
  if (failure.value) return <span class="status bad">no solution</span>;
  if (calm.value) return <span class="status good">solved in {tidy(calm.value.solve_ms ?? calm.value.elapsed_ms, 2)} ms</span>;
  return <span class="status">{hasModel.value ? 'solving…' : 'no model'}</span>;
}

/** Status of a workspace in the header: active runs, and runs that have ended since the list was last viewed. */
function Mark({ id }: { id: WorkspaceId }) {
  const count = newRuns.value.length;
  if (id === 'runs' && count) return <span class="dot new" role="img" aria-label={`${count} new`} title={count === 1 ? 'a run has ended' : `${count} runs have ended`} />;
  const going = runs.value.some((run) => run.state === 'running' || run.state === 'queued');
  return id === 'runs' && going ? <span class="dot" title="a run is in progress" /> : null;
}

function Workspaces() {
  return (
    <nav
      class="workspaces"
      aria-label="Workspaces"
      onKeyDown={(e) => {
        const step = e.key === 'ArrowRight' ? 1 : e.key === 'ArrowLeft' ? -1 : 0;
        if (!step) return;
        const index = workspaces.findIndex((w) => w.id === workspace.value), next = workspaces[(index + step + workspaces.length) % workspaces.length]!;
        goTo(next.id);
        document.getElementById(`workspace-${next.id}`)?.focus();
      }}
    >
      {workspaces.map(({ id, title: name }) => (
        <button
          key={id}
          id={`workspace-${id}`}
          type="button"
          aria-current={workspace.value === id ? 'page' : undefined}
          onClick={() => goTo(id)}
        >
          {name}<Mark id={id} />
        </button>
      ))}
    </nav>
  );
}

/** Below 1,100 px the side columns are drawers. */
function DrawerButton({ side, name }: { side: 'model' | 'results'; name: string }) {
  const open = drawer.value === side;
  return <button type="button" class="drawerbutton" aria-expanded={open} onClick={() => { drawer.value = open ? null : side; }}>{name}</button>;
}

function Files() {
  const none = !hasModel.value;
  return (
    <nav class="files" aria-label="Model">
      <button type="button" class="icon" disabled={!canUndo.value} aria-label="Undo" title="Undo (Ctrl+Z)" onClick={undo}>↶</button>
      <button type="button" class="icon" disabled={!canRedo.value} aria-label="Redo" title="Redo (Ctrl+Y)" onClick={redo}>↷</button>
      <button type="button" onClick={() => askFor('start')}>New…</button>
      <button type="button" onClick={() => askFor('open')}>Open…</button>
      <span class="split">
        <button type="button" disabled={none} title="Ctrl+S" onClick={saveNow}>Save</button>
        <button
          type="button"
          disabled={none}
          aria-label="More save options"
          aria-haspopup="menu"
          onClick={(e) => openMenuBelow([{ name: 'Save as…', act: () => { dialog.value = 'saveas'; } }], e.currentTarget)}
        >
          ▾
        </button>
      </span>
    </nav>
  );
}

export function Header() {
  const none = !hasModel.value, us = unitSystem === 'us', dark = theme.value === 'dark';
  return (
    <header class={`top${solvingNow.value ? ' solving' : ''}`}>
      <DrawerButton side="model" name="Model" />
      <span class="brand" title={`Overbend ${info.value?.version ?? ''}`}>Overbend</span>
      <h1 title={fileName.value || 'not saved yet'}>
        {none ? '' : title.value} <small>{none ? '' : fileName.value}{!none && !saved.value ? <i title="Changed since it was saved"> • unsaved</i> : null}</small>
      </h1>
      <Workspaces />
      <Status />
      <Files />
      <button
        type="button"
        class="icon"
        aria-label={`Units: ${us ? 'US customary' : 'metric'}`}
        title={`Results, tables and reports in ${us ? 'metric units' : 'US customary units'}; the model keeps its own units`}
        onClick={() => void chooseUnits(us ? 'metric' : 'us')}
      >
        {us ? 'US' : 'SI'}
      </button>
      <button type="button" class="icon" aria-label={dark ? 'Light colours' : 'Dark colours'} title="Light or dark" onClick={() => { theme.value = dark ? 'light' : 'dark'; }}>{dark ? '☀' : '☾'}</button>
      <DrawerButton side="results" name="Verdict" />
    </header>
  );
}
