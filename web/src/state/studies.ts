// The study workspace: the request, and the study shown, which may still be running.
import { batch, computed, effect, signal, untracked } from '@preact/signals';
import { ApiError, get, post } from '../api/client';
import type { LayTable, LayTableAnswer, Matrix, MatrixCase, Run, Study } from '../api/types';
import { findGridError, gridYaml, kDepth, kTension, usualGrid, usualLimits, type GridRequest, type LayLimits } from '../logic/layGrid';
import { findLayTableError, rangeText, usualRange, type LayTableRequest } from '../logic/laytable';
import { variableKeys } from '../logic/seek';
import { kUtilisation } from '../logic/studies';
import { emptyAxis, caseCount, firstAxis, findStudyError, studyYaml, type ModelKeys, type StudyKind, type StudyRequest } from '../logic/studyFile';
import { parseQuantity, toSi } from '../logic/units';
import { findVariable } from '../logic/variables';
import { base, solution, values } from './live';
import { byPath, errors, fields, fileName, opened, revision, setKeys } from './model';
import { say, sayError } from './notices';
import { fetchRuns, runs } from './runs';
import { goTo } from './workspace';

/** Type of a lay table: depths by tensions, or over one of the three keys. */
export type TableOver = 'grid' | LayTableRequest['vary'];

const chosenKind = signal<StudyKind | null>(null);
const hasLay = computed(() => byPath.value.get(kTension)?.given === true);
/** A lay table if the model has a lay. */
export const kind = computed<StudyKind>(() => chosenKind.value ?? (hasLay.value ? 'table' : 'study'));
export const tableOver = signal<TableOver>('grid');
const gridRequest = signal<GridRequest | null>(null);
const layTableRequest = signal<LayTableRequest | null>(null);
const studyRequest = signal<StudyRequest | null>(null);
/** Text of the study file, if edited by hand. */
export const editedFile = signal<string | null>(null);

export const limits = signal<LayLimits>(usualLimits);
export const output = signal(kUtilisation);
export const fixed = signal<Record<number, number>>({});
/** Number of the selected case. */
export const chosenCase = signal<number | null>(null);
/** The picture is shown next to the table. */
export const pictureShown = signal(false);
export const busy = signal(false);
export const rejection = signal('');

const firstStudy = (): StudyRequest => {
  const key = hasLay.value ? byPath.value.get(kTension) : variableKeys(fields.value)[0];
  return { analysis: 'static', axes: [key ? firstAxis(key) : emptyAxis()], seeds: '', duration: '', gather: '', over: '', resolution: '' };
};
const usualLay = (vary: LayTableRequest['vary']): LayTableRequest =>
  usualRange(vary, solution.value?.key ?? null, byPath.value.get(kDepth)?.si ?? null);

export const grid = computed<GridRequest>(() => gridRequest.value ?? usualGrid(byPath.value));
export const lay = computed<LayTableRequest>(() => layTableRequest.value ?? usualLay(tableOver.value === 'grid' ? 'tension' : tableOver.value));
export const request = computed<StudyRequest>(() => studyRequest.value ?? firstStudy());

/** The request has changed: its rejection and the edited text no longer apply. */
const ask = (change: () => void): void => batch(() => { rejection.value = ''; editedFile.value = null; change(); });

export const setKind = (next: StudyKind): void => ask(() => {
  chosenKind.value = next;
  if (next === 'operability' && !request.value.over) setStudy({ over: request.value.axes[0]?.key ?? '' });
});
export const setTableOver = (next: TableOver): void => ask(() => { tableOver.value = next; layTableRequest.value = null; });
export const setGrid = (part: Partial<GridRequest>): void => ask(() => { gridRequest.value = { ...grid.value, ...part }; });
export const setLay = (part: Partial<LayTableRequest>): void => ask(() => { layTableRequest.value = { ...lay.value, ...part }; });
export const setStudy = (part: Partial<StudyRequest>): void => ask(() => { studyRequest.value = { ...request.value, ...part }; });

