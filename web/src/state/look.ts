// Display settings stored in the browser: theme, colouring, selected diagrams; and the common cursor.
import { effect, signal, type Signal } from '@preact/signals';
import { quantity } from '../logic/show';
import type { Picked } from '../view/picking';

/** A signal that is stored in the browser. */
export function kept<T>(name: string, start: T): Signal<T> {
  let value = start;
  try { const text = localStorage.getItem(`overbend.${name}`); if (text !== null) value = JSON.parse(text) as T; } catch { /* private window */ }
  const s = signal(value);
  effect(() => { try { localStorage.setItem(`overbend.${name}`, JSON.stringify(s.value)); } catch { /* private window */ } });
  return s;
}

export type Theme = 'light' | 'dark';
export const theme = kept<Theme>('theme', matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
export type ColourBy = 'von_mises' | 'bending_stress' | 'effective_tension' | 'strain' | 'utilisation' | 'checks';
export const colourBy = kept<ColourBy>('colour', 'von_mises');
if (!quantity(colourBy.value)) colourBy.value = 'von_mises';  // stored under an earlier name
/** Widths of the side columns and height of the dock in px; 0 for the default. */
export const leftWidth = kept<number>('left', 0);
export const rightWidth = kept<number>('right', 0);
export const dockHeight = kept<number>('dock', 0);
export const slots = kept<string[]>('diagrams', ['elevation', 'bending_stress', 'effective_tension', 'von_mises']);

/** Arc length from the tensioner shared by pointer and diagrams; null if the pointer is elsewhere. */
export const cursor = signal<number | null>(null);
export const picked = signal<Picked>(null);
export type DialogName = 'start' | 'open' | 'saveas' | 'spread' | 'seek' | 'import' | null;
export const dialog = signal<DialogName>(null);
/** The dialog to open after the decision on unsaved changes. */
export const asking = signal<DialogName>(null);

export function startLook(): void {
  effect(() => { document.documentElement.dataset.theme = theme.value; });
}
