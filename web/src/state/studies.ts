// Studies of many cases: the one that is written in its tab, and what a running or finished one has given so far.
import { effect, signal, untracked } from '@preact/signals';
import { get, post } from '../api/client';
import type { Matrix } from '../api/types';
import type { StudyWish } from '../logic/studies';
import { opened } from './model';
import { sayError } from './notices';
import { fetchRuns, select, selected } from './runs';

export const wish = signal<StudyWish | null>(null);
export const matrix = signal<Matrix | null>(null);

/** While cases come in the table is asked for this often [ms]. */
const kEvery = 1500;
let asked = 0;

async function load(id: string): Promise<void> {
  const mine = ++asked;
  try {
    const answer = await get<Matrix | null>(`runs/${id}/matrix`);
    if (mine === asked && selected.value?.id === id) matrix.value = answer;
  } catch (error) { if (mine === asked && selected.value?.id === id && selected.value.has_results) sayError(error); }
}

export async function startStudy(text: string): Promise<void> {
  const { id } = await post<{ id: string }>('runs', { kind: 'study', study: text });
  await fetchRuns();
  select(id);
}

/** Follows the study that is looked at. */
export function startStudies(): void {
  let shown = '', timer = 0;
  // another model has other keys
  effect(() => { void opened.value; wish.value = null; });
  effect(() => {
    const run = selected.value?.kind === 'study' ? selected.value : null;
    const key = run ? `${run.id} ${run.state}` : '';
    untracked(() => {
      if (key === shown) return;
      if (run?.id !== shown.split(' ')[0]) matrix.value = null;
      shown = key;
      clearInterval(timer);
      if (!run) return;
      void load(run.id);
      if (run.state === 'running') timer = window.setInterval(() => void load(run.id), kEvery);
    });
  });
}
