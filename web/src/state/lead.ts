// Leading to the place of a fault: to its field among the properties of its object where it has one, else to its line in the YAML.
import { effect, signal, untracked } from '@preact/signals';
import type { Diagnostic } from '../api/types';
import { tree } from '../logic/formTree';
import { objectOfKey } from '../logic/modelTree';
import { lineOfKey } from '../logic/yamlPlace';
import { byPath, diagnostics, errors, fields, opened, text } from './model';
import { drawer, object, showDockTab } from './workspace';

/** Where properties or editor shall go; a new object each time, so that asking twice leads twice. */
export const lead = signal<{ key: string; line: number } | null>(null);

/** The key itself, or the nearest group above it that the form knows. */
export function knownKey(key: string): string {
  let at = key;
  while (at && !byPath.value.has(at)) at = at.replace(/(?:\.[^.[]*|\[\d+\])$|^[^.[]*$/, '');
  return at;
}

export function leadTo(key: string, line = 0): void {
  const known = knownKey(key);
  if (known) {
    drawer.value = 'model';
    object.value = objectOfKey(tree(fields.value), known);
  } else {
    drawer.value = null;
    showDockTab('lay', 'yaml');
  }
  lead.value = { key: known, line: line || (diagnostics.value.find((d) => d.key === key)?.line ?? 0) };
}

/** To the line of a key in the YAML. */
export function leadToText(key: string): void {
  showDockTab('lay', 'yaml');
  lead.value = { key: '', line: lineOfKey(text.value, key) };
}

export const leadToFault = (d: Diagnostic): void => leadTo(d.key, d.line);

/** A file that cannot be read as YAML has no objects to show: it opens in the editor, at its fault. */
export function startLead(): void {
  effect(() => {
    if (opened.value === 0) return;
    untracked(() => {
      const unreadable = errors.value.find((d) => !d.key && d.line > 0);
      if (unreadable && fields.value.every((f) => !f.given)) leadToFault(unreadable);
    });
  });
}
