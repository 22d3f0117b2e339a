// Runs of the folder as a table: filter, order, selection of several, and their commands.
import { useRef } from 'preact/hooks';
import { signal } from '@preact/signals';
import type { Run } from '../../api/types';
import { matches, nextRunOrder, noFilter, orderedRuns, runColumns, runTable, kindNames, stateNames, type RunFilter, type RunOrder } from '../../logic/runTable';
import { checked } from '../../state/compare';
import { runName, runs } from '../../state/runs';
import { runCases } from '../../state/runActions';
import { TableTools } from '../TableTools';
import { RunActions } from './RunActions';
import { RunRow, unfolded } from './RunRow';
import '../../styles/runs.css';

const filter = signal<RunFilter>(noFilter);
const order = signal<RunOrder>({ column: 'started', descending: true });

function Choice({ name, value, options, set }: { name: string; value: string; options: Record<string, string>; set: (value: string) => void }) {
  return (
    <select aria-label={name} value={value} onChange={(e) => set(e.currentTarget.value)}>
      <option value="">every {name}</option>
      {Object.entries(options).map(([id, text]) => <option key={id} value={id}>{text}</option>)}
    </select>
  );
}

function Filter() {
  const current = filter.value;
  return (
    <div class="runfilter" role="search" aria-label="Filter of the runs">
      <input type="search" aria-label="Text in name, note or verdict" placeholder="name, note, verdict…" value={current.text} onInput={(e) => { filter.value = { ...current, text: e.currentTarget.value }; }} />
      <Choice name="kind" value={current.kind} options={kindNames} set={(kind) => { filter.value = { ...current, kind }; }} />
      <Choice name="state" value={current.state} options={stateNames} set={(state) => { filter.value = { ...current, state }; }} />
      {current === noFilter ? null : <button type="button" class="tiny" onClick={() => { filter.value = noFilter; }}>all</button>}
    </div>
  );
}

function Head({ shown }: { shown: Run[] }) {
  const { column, descending } = order.value, all = shown.length > 0 && shown.every((run) => checked.value.includes(run.id));
  return (
    <thead>
      <tr>
        <th class="pick"><input type="checkbox" aria-label="Choose every run shown" checked={all} onChange={() => { checked.value = all ? [] : shown.map((run) => run.id); }} /></th>
        {runColumns.map((name) => (
          <th key={name} scope="col" class={name === 'duration' || name === 'utilisation' ? 'n' : undefined} aria-sort={column === name ? (descending ? 'descending' : 'ascending') : 'none'}>
            <button type="button" class="sort" onClick={() => { order.value = nextRunOrder(order.value, name); }}>{name}</button>
          </th>
        ))}
      </tr>
    </thead>
  );
}

/** Arrow keys move from row to row. */
function step(e: KeyboardEvent, table: HTMLElement | null): void {
  const way = e.key === 'ArrowDown' ? 1 : e.key === 'ArrowUp' ? -1 : 0;
  if (!way || !table || (e.target as HTMLElement).tagName === 'INPUT' && (e.target as HTMLInputElement).type !== 'checkbox') return;
  const rows = [...table.querySelectorAll<HTMLElement>('tbody tr')], index = rows.findIndex((row) => row.contains(document.activeElement));
  e.preventDefault();
  rows[Math.max(0, Math.min(rows.length - 1, index + way))]?.focus();
}

export function RunsTable() {
  const table = useRef<HTMLTableElement>(null);
  const whole = runs.value.filter((run) => !run.parent), shown = orderedRuns(whole.filter((run) => matches(run, runName(run), filter.value)), order.value, runName);
  if (whole.length === 0) return <p class="empty">No runs in this folder yet. Start storms in Storm, studies in Study, and stages in Operation.</p>;
  return (
    <div class="runstab">
      <div class="runsbar">
        <Filter />
        <span class="brief" role="status">{shown.length === whole.length ? `${whole.length} runs` : `${shown.length} of ${whole.length} runs`}{checked.value.length ? `, ${checked.value.length} chosen` : ''}</span>
        <TableTools table={() => runTable(shown, runName)} file="runs" />
      </div>
      <RunActions />
      <div class="runsscroll">
        <table ref={table} class="runlist" role="grid" aria-label="Runs" aria-multiselectable="true" onKeyDown={(e) => step(e, table.current)}>
          <Head shown={shown} />
          <tbody>
            {shown.flatMap((run, i) => [
              <RunRow key={run.id} run={run} first={i === 0} />,
              ...(unfolded.value.includes(run.id) ? runCases(run).map((item) => <RunRow key={item.id} run={item} inner />) : []),
            ])}
          </tbody>
        </table>
        {shown.length === 0 ? <p class="empty">No matching runs. <button type="button" onClick={() => { filter.value = noFilter; }}>Show all</button></p> : null}
      </div>
    </div>
  );
}
