// Runs: watch one, look at earlier ones; the cases of a study lie within it.
import { useRef, useState } from 'preact/hooks';
import { duration as inWords, numberIn, unitName } from '../logic/show';
import { isStudy } from '../logic/runs';
import { tidy } from '../logic/units';
import { withoutPaths } from '../logic/findings';
import type { Run } from '../api/types';
import { annotate, cancelRun, deleteRun, reportAddress, reportToShow, resumeRun, runName, runs, select, selected, selectedId, timeToFinish } from '../state/runs';
import { ReportLinks } from './ReportLinks';
import { StartRun } from './StartRun';

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
  const kept = useRef({ name: run.name, note: run.note });  // as last sent: `run` has it only with the answer
  const keep = (): void => {
    const words = { ...(name === kept.current.name ? {} : { name: name.trim() }), ...(note === kept.current.note ? {} : { note: note.trim() }) };
    const before = kept.current;
    kept.current = { name, note };
    if (Object.keys(words).length) void annotate(run.id, words).then((done) => { if (!done) kept.current = before; });
  };
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

const kindWords = (run: Run): string => (run.kind === 'static' ? 'static' : run.kind === 'dynamic' ? 'dynamic' : run.kind === 'seeds' ? 'several seeds' : run.kind === 'study' ? 'study' : `comparison, ${run.of}`);

/** The cases of a study, each a run that can be looked at. */
function Cases({ study }: { study: Run }) {
  return (
    <ul class="cases" aria-label="Cases">
      {runs.value.filter((r) => r.parent === study.id).map((one) => (
        <li key={one.id} class={one.state}>
          <button type="button" aria-pressed={selectedId.value === one.id} onClick={() => select(selectedId.value === one.id ? study.id : one.id)} title={withoutPaths(one.message)}>
            <span>{one.title}</span><small>{one.state === 'running' ? `${Math.round(100 * one.progress)} %` : words[one.state]}</small>
          </button>
        </li>
      ))}
    </ul>
  );
}

function Card({ run }: { run: Run }) {
  const mine = selectedId.value === run.id;
  const left = run.state === 'running' ? timeToFinish(run) : null;
  const going = run.state === 'running' || run.state === 'queued';
  return (
    <li class={`run ${run.state}${mine ? ' chosen' : ''}`}>
      <button type="button" class="runhead" aria-pressed={mine} onClick={() => select(mine ? null : run.id)}>
        <b>{runName(run)}</b>
        <span class="brief">{kindWords(run)} · {words[run.state]}{run.started ? ` · ${when(run.started)}` : ''}</span>
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
              {run.top_tension !== undefined ? <div class="kv"><dt>top tension</dt><dd>{numberIn(run.top_tension, 'N')} <small>{unitName('N')}</small></dd></div> : null}
              {run.worst_stress !== undefined ? <div class="kv"><dt>maximum stress</dt><dd>{numberIn(run.worst_stress, 'Pa')} <small>{unitName('Pa')}</small></dd></div> : null}
            </dl>
          ) : null}
        </>
      ) : null}
      {run.note && !mine ? <p class="note">{run.note}</p> : null}
      {run.message && run.state !== 'done' && !mine ? <p class="brief">{withoutPaths(run.message)}</p> : null}
      {mine ? <Words key={run.id} run={run} /> : null}
      {isStudy(run) && (mine || going || selected.value?.parent === run.id) ? <Cases study={run} /> : null}
      <div class="acts">
        {going ? <button type="button" onClick={() => void cancelRun(run.id)}>Cancel</button> : null}
        {run.has_results && run.kind !== 'seeds' ? <ReportLinks file={reportAddress(run.id)} show={reportToShow(run.id)} name={`${run.id}.html`} /> : null}
        {run.has_results && !mine ? <button type="button" onClick={() => select(run.id)}>{run.kind === 'dynamic' ? 'Animate' : 'Show'}</button> : null}
        {run.resumable && !going ? <button type="button" title="Continue where it was stopped" onClick={() => void resumeRun(run.id)}>Resume</button> : null}
        {mine && !going ? <Delete run={run} /> : null}
      </div>
    </li>
  );
}

export function Runs() {
  const whole = runs.value.filter((r) => !r.parent);
  return (
    <div class="runs">
      <StartRun />
      <h3>Runs of this folder</h3>
      {whole.length ? <ul class="runlist">{whole.map((r) => <Card key={r.id} run={r} />)}</ul> : <p class="empty">None yet.</p>}
    </div>
  );
}
