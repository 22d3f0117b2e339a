// Navigation to an error: to its field in the properties of its object if it has one, otherwise to its line in the YAML.
import { effect, signal, untracked } from '@preact/signals';
import type { Diagnostic } from '../api/types';
import { tree } from '../logic/formTree';
import { objectOfKey } from '../logic/modelTree';
import { lineOfKey } from '../logic/yamlPlace';
import { byPath, diagnostics, errors, fields, opened, text } from './model';
import { drawer, object, showDockTab } from './workspace';

/** Target in properties or editor; a new object each time, so that a repeated request works. */
export const lead = signal<{ key: string; line: number } | null>(null);

/** The key itself, or its nearest parent in the form. */
export function knownKey(key: string): string {
  let path = key;
  while (path && !byPath.value.has(path)) path = path.replace(/(?:\.[^.[]*|\[\d+\])$|^[^.[]*$/, '');
  return path;
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

export const leadToDiagnostic = (d: Diagnostic): void => leadTo(d.key, d.line);

/** A file that is not valid YAML has no objects: it opens in the editor, at its error. */
export function startLead(): void {
  effect(() => {
    if (opened.value === 0) return;
    untracked(() => {
      const unreadable = errors.value.find((d) => !d.key && d.line > 0);
      if (unreadable && fields.value.every((f) => !f.given)) leadToDiagnostic(unreadable);
    });
  });
}
