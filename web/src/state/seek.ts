// Request of the goal seek dialog: a result, a key, or both.
import { signal } from '@preact/signals';
import { seekGoals, type SeekTarget } from '../logic/seek';
import { calm } from './live';
import { dialog } from './look';

export interface Sought { goal: SeekTarget; key: string }
export const sought = signal<Sought | null>(null);

/** By default the maximum utilisation and the usual key. */
export function openSeek(start: { goal?: SeekTarget; key?: string } = {}): void {
  const goal = start.goal ?? (calm.value ? seekGoals(calm.value)[0] : undefined);
  if (!goal) return;
  sought.value = { goal, key: start.key ?? '' };
  dialog.value = 'seek';
}
