// The list of runs as a table: filter, order, texts.
import type { Cell, TableData } from '../components/document';
import type { Run } from '../api/types';
import { duration } from './show';

export interface RunFilter { text: string; kind: string; state: string }
export const noFilter: RunFilter = { text: '', kind: '', state: '' };

export const kindNames: Record<Run['kind'], string> = { static: 'static', dynamic: 'dynamic', seeds: 'several seeds', comparison: 'comparison', study: 'study' };
export const stateNames: Record<Run['state'], string> = { queued: 'waiting', running: 'running', done: 'done', failed: 'failed', cancelled: 'cancelled' };

export const kindText = (run: Run): string => (run.kind === 'comparison' ? `comparison, ${run.of ?? ''}` : kindNames[run.kind]);

/** The mark repeats the meaning of the colour. */
export const stateMarks: Record<Run['state'], string> = { queued: '◌', running: '▶', done: '●', failed: '✕', cancelled: '■' };

export const verdictMarks: Record<string, { mark: string; level: string }> = {
  passed: { mark: '●', level: 'good' }, reserved: { mark: '▲', level: 'near' }, exceeded: { mark: '✕', level: 'over' }, 'not judged': { mark: '○', level: 'unknown' },
};

type Named = (run: Run) => string;

export function matches(run: Run, name: string, filter: RunFilter): boolean {
  if (filter.kind && run.kind !== filter.kind) return false;
  if (filter.state && run.state !== filter.state) return false;
  const terms = filter.text.toLowerCase().split(/\s+/).filter(Boolean), all = `${name} ${run.note} ${run.changed} ${run.id} ${run.verdict?.words ?? ''}`.toLowerCase();
  return terms.every((word) => all.includes(word));
}

export const runColumns = ['name', 'kind', 'state', 'started', 'verdict', 'duration', 'utilisation'] as const;
export type RunColumn = (typeof runColumns)[number];
export interface RunOrder { column: RunColumn; descending: boolean }

const stateRank: Run['state'][] = ['running', 'queued', 'failed', 'cancelled', 'done'];
const verdictRank = ['exceeded', 'reserved', 'not judged', 'passed'];

function key(run: Run, column: RunColumn, name: Named): number | string | null {
  switch (column) {
    case 'name': return name(run);
    case 'kind': return kindText(run);
    case 'state': return stateRank.indexOf(run.state);
    case 'started': return run.started || null;
    case 'verdict': return run.verdict ? verdictRank.indexOf(run.verdict.kind) : null;
    case 'duration': return run.duration || null;
    default: return run.utilisation ?? null;
  }
}

/** Runs without a value come last in either direction. */
export function orderedRuns(runs: readonly Run[], { column, descending }: RunOrder, name: Named): Run[] {
  const compared = (a: number | string, b: number | string): number => (typeof a === 'string' ? a.localeCompare(String(b), 'en', { numeric: true }) : a - Number(b));
  return [...runs].sort((a, b) => {
    const x = key(a, column, name), y = key(b, column, name);
    if (x === null || y === null) return Number(x === null) - Number(y === null);
    return (descending ? -1 : 1) * compared(x, y);
  });
}

/** Largest and latest first, texts from A first; a second click reverses the order. */
export function nextRunOrder(order: RunOrder, column: RunColumn): RunOrder {
  if (order.column === column) return { column, descending: !order.descending };
  return { column, descending: ['started', 'duration', 'utilisation'].includes(column) };
}

export function startedText(seconds: number, today = new Date()): string {
  const d = new Date(seconds * 1000);
  return d.toDateString() === today.toDateString() ? d.toLocaleTimeString([], { hour: '2-digit', minute: '2-digit' }) : d.toLocaleDateString([], { day: 'numeric', month: 'short', hour: '2-digit', minute: '2-digit' });
}

export const durationText = (run: Run): string => (run.duration ? duration(run.duration) : run.end ? duration(run.end) : '–');

export function runTable(runs: readonly Run[], name: Named): TableData {
  const row = (run: Run): Cell[] => [name(run), kindText(run), stateNames[run.state], run.started ? new Date(run.started * 1000).toISOString() : '', run.verdict?.words ?? '', run.duration || null, run.utilisation ?? null, run.note];
  return {
    title: 'Runs', look: 'dense', rows: runs.map(row),
    columns: [{ title: 'name', words: true }, { title: 'kind', words: true }, { title: 'state', words: true }, { title: 'started', words: true }, { title: 'verdict', words: true }, { title: 'duration', unit: 's', digits: 0 }, { title: 'utilisation', digits: 3 }, { title: 'note', words: true }],
  };
}
