// What is sought in the dialog "Find a value": a result, a key, or both.
import { signal } from '@preact/signals';
import { seekGoals, type SeekTarget } from '../logic/seek';
import { calm } from './live';
import { dialog } from './look';

export interface Sought { goal: SeekTarget; key: string }
export const sought = signal<Sought | null>(null);

/** Without a goal the largest utilisation; without a key the usual one. */
export function openSeek(wish: { goal?: SeekTarget; key?: string } = {}): void {
  const goal = wish.goal ?? (calm.value ? seekGoals(calm.value)[0] : undefined);
  if (!goal) return;
  sought.value = { goal, key: wish.key ?? '' };
  dialog.value = 'seek';
}
