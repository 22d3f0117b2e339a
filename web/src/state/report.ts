// The report workspace: the reported results, whether they are outdated, and print settings.
import { computed, effect, signal, untracked } from '@preact/signals';
import { post } from '../api/client';
import type { Run } from '../api/types';
import { hasOperation, operation, outdated as stagesOutdated, solveOperation, solving } from './operation';
import { errors, opened, revision } from './model';
import { sayError } from './notices';
import { fetchRuns, reportPath, runs, tablePath } from './runs';

/** Statics of the open model, stages of its operation, or the id of a run. */
export type Subject = 'statics' | 'operation' | { run: string };

const chosen = signal<Subject | null>(null);
/** Stages if the model has an operation, otherwise its statics. */
export const subject = computed<Subject>(() => chosen.value ?? (hasOperation.value ? 'operation' : 'statics'));
export const chooseSubject = (next: Subject): void => { chosen.value = next; };

/** The static run made for the report, and the revision of its model. */
const statics = signal<{ id: string; revision: number } | null>(null);
const stagesMade = signal(0);
export const making = signal(false);
/** Sections omitted in print, by their headings. */
export const leftOut = signal<readonly string[]>([]);
export const paper = signal<'own' | 'A4' | 'letter'>('own');

/** Revision of the model at the start of a run of this session. */
const startedAt = new Map<string, number>();

/** Runs with a separate report. */
export const reported = computed<Run[]>(() => runs.value.filter((r) => r.has_results && r.kind !== 'seeds'));
const subjectRun = computed<Run | null>(() => {
  const id = subject.value === 'statics' ? statics.value?.id : typeof subject.value === 'object' ? subject.value.run : undefined;
  return runs.value.find((r) => r.id === id) ?? null;
});

/** Paths below /api; `made` counts the reports with the same path. */
export interface ReportFiles { report: string; made: number; csv: string | null; name: string }

/** Files of the report; null before it is made. */
export const files = computed<ReportFiles | null>(() => {
  if (subject.value === 'operation') {
    return operation.value ? { report: 'operation/report.html', made: stagesMade.value, csv: null, name: 'operation' } : null;
  }
  const run = subjectRun.value;
  return run?.has_results ? { report: reportPath(run.id), made: 0, csv: tablePath(run.id), name: run.id } : null;
});

export const busy = computed(() => making.value || (subject.value === 'operation' && solving.value));

/** The model has changed since; unknown for runs of an earlier session. */
export const outdated = computed(() => {
  if (!files.value) return false;
  if (subject.value === 'operation') return stagesOutdated.value;
  const made = subject.value === 'statics' ? statics.value?.revision : startedAt.get(subject.value.run);
  return made !== undefined && made !== revision.value;
});

/** True if the report can be made, or is that of a run. */
export const canMake = computed(() => typeof subject.value === 'string' && errors.value.length === 0);

const ended = (run: Run | undefined): boolean => run !== undefined && run.state !== 'queued' && run.state !== 'running';

/** Waits for the end of a run, reported by the events. */
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

/** Makes the report of the present model. */
export async function makeReport(): Promise<void> {
  if (!canMake.value || busy.value) return;
  making.value = true;
  try {
    if (subject.value === 'operation') { await solveOperation(); ++stagesMade.value; } else await makeStatics();
  } catch (error) { sayError(error); } finally { making.value = false; }
}

/** Runs started while this page was open belong to the model at that time. */
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
