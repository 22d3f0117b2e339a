// The workspace of studies: what is asked for, and the study that is shown, which may still be running.
import { batch, computed, effect, signal, untracked } from '@preact/signals';
import { ApiError, get, post } from '../api/client';
import type { LayTable, LayTableAnswer, Matrix, MatrixCase, Run, Study } from '../api/types';
import { gridFault, gridYaml, kDepth, kTension, usualGrid, usualLimits, type GridWish, type LayLimits } from '../logic/layGrid';
import { layWishFault, rangeText, usualRange, type LayTableWish } from '../logic/laytable';
import { variableKeys } from '../logic/seek';
import { kUtilisation } from '../logic/studies';
import { emptyAxis, caseCount, firstAxis, studyFault, studyYaml, type ModelKeys, type StudyKind, type StudyWish } from '../logic/studyFile';
import { parseQuantity, toSi } from '../logic/units';
import { findVariable } from '../logic/variables';
import { base, solution, values } from './live';
import { byPath, errors, fields, fileName, opened, revision, setKeys } from './model';
import { say, sayError } from './notices';
import { fetchRuns, runs } from './runs';
import { goTo } from './workspace';

/** Of a lay table: depths by tensions, or one of the three. */
export type TableOver = 'grid' | LayTableWish['vary'];

const chosenKind = signal<StudyKind | null>(null);
const hasLay = computed(() => byPath.value.get(kTension)?.given === true);
/** A lay table where the model has a lay. */
export const kind = computed<StudyKind>(() => chosenKind.value ?? (hasLay.value ? 'table' : 'study'));
export const tableOver = signal<TableOver>('grid');
const gridWish = signal<GridWish | null>(null);
const layWish = signal<LayTableWish | null>(null);
const studyWish = signal<StudyWish | null>(null);
/** The text of the study file, where it was edited by hand. */
export const editedFile = signal<string | null>(null);

export const limits = signal<LayLimits>(usualLimits);
export const output = signal(kUtilisation);
export const fixed = signal<Record<number, number>>({});
/** The number of the case that is chosen. */
export const chosenCase = signal<number | null>(null);
/** The picture stands beside the table. */
export const pictureShown = signal(false);
export const busy = signal(false);
export const refused = signal('');

const firstStudy = (): StudyWish => {
  const key = hasLay.value ? byPath.value.get(kTension) : variableKeys(fields.value)[0];
  return { analysis: 'static', axes: [key ? firstAxis(key) : emptyAxis()], seeds: '', duration: '', gather: '', over: '', resolution: '' };
};
const usualLay = (vary: LayTableWish['vary']): LayTableWish =>
  usualRange(vary, solution.value?.key ?? null, byPath.value.get(kDepth)?.si ?? null);

export const grid = computed<GridWish>(() => gridWish.value ?? usualGrid(byPath.value));
export const lay = computed<LayTableWish>(() => layWish.value ?? usualLay(tableOver.value === 'grid' ? 'tension' : tableOver.value));
export const wish = computed<StudyWish>(() => studyWish.value ?? firstStudy());

/** What was asked for is another question now: no refusal and no edited text belongs to it. */
const ask = (change: () => void): void => batch(() => { refused.value = ''; editedFile.value = null; change(); });

export const setKind = (next: StudyKind): void => ask(() => {
  chosenKind.value = next;
  if (next === 'operability' && !wish.value.over) setStudy({ over: wish.value.axes[0]?.key ?? '' });
});
export const setTableOver = (next: TableOver): void => ask(() => { tableOver.value = next; layWish.value = null; });
export const setGrid = (part: Partial<GridWish>): void => ask(() => { gridWish.value = { ...grid.value, ...part }; });
export const setLay = (part: Partial<LayTableWish>): void => ask(() => { layWish.value = { ...lay.value, ...part }; });
export const setStudy = (part: Partial<StudyWish>): void => ask(() => { studyWish.value = { ...wish.value, ...part }; });

const model: ModelKeys = {
  unit: (key) => parseQuantity(String(byPath.value.get(key)?.value ?? ''))?.unit || (byPath.value.get(key)?.unit ?? ''),
  value: (key) => String(byPath.value.get(key)?.value ?? ''),
};
export const modelKeys = model;

/** A lay table over one key is made by the program at once; everything else is a study. */
export const isPlainTable = computed(() => kind.value === 'table' && tableOver.value !== 'grid');

export const fault = computed<string | null>(() => {
  if (errors.value.length) return 'the model has errors: correct them first';
  if (editedFile.value !== null) return editedFile.value.trim() ? null : 'the study file is empty';
  if (kind.value !== 'table') return studyFault(kind.value, wish.value, model);
  return tableOver.value === 'grid' ? gridFault(grid.value, model) : layWishFault(lay.value);
});

