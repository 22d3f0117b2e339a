// A row of the list of runs.
import { useState } from 'preact/hooks';
import { signal } from '@preact/signals';
import type { Run } from '../../api/types';
import { durationText, kindText, startedText, stateMarks, stateNames, verdictMarks } from '../../logic/runTable';
import { duration as formatDuration } from '../../logic/show';
import { tidy } from '../../logic/units';
import { withoutPaths } from '../../logic/findings';
import { check, checked } from '../../state/compare';
import { annotate, runName, select, timeToFinish } from '../../state/runs';
import { runCases, look } from '../../state/runActions';

/** Studies whose cases are listed. */
export const unfolded = signal<readonly string[]>([]);
/** The run that is being renamed. */
export const renaming = signal('');

function NameField({ run }: { run: Run }) {
  const [name, setName] = useState(run.name);
  const keep = (): void => {
    if (renaming.value !== run.id) return;
    renaming.value = '';
    if (name.trim() !== run.name) void annotate(run.id, { name: name.trim() });
  };
  return (
    <input
      aria-label="Name of the run" value={name} placeholder={run.title}
      ref={(input) => input?.focus()}
      onClick={(e) => e.stopPropagation()}
      onInput={(e) => setName(e.currentTarget.value)}
      onBlur={keep}
      onKeyDown={(e) => {
        e.stopPropagation();
        if (e.key === 'Enter') keep();
        if (e.key === 'Escape') renaming.value = '';
      }}
    />
  );
}

function Name({ run, inner }: { run: Run; inner: boolean }) {
  const cases = inner ? 0 : runCases(run).length, open = unfolded.value.includes(run.id);
  const fold = (e: Event): void => { e.stopPropagation(); unfolded.value = open ? unfolded.value.filter((id) => id !== run.id) : [...unfolded.value, run.id]; };
  return (
    <td class="name" title={run.note || undefined}>
      {cases ? <button type="button" class="tiny foldcases" aria-expanded={open} aria-label={`Cases of ${runName(run)}`} onClick={fold}>{open ? '▾' : '▸'}</button> : null}
      {renaming.value === run.id ? <NameField run={run} /> : <span onDblClick={() => { if (!inner) renaming.value = run.id; }}>{runName(run)}</span>}
      {cases ? <small> {cases} cases</small> : null}
      {run.note ? <small class="runnote"> {run.note}</small> : null}
    </td>
  );
}

function State({ run }: { run: Run }) {
  const left = run.state === 'running' ? timeToFinish(run) : null;
  if (run.state !== 'running') return <td class={run.state} title={withoutPaths(run.message)}><span class="statemark" aria-hidden="true">{stateMarks[run.state]}</span> {stateNames[run.state]}</td>;
  return (
    <td class="running">
      <div class="bar" role="progressbar" aria-valuemin={0} aria-valuemax={100} aria-valuenow={Math.round(100 * run.progress)}><i style={{ width: `${100 * run.progress}%` }} /></div>
      <small>{Math.round(100 * run.progress)} %{left === null ? '' : `, ${formatDuration(left)} left`}{run.time === undefined ? '' : ` · t = ${tidy(run.time, 4)} s`}</small>
    </td>
  );
}

function Verdict({ run }: { run: Run }) {
  const look = run.verdict ? verdictMarks[run.verdict.kind] : undefined;
  return <td class="verdictcell" title={run.verdict?.words}>{look ? <><span class={`light ${look.level}`} aria-hidden="true">{look.mark}</span>{run.verdict!.kind}</> : '–'}</td>;
}

export function RunRow({ run, inner = false, first = false }: { run: Run; inner?: boolean; first?: boolean }) {
  const on = checked.value.includes(run.id), only = on && checked.value.length === 1;
  const choose = (e: MouseEvent | KeyboardEvent): void => {
    if (e.ctrlKey || e.metaKey || e.shiftKey) check(run.id, !on);
    else { checked.value = [run.id]; select(run.id); }
  };
  const key = (e: KeyboardEvent): void => {
    if (e.target !== e.currentTarget) return;
    if (e.key === ' ') { e.preventDefault(); check(run.id, !on); }
    else if (e.key === 'Enter') { if (only) look(run); else choose(e); }
    else if (e.key === 'F2' && !inner) renaming.value = run.id;
  };
  return (
    <tr class={`${inner ? 'inner ' : ''}${on ? 'chosen' : ''}`} tabIndex={only || first ? 0 : -1} aria-selected={on} data-run={run.id} onClick={choose} onKeyDown={key}>
      <td class="pick"><input type="checkbox" aria-label={`Choose ${runName(run)}`} checked={on} tabIndex={-1} onClick={(e) => e.stopPropagation()} onChange={() => check(run.id, !on)} /></td>
      <Name run={run} inner={inner} />
      <td>{kindText(run)}</td>
      <State run={run} />
      <td>{run.started ? startedText(run.started) : '–'}</td>
      <Verdict run={run} />
      <td class="n">{durationText(run)}</td>
      <td class="n">{run.utilisation === undefined ? '–' : run.utilisation.toFixed(3)}</td>
    </tr>
  );
}
