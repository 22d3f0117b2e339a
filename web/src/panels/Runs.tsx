// Runs: start one, watch it, look at earlier ones.
import { useEffect, useState } from 'preact/hooks';
import { duration as inWords } from '../logic/show';
import { parseQuantity, tidy, toSi } from '../logic/units';
import { withoutPaths } from '../logic/warnings';
import type { Run } from '../api/types';
import { byPath, errors, hasModel } from '../state/model';
import { changes } from '../state/live';
import { annotate, cancelRun, deleteRun, reportAddress, resumeRun, runName, runs, select, selectedId, startRun, timeToFinish } from '../state/runs';
import { leadToFault } from '../state/lead';

const words: Record<Run['state'], string> = { queued: 'waiting', running: 'running', done: 'done', failed: 'failed', cancelled: 'cancelled' };

function when(seconds: number): string {
  const d = new Date(seconds * 1000);
  const today = new Date().toDateString() === d.toDateString();
  return today ? d.toLocaleTimeString([], { hour: '2-digit', minute: '2-digit' }) : d.toLocaleDateString([], { day: 'numeric', month: 'short', hour: '2-digit', minute: '2-digit' });
}

/** Name and note of a run, kept when the field is left. */
function Words({ run }: { run: Run }) {
  const [name, setName] = useState(run.name);
  const [note, setNote] = useState(run.note);
  const keep = (): void => { if (name !== run.name || note !== run.note) void annotate(run.id, { name: name.trim(), note: note.trim() }); };
  return (
    <div class="words">
      <input aria-label="Name of the run" placeholder={run.title || 'name'} value={name} onInput={(e) => setName(e.currentTarget.value)} onBlur={keep} onKeyDown={(e) => { if (e.key === 'Enter') keep(); }} />
      <textarea aria-label="Note on the run" placeholder="note" rows={2} value={note} onInput={(e) => setNote(e.currentTarget.value)} onBlur={keep} />
    </div>
  );
}

/** Asked twice, for files are gone afterwards. */
function Delete({ run }: { run: Run }) {
  const [sure, setSure] = useState(false);
  if (!sure) return <button type="button" onClick={() => setSure(true)}>Delete…</button>;
  return <><button type="button" class="danger" onClick={() => void deleteRun(run.id)}>Delete with all files</button><button type="button" onClick={() => setSure(false)}>Keep</button></>;
}

function Card({ run }: { run: Run }) {
  const mine = selectedId.value === run.id;
  const left = run.state === 'running' ? timeToFinish(run) : null;
  const going = run.state === 'running' || run.state === 'queued';
  return (
    <li class={`run ${run.state}${mine ? ' chosen' : ''}`}>
      <button type="button" class="runhead" aria-pressed={mine} onClick={() => select(mine ? null : run.id)}>
        <b>{runName(run)}</b>
        <span class="brief">{run.kind === 'dynamic' ? 'dynamic' : 'static'} · {words[run.state]}{run.started ? ` · ${when(run.started)}` : ''}</span>
      </button>
      {going ? (
        <>
          <div class="bar" role="progressbar" aria-valuemin={0} aria-valuemax={100} aria-valuenow={Math.round(100 * run.progress)}><i style={{ width: `${100 * run.progress}%` }} /></div>
          <p class="brief">
            {Math.round(100 * run.progress)} %{left !== null ? `, ${inWords(left)} remaining` : ''}
            {run.time !== undefined ? ` · t = ${tidy(run.time, 4)} s` : ''}
          </p>
          {run.top_tension !== undefined || run.worst_stress !== undefined ? (
            <dl class="livevalues">
              {run.top_tension !== undefined ? <div class="kv"><dt>top tension</dt><dd>{tidy(run.top_tension / 1e3, 4)} <small>kN</small></dd></div> : null}
              {run.worst_stress !== undefined ? <div class="kv"><dt>maximum stress</dt><dd>{tidy(run.worst_stress / 1e6, 4)} <small>MPa</small></dd></div> : null}
            </dl>
          ) : null}
        </>
      ) : null}
      {run.note && !mine ? <p class="note">{run.note}</p> : null}
      {run.message && run.state !== 'done' && !mine ? <p class="brief">{withoutPaths(run.message)}</p> : null}
      {mine ? <Words key={run.id} run={run} /> : null}
      <div class="acts">
        {going ? <button type="button" onClick={() => void cancelRun(run.id)}>Cancel</button> : null}
        {run.has_results ? <a class="button" href={reportAddress(run.id)} download={`${run.id}.html`}>Report</a> : null}
        {run.has_results && !mine ? <button type="button" onClick={() => select(run.id)}>{run.kind === 'dynamic' ? 'Animate' : 'Show'}</button> : null}
        {run.resumable && !going ? <button type="button" title="Continue where it was stopped" onClick={() => void resumeRun(run.id)}>Resume</button> : null}
        {mine && !going ? <Delete run={run} /> : null}
      </div>
    </li>
  );
}

export function Runs() {
  const given = byPath.value.get('analysis.dynamic.duration');
  const [typed, setTyped] = useState('');
  useEffect(() => { setTyped(given?.value ? String(given.value) : '120 s'); }, [given?.value]);
  const q = parseQuantity(typed);
  const seconds = q ? (q.unit ? toSi(q.number, q.unit) : q.number) : Number.NaN;
  const good = Number.isFinite(seconds) && seconds > 0;
  const first = errors.value[0];
  const ready = hasModel.value && !first;
  return (
    <div class="runs">
      <form class="startrun" onSubmit={(e) => { e.preventDefault(); if (good && ready) void startRun('dynamic', seconds); }}>
        <h3>Dynamic run</h3>
        <div class="row">
          <label for="run-duration">duration</label>
          <input id="run-duration" value={typed} aria-invalid={!good} onInput={(e) => setTyped(e.currentTarget.value)} />
          <span class="twin">{good ? inWords(seconds) : ''}</span>
          {good ? null : <p class="fault">A time, like "600 s" or "3 h".</p>}
        </div>
        {changes.value.length ? <p class="note">The run computes the model as it is written. Values on the sliders count only after "Apply to model".</p> : null}
        {first ? <p class="fault">The model has an error at <button type="button" class="link" onClick={() => leadToFault(first)}>{first.key || `line ${first.line}`}</button>; a run needs it mended.</p> : null}
        <div class="acts">
          <button type="submit" class="main" disabled={!ready || !good}>Start run</button>
          <button type="button" disabled={!ready} onClick={() => void startRun('static')}>Static run with report</button>
        </div>
      </form>
      <h3>Runs of this folder</h3>
      {runs.value.length ? <ul class="runlist">{runs.value.map((r) => <Card key={r.id} run={r} />)}</ul> : <p class="empty">None yet.</p>}
    </div>
  );
}
