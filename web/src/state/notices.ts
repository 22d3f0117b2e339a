// Short messages at the edge of the page.
import { signal } from '@preact/signals';
import { ApiError } from '../api/client';

export interface Notice { id: number; kind: 'good' | 'bad'; text: string; hint: string }

export const notices = signal<Notice[]>([]);
let last = 0;

function add(kind: Notice['kind'], text: string, hint: string, seconds: number): void {
  const id = ++last;
  notices.value = [...notices.value.filter((n) => n.text !== text), { id, kind, text, hint }].slice(-4);
  setTimeout(() => dismiss(id), seconds * 1000);
}

export const dismiss = (id: number): void => { notices.value = notices.value.filter((n) => n.id !== id); };
export const say = (text: string): void => add('good', text, '', 4);

export function sayError(error: unknown): void {
  if (error instanceof ApiError) add('bad', error.message, error.hint, 12);
  else add('bad', error instanceof Error ? error.message : String(error), '', 12);
}
