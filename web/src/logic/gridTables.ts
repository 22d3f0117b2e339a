// Lists of the model that have a table, and the lists in the table of all roller boxes.
import type { Field } from '../api/types';
import { itemSchema } from './gridColumns';
import type { ViewList } from './gridView';
import type { Schema } from './schema';

/** True if a path of the model is a list, given or not. */
export function isList(path: string, byPath: Map<string, Field>, schema: Schema | null): boolean {
  const field = byPath.get(path);
  if (field && field.kind !== 'map') return field.kind === 'list';
  return schema !== null && itemSchema(schema, path) !== null;
}

/** Path of the list that contains an item or value; empty outside lists. */
export const listAround = (path: string): string => /^(.*)\[\d+\][^[]*$/.exec(path)?.[1] ?? '';

const usual = ['offset', 'length', 'rows'];

const counted = (structure: string, from: number) => (index: number): string => `${structure} ${from + index + 1}`;

/** Lists of roller boxes from the tensioner astern. */
export function boxLists(byPath: Map<string, Field>): ViewList[] {
  const lists: ViewList[] = [];
  if (byPath.get('supports.ramp')?.given) lists.push({ path: 'supports.ramp.boxes', title: 'ramp', standardName: counted('ramp', 0), usual, above: 'supports.ramp' });
  const sections = byPath.get('supports.stinger.sections');
  if (!sections?.given) return byPath.get('supports.stinger')?.given ? [...lists, { path: 'supports.stinger.boxes', title: 'stinger', standardName: counted('stinger', 0), usual, above: 'supports.stinger' }] : lists;
  let before = 0;
  for (let i = 0; i < (sections.count ?? 0); ++i) {
    const path = `supports.stinger.sections[${i}]`;
    const name = byPath.get(`${path}.name`)?.value;
    lists.push({ path: `${path}.boxes`, title: String(name ?? `section ${i + 1}`), standardName: counted('stinger', before), usual, above: 'supports.stinger' });
    before += byPath.get(`${path}.boxes`)?.count ?? 0;
  }
  return lists;
}

/** The structure of a box path: "supports.stinger". */
export const structureAround = (path: string): string => /^supports\.(?:ramp|stinger)/.exec(path)?.[0] ?? '';

/** Boxes of a structure given as a row on an arc, instead of a list. */
export const isRow = (byPath: Map<string, Field>, list: string): boolean => byPath.get(list)?.kind === 'map' && byPath.get(list)!.given;