const model: ModelKeys = {
  unit: (key) => parseQuantity(String(byPath.value.get(key)?.value ?? ''))?.unit || (byPath.value.get(key)?.unit ?? ''),
  value: (key) => String(byPath.value.get(key)?.value ?? ''),
};
export const modelKeys = model;

/** A lay table over one key is computed at once; everything else is a study. */
export const isPlainTable = computed(() => kind.value === 'table' && tableOver.value !== 'grid');

export const inputError = computed<string | null>(() => {
  if (errors.value.length) return 'the model has errors: correct them first';
  if (editedFile.value !== null) return editedFile.value.trim() ? null : 'the study file is empty';
  if (kind.value !== 'table') return findStudyError(kind.value, request.value, model);
  return tableOver.value === 'grid' ? findGridError(grid.value, model) : findLayTableError(lay.value);
});

/** Study file generated from the request. */
export const plainFile = computed(() => {
  const base = fileName.value || 'model.yaml';
  return kind.value === 'table' ? gridYaml(grid.value, base, model) : studyYaml(kind.value, request.value, base, model);
});
export const file = computed(() => editedFile.value ?? plainFile.value);

export const count = computed(() => {
  if (isPlainTable.value) return Number(lay.value.steps) + 1;
  if (kind.value === 'table') return caseCount('study', { ...firstStudy(), axes: [{ ...grid.value.rows, key: kDepth }, { ...grid.value.columns, key: kTension }] });
  return caseCount(kind.value, request.value);
});

/** Seconds per case by analysis, from studies of this session. */
const pace = signal<Record<string, number>>({});

/** Expected time in seconds; null if unknown. */
export const expected = computed<number | null>(() => {
  const analysis = kind.value === 'table' ? 'static' : request.value.analysis, known = pace.value[analysis];
  if (kind.value === 'operability' || editedFile.value !== null) return null;
  if (known !== undefined) return known * count.value;
  return analysis === 'static' && solution.value ? solution.value.solve_ms / 1000 * count.value : null;
});

export const layTable = signal<{ of: LayTable; revision: number } | null>(null);
/** The study shown; null: the lay table, or none. */
export const shownId = signal<string | null>(null);
export const matrix = signal<Matrix | null>(null);
/** Results of several seeds or of a comparison. */
export const gathered = signal<Study | null>(null);
const revisions = new Map<string, number>();

export const studies = computed<Run[]>(() => runs.value.filter((r) => !r.parent && (r.kind === 'study' || r.kind === 'seeds' || r.kind === 'comparison')));
export const shownRun = computed<Run | null>(() => studies.value.find((r) => r.id === shownId.value) ?? null);
/** The model has changed since; unknown for studies of an earlier session. */
export const outdated = computed(() => {
  const made = shownId.value === null ? layTable.value?.revision : revisions.get(shownId.value);
  return made !== undefined && made !== revision.value;
});

export function showStudy(id: string | null): void {
  batch(() => {
    if (id !== shownId.value) { matrix.value = null; gathered.value = null; chosenCase.value = null; fixed.value = {}; output.value = kUtilisation; }
    shownId.value = id;
  });
}

/** Opened from another part of the page. */
export function openStudy(id: string): void { showStudy(id); goTo('study'); }

async function makeTable(): Promise<void> {
  const asked = revision.value, of = opened.value;
  const answer = await post<LayTableAnswer>('lay-table', { vary: lay.value.vary, range: rangeText(lay.value) });
  if (of !== opened.value) return;
  if (answer.status !== 'ok') { rejection.value = answer.diagnostics[0]?.message ?? 'the model has errors'; return; }
  batch(() => { showStudy(null); layTable.value = { of: answer, revision: asked }; });
}

