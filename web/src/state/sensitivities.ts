// Sensitivities of the key results, computed on request.
import { effect, signal } from '@preact/signals';
import { post } from '../api/client';
import type { Change, SensitivityAnswer } from '../api/types';
import { changes } from './live';
import { revision } from './model';
import { sayError } from './notices';

export const sensitivities = signal<{ answer: SensitivityAnswer; revision: number; changes: Change[] } | null>(null);
export const findingSensitivities = signal(false);

export async function findSensitivities(): Promise<void> {
  findingSensitivities.value = true;
  const asked = { revision: revision.value, changes: changes.value };
  try {
    const answer = await post<SensitivityAnswer>('sensitivities', { changes: asked.changes });
    if (asked.revision === revision.value) sensitivities.value = { answer, ...asked };
  } catch (error) {
    sayError(error);
  } finally {
    findingSensitivities.value = false;
  }
}

// The model text has changed: the sensitivities do not belong to it.
effect(() => { void revision.value; sensitivities.value = null; });
