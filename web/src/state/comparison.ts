// What results are compared with: the model as it was, or a run.
import { effect, signal } from '@preact/signals';
import { get } from '../api/client';
import type { Lay } from '../api/types';
import { calm } from './live';
import { opened } from './model';
import { sayError } from './notices';

export const comparison = signal<{ name: string; lay: Lay } | null>(null);

/** Keeps the results of this moment, so that what follows is seen against them. */
export function compareWithNow(): void {
  if (calm.value) comparison.value = { name: 'as it was', lay: calm.value };
}

export async function compareWithRun(id: string, name: string): Promise<void> {
  try {
    comparison.value = { name, lay: await get<Lay>(`runs/${id}/statics`) };
  } catch (error) { sayError(error); }
}

// another model is not compared with the one before unasked
effect(() => { void opened.value; comparison.value = null; });
