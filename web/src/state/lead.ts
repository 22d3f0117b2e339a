// Leading to the place of a fault: to its field in the form where it has one, else to its line in the YAML.
import { signal } from '@preact/signals';
import type { Diagnostic } from '../api/types';
import { byPath, diagnostics } from './model';
import { leftTab, pane } from './look';

/** Where form or editor shall go; a new object each time, so that asking twice leads twice. */
export const lead = signal<{ key: string; line: number } | null>(null);

/** The key itself, or the nearest group above it that the form knows. */
export function knownKey(key: string): string {
  let at = key;
  while (at && !byPath.value.has(at)) at = at.replace(/(?:\.[^.[]*|\[\d+\])$|^[^.[]*$/, '');
  return at;
}

export function leadTo(key: string, line = 0): void {
  const known = knownKey(key);
  pane.value = 'model';
  leftTab.value = known ? 'form' : 'yaml';
  lead.value = { key: known, line: line || (diagnostics.value.find((d) => d.key === key)?.line ?? 0) };
}

export const leadToFault = (d: Diagnostic): void => leadTo(d.key, d.line);