/** As the program writes it from what is asked for. */
export const plainFile = computed(() => {
  const base = fileName.value || 'model.yaml';
  return kind.value === 'table' ? gridYaml(grid.value, base, model) : studyYaml(kind.value, wish.value, base, model);
});
export const file = computed(() => editedFile.value ?? plainFile.value);

export const count = computed(() => {
  if (isPlainTable.value) return Number(lay.value.steps) + 1;
  if (kind.value === 'table') return caseCount('study', { ...firstStudy(), axes: [{ ...grid.value.rows, key: kDepth }, { ...grid.value.columns, key: kTension }] });
  return caseCount(kind.value, wish.value);
});

/** Seconds of a case by analysis, from studies of this session. */
const pace = signal<Record<string, number>>({});

/** Expected time in seconds; null where nothing is known. */
export const expected = computed<number | null>(() => {
  const analysis = kind.value === 'table' ? 'static' : wish.value.analysis, known = pace.value[analysis];
  if (kind.value === 'operability' || editedFile.value !== null) return null;
  if (known !== undefined) return known * count.value;
  return analysis === 'static' && solution.value ? solution.value.solve_ms / 1000 * count.value : null;
});

export const layTable = signal<{ of: LayTable; revision: number } | null>(null);
/** The study that is shown; null: the lay table, or nothing. */
export const shownId = signal<string | null>(null);
export const matrix = signal<Matrix | null>(null);
/** Of several seeds or a comparison. */
export const gathered = signal<Study | null>(null);
const madeOf = new Map<string, number>();

export const studies = computed<Run[]>(() => runs.value.filter((r) => !r.parent && (r.kind === 'study' || r.kind === 'seeds' || r.kind === 'comparison')));
export const shownRun = computed<Run | null>(() => studies.value.find((r) => r.id === shownId.value) ?? null);
/** The model has changed since; of studies of an earlier session it is not known. */
export const outdated = computed(() => {
  const made = shownId.value === null ? layTable.value?.revision : madeOf.get(shownId.value);
  return made !== undefined && made !== revision.value;
});

export function showStudy(id: string | null): void {
  batch(() => {
    if (id !== shownId.value) { matrix.value = null; gathered.value = null; chosenCase.value = null; fixed.value = {}; output.value = kUtilisation; }
    shownId.value = id;
  });
}

/** From elsewhere in the page. */
export function openStudy(id: string): void { showStudy(id); goTo('study'); }

async function makeTable(): Promise<void> {
  const asked = revision.value, of = opened.value;
  const answer = await post<LayTableAnswer>('lay-table', { vary: lay.value.vary, range: rangeText(lay.value) });
  if (of !== opened.value) return;
  if (answer.status !== 'ok') { refused.value = answer.diagnostics[0]?.message ?? 'the model has errors'; return; }
  batch(() => { showStudy(null); layTable.value = { of: answer, revision: asked }; });
}

async function startStudy(): Promise<void> {
  const asked = revision.value;
  const { id } = await post<{ id: string }>('runs', { kind: 'study', study: file.value });
  madeOf.set(id, asked);
  await fetchRuns();
  showStudy(id);
}

const errorWords = (error: unknown): string => (error instanceof ApiError ? [error.message, error.hint].filter(Boolean).join('; ') : String(error));

export async function solveStudy(): Promise<void> {
  if (busy.value || fault.value) return;
  busy.value = true;
  refused.value = '';
  try { await (isPlainTable.value ? makeTable() : startStudy()); } catch (error) { refused.value = errorWords(error); }
  busy.value = false;
}

/** Values in SI of keys by their texts; null where one of them cannot be tried out. */
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

/** Shows a case in the live statics, without a change of the model. */
export function tryValues(set: Record<string, number>): void { values.value = set; }

export function openInLay(set: Record<string, number>): void { tryValues(set); goTo('lay'); }

/** Writes the values of a case into the model, which one undo takes back. */
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

/** The table is asked for this often while cases come in [ms]; a large one less often. */
const pause = (): number => ((matrix.value?.cases.length ?? 0) > 500 ? 3000 : 700);

function notePace(run: Run, since: number): void {
  const m = matrix.value;
  const done = m?.cases.length;
  if (run.state === 'done' && m && done && !m.operability) pace.value = { ...pace.value, [m.analysis]: (performance.now() - since) / 1000 / done };
}

/** Follows the study that is shown. */
export function startStudies(): void {
  let followed = '', timer = 0, began = 0;
  // another model has other keys
  effect(() => {
    void opened.value;
    untracked(() => batch(() => {
      chosenKind.value = null; gridWish.value = null; layWish.value = null; studyWish.value = null; editedFile.value = null;
      layTable.value = null; limits.value = usualLimits; refused.value = '';
      showStudy(null);
    }));
    madeOf.clear();
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
