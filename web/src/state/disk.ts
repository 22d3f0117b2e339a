// Whether another program has changed the model's file: looked at when the page is looked at.
import { effect, signal } from '@preact/signals';
import { get } from '../api/client';
import { disk, fileName } from './model';

/** The version that another program wrote, until the user has said what shall become of it. */
export const changedOutside = signal<string | null>(null);
/** The version that the user chose not to take. */
let kept: string | null = null;
const every = 15_000;

async function look(): Promise<void> {
  if (document.visibilityState === 'hidden' || !fileName.value || disk.value === undefined) return;
  try {
    const { name, version } = await get<{ name: string; version: string | null }>('model/disk');
    if (name !== fileName.value || version === null) return;
    changedOutside.value = version !== disk.value && version !== kept ? version : null;
  } catch { /* without connection: the header says so */ }
}

export function keepOwn(): void {
  kept = changedOutside.value;
  changedOutside.value = null;
}

export function startDisk(): void {
  addEventListener('focus', () => void look());
  document.addEventListener('visibilitychange', () => void look());
  setInterval(() => void look(), every);
  // read or written by this program: known again
  effect(() => { void disk.value; changedOutside.value = null; });
}
