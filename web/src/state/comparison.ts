// Reference for the results: an earlier state of the model, or a run.
import { effect, signal } from '@preact/signals';
import { get } from '../api/client';
import type { Lay } from '../api/types';
import { calm } from './live';
import { opened } from './model';
import { sayError } from './notices';

export const comparison = signal<{ name: string; lay: Lay } | null>(null);

/** Stores the present results as the reference. */
export function compareWithNow(): void {
  if (calm.value) comparison.value = { name: 'previous state', lay: calm.value };
}

export async function compareWithRun(id: string, name: string): Promise<void> {
  try {
    comparison.value = { name, lay: await get<Lay>(`runs/${id}/statics`) };
  } catch (error) { sayError(error); }
}

// a new model is not compared with the previous one by default
effect(() => { void opened.value; comparison.value = null; });
