// The workspace of reports: what is reported, whether the model has changed since, and how it is printed.
import { computed, effect, signal, untracked } from '@preact/signals';
import { address, post } from '../api/client';
import type { Run } from '../api/types';
import { hasOperation, operation, outdated as stagesOutdated, solveOperation, solving } from './operation';
import { errors, opened, revision } from './model';
import { sayError } from './notices';
import { fetchRuns, reportAddress, reportToShow, runs, tableAddress } from './runs';

/** The statics of the open model, the stages of its operation, or the id of a run. */
export type Subject = 'statics' | 'operation' | { run: string };

const chosen = signal<Subject | null>(null);
/** Stages where the model has an operation, else its statics. */
export const subject = computed<Subject>(() => chosen.value ?? (hasOperation.value ? 'operation' : 'statics'));
export const chooseSubject = (next: Subject): void => { chosen.value = next; };

/** The static run that was made for the report, and the revision of the model that it is of. */
const statics = signal<{ id: string; revision: number } | null>(null);
const stagesMade = signal(0);
export const making = signal(false);
/** Sections that are left out when it is printed, by their headings. */
export const leftOut = signal<readonly string[]>([]);
export const paper = signal<'own' | 'A4' | 'letter'>('own');

/** Revision of the model at which a run of this session was started. */
const startedAt = new Map<string, number>();

/** Runs with a report of their own. */
export const reported = computed<Run[]>(() => runs.value.filter((r) => r.has_results && r.kind !== 'seeds'));
const subjectRun = computed<Run | null>(() => {
  const id = subject.value === 'statics' ? statics.value?.id : typeof subject.value === 'object' ? subject.value.run : undefined;
  return runs.value.find((r) => r.id === id) ?? null;
});

export interface ReportFiles { show: string; html: string; csv: string | null; name: string }

/** Addresses of the report; null before it is made. */
export const files = computed<ReportFiles | null>(() => {
  if (subject.value === 'operation') {
    // counted, so that a report that was made again is loaded again
    return operation.value ? { show: address(`operation/report.html?show=1&made=${stagesMade.value}`), html: address('operation/report.html'), csv: null, name: 'operation' } : null;
  }
  const run = subjectRun.value;
  return run?.has_results ? { show: reportToShow(run.id), html: reportAddress(run.id), csv: tableAddress(run.id), name: run.id } : null;
});

export const busy = computed(() => making.value || (subject.value === 'operation' && solving.value));

/** The model has changed since; of runs of an earlier session it is not known. */
export const outdated = computed(() => {
  if (!files.value) return false;
  if (subject.value === 'operation') return stagesOutdated.value;
  const made = subject.value === 'statics' ? statics.value?.revision : startedAt.get(subject.value.run);
  return made !== undefined && made !== revision.value;
});

/** The report of the model as it is now can be made; that of a run is there. */
export const canMake = computed(() => typeof subject.value === 'string' && errors.value.length === 0);

const ended = (run: Run | undefined): boolean => run !== undefined && run.state !== 'queued' && run.state !== 'running';

/** Waits for the end of a run, of which the events tell. */
function whenEnded(id: string): Promise<Run> {
  return new Promise((done) => {
    const stop = effect(() => {
      const run = runs.value.find((r) => r.id === id);
      if (run && ended(run)) untracked(() => { queueMicrotask(() => stop()); done(run); });
    });
  });
}

async function makeStatics(): Promise<void> {
  const asked = revision.value, of = opened.value;
  const { id } = await post<{ id: string }>('runs', { kind: 'static' });
  await fetchRuns();
  const run = await whenEnded(id);
  if (of !== opened.value) return;
  if (run.state !== 'done') throw new Error(run.message || 'The statics of the model have no solution.');
  statics.value = { id, revision: asked };
}

/** Makes the report of the model as it is now. */
export async function makeReport(): Promise<void> {
  if (!canMake.value || busy.value) return;
  making.value = true;
  try {
    if (subject.value === 'operation') { await solveOperation(); ++stagesMade.value; } else await makeStatics();
  } catch (error) { sayError(error); } finally { making.value = false; }
}

/** Runs that were started while this page was open are of the model as it was then. */
const pageOpened = Date.now() / 1000;

export function startReport(): void {
  effect(() => { void opened.value; untracked(() => { chosen.value = null; statics.value = null; leftOut.value = []; }); });
  effect(() => {
    const list = runs.value;
    untracked(() => {
      for (const { id, started } of list) if (!startedAt.has(id) && (started === 0 || started >= pageOpened)) startedAt.set(id, revision.value);
    });
  });
}
