// Detects changes of the model file by other programs, whenever the page becomes visible.
import { effect, signal } from '@preact/signals';
import { get } from '../api/client';
import { disk, fileName } from './model';

/** Version written by another program, until the user has decided. */
export const changedOutside = signal<string | null>(null);
/** Version that the user rejected. */
let kept: string | null = null;
const every = 15_000;

async function look(): Promise<void> {
  if (document.visibilityState === 'hidden' || !fileName.value || disk.value === undefined) return;
  try {
    const { name, version } = await get<{ name: string; version: string | null }>('model/disk');
    if (name !== fileName.value || version === null) return;
    changedOutside.value = version !== disk.value && version !== kept ? version : null;
  } catch { /* no connection: shown in the header */ }
}

export function keepOwn(): void {
  kept = changedOutside.value;
  changedOutside.value = null;
}

export function startDisk(): void {
  addEventListener('focus', () => void look());
  document.addEventListener('visibilitychange', () => void look());
  setInterval(() => void look(), every);
  // read or written by this program
  effect(() => { void disk.value; changedOutside.value = null; });
}