async function startStudy(): Promise<void> {
  const asked = revision.value;
  const { id } = await post<{ id: string }>('runs', { kind: 'study', study: file.value });
  revisions.set(id, asked);
  await fetchRuns();
  showStudy(id);
}

const errorText = (error: unknown): string => (error instanceof ApiError ? [error.message, error.hint].filter(Boolean).join('; ') : String(error));

export async function solveStudy(): Promise<void> {
  if (busy.value || inputError.value) return;
  busy.value = true;
  rejection.value = '';
  try { await (isPlainTable.value ? makeTable() : startStudy()); } catch (error) { rejection.value = errorText(error); }
  busy.value = false;
}

/** SI values of keys from their texts; null if one of them cannot be tried out. */
export function triedValues(keys: readonly { key: string; text: string }[]): Record<string, number> | null {
  const out: Record<string, number> = {};
  for (const { key, text } of keys) {
    const quantity = parseQuantity(text), si = quantity ? toSi(quantity.number, quantity.unit) : NaN;
    if (!findVariable(key, base.value) || !Number.isFinite(si)) return null;
    out[key] = si;
  }
  return out;
}

export const caseKeys = (m: Matrix, c: MatrixCase): { key: string; text: string }[] => m.inputs.map(({ key }, i) => ({ key, text: c.words[i]! }));

/** Shows a case in the live statics, without changing the model. */
export function tryValues(set: Record<string, number>): void { values.value = set; }

export function openInLay(set: Record<string, number>): void { tryValues(set); goTo('lay'); }

/** Writes the values of a case into the model, as one undo step. */
export async function takeIntoModel(keys: readonly { key: string; text: string }[], name: string): Promise<void> {
  try {
    await setKeys(keys.map(({ key, text }) => ({ path: key, value: text })));
    values.value = {};
    say(`The model has the values of ${name}`);
  } catch (error) { sayError(error); }
}

let asked = 0;

async function load(run: Run): Promise<void> {
  const mine = ++asked, current = (): boolean => mine === asked && shownId.value === run.id;
  try {
    if (run.kind === 'study') {
      const answer = await get<Matrix | null>(`runs/${run.id}/matrix`);
      if (current()) matrix.value = answer;
    } else if (run.has_results && run.state === 'done') {
      const answer = await get<Study>(`runs/${run.id}/study`);
      if (current()) gathered.value = answer;
    }
  } catch (error) { if (current() && run.has_results) sayError(error); }
}

/** Interval of table requests while cases are computed [ms]; longer for a large table. */
const pause = (): number => ((matrix.value?.cases.length ?? 0) > 500 ? 3000 : 700);

function notePace(run: Run, since: number): void {
  const m = matrix.value;
  const done = m?.cases.length;
  if (run.state === 'done' && m && done && !m.operability) pace.value = { ...pace.value, [m.analysis]: (performance.now() - since) / 1000 / done };
}

/** Follows the study shown. */
export function startStudies(): void {
  let followed = '', timer = 0, began = 0;
  // another model has other keys
  effect(() => {
    void opened.value;
    untracked(() => batch(() => {
      chosenKind.value = null; gridRequest.value = null; layTableRequest.value = null; studyRequest.value = null; editedFile.value = null;
      layTable.value = null; limits.value = usualLimits; rejection.value = '';
      showStudy(null);
    }));
    revisions.clear();
  });
  effect(() => {
    const run = shownRun.value, key = run ? `${run.id} ${run.state}` : '';
    untracked(() => {
      if (key === followed) return;
      const before = followed;
      followed = key;
      clearTimeout(timer);
      if (!run) return;
      if (run.state === 'running') began = performance.now();
      const follow = (): void => {
        void load(run).then(() => {
          if (followed !== key) return;
          if (run.state === 'running') timer = window.setTimeout(follow, pause());
          else if (before === `${run.id} running`) notePace(run, began);
        });
      };
      follow();
    });
  });
}
