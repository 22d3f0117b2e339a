// Items of a list of the model with all nested values, from the fields of the program.
import type { Field } from '../api/types';
import { parts } from './formTree';

type Group = Record<string, unknown>;

function valueOf(field: Field): unknown {
  if (field.kind === 'list') return [];
  if (field.kind === 'map') return {};
  const number = Number(field.value);
  return (field.kind === 'number' || field.kind === 'integer') && Number.isFinite(number) ? number : field.value;
}

function place(root: unknown, path: string[], value: unknown): void {
  let group = root;
  path.forEach((part, i) => {
    const key = part.startsWith('[') ? Number(part.slice(1, -1)) : part;
    const holder = group as Group;
    if (i === path.length - 1) holder[key] = value;
    group = holder[key] ?? {};
  });
}

/** Items of the list at a path; null if the fields are incomplete. */
export function listItems(fields: Field[], path: string): unknown[] | null {
  const items: unknown[] = [];
  const counts = new Map<string, number>();
  const start = `${path}[`;
  for (const field of fields) {
    if (!field.given || (field.path !== path && !field.path.startsWith(start))) continue;
    if (field.kind === 'list') counts.set(field.path, field.count ?? 0);
    if (field.path === path) continue;
    place(items, parts(field.path.slice(path.length)), valueOf(field));
  }
  const complete = [...counts].every(([list, count]) => {
    const found = parts(list.slice(path.length)).reduce<unknown>((group, part) => (group as Group | undefined)?.[part.startsWith('[') ? part.slice(1, -1) : part], items);
    return Array.isArray(found) && found.length === count;
  });
  return complete ? items : null;
}

/** An item with one value set; null removes the value. */
export function withValue(item: unknown, key: string, value: unknown): unknown {
  if (key === '') return value;
  const [first, ...rest] = key.split('.');
  const copy: Group = { ...(item as Group | undefined) };
  const next = rest.length > 0 ? withValue(copy[first!], rest.join('.'), value) : value;
  if (next === null) delete copy[first!];
  else copy[first!] = next;
  return copy;
}

export function valueIn(item: unknown, key: string): unknown {
  return key === '' ? item : key.split('.').reduce<unknown>((group, part) => (group as Group | undefined)?.[part], item);
}
