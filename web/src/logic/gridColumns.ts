// Columns of a list of the model, from the schema: its members with their units; small groups, such as
// x, y and z of a position, get a column for each member.
import { schemasAt, type Schema } from './schema';
import { label, parts } from './formTree';

export type ColumnKind = 'quantity' | 'number' | 'integer' | 'text' | 'choice' | 'nested';

export interface GridColumn {
  /** Path within an item: "x", "anchor.x"; empty if the items are plain values. */
  key: string;
  title: string;
  kind: ColumnKind;
  /** Unit in which the program writes it; empty if it has none. */
  unit: string;
  info: string;
  choices: string[];
  required: boolean;
  /** Text for an omitted value; empty if there is none. */
  standard: string;
  /** A sample value. */
  example: string;
}

const mostInGroup = 3;

/** Parts of a path for the schema: items of lists are "[]". */
export function schemaPath(path: string): string[] {
  return parts(path).map((part) => (part.startsWith('[') ? '[]' : part));
}

/** Schema of an item of the list; null if the path is not a list. */
export function itemSchema(root: Schema, path: string): Schema | null {
  return schemasAt(root, schemaPath(path)).find((s) => s.items !== undefined)?.items ?? null;
}

function columnKind(schema: Schema): ColumnKind {
  if (schema.anyOf?.length || schema.properties || schema.items || typeof schema.additionalProperties === 'object') return 'nested';
  if (schema.enum) return 'choice';
  if (schema['x-unit']) return 'quantity';
  const types = [schema.type ?? 'string'].flat();
  if (types.includes('integer')) return 'integer';
  return types.includes('number') && !types.includes('boolean') ? 'number' : 'text';
}

function column(schema: Schema, key: string, title: string, required: boolean): GridColumn {
  return {
    key, title, required, kind: columnKind(schema), unit: schema['x-unit'] ?? '', info: schema.description ?? '',
    choices: (schema.enum ?? []).map(String), standard: schema.default === undefined ? '' : String(schema.default), example: String(schema.examples?.[0] ?? ''),
  };
}

function isGroup(schema: Schema): boolean {
  const members = Object.values(schema.properties ?? {});
  return !schema.anyOf?.length && members.length > 0 && members.length <= mostInGroup && members.every((m) => columnKind(m) !== 'nested');
}

function members(schema: Schema, key: string, title: string, required: boolean): GridColumn[] {
  if (!isGroup(schema)) return [column(schema, key, title, required)];
  const needed = requiredKeys(schema);
  return Object.entries(schema.properties!).map(([name, member]) => column(member, `${key}.${name}`, `${title} ${label(name)}`, required && needed.includes(name)));
}

const requiredKeys = (schema: Schema): string[] => (schema as { required?: string[] }).required ?? [];

/** Columns of the list at a path; empty if there is no such list. */
export function listColumns(root: Schema, path: string): GridColumn[] {
  const item = itemSchema(root, path);
  if (!item) return [];
  if (!item.properties) return [column(item, '', 'value', true)];
  const required = requiredKeys(item);
  return Object.entries(item.properties).flatMap(([key, schema]) => members(schema, key, label(key), required.includes(key)));
}

const mostShown = 8;

/** Initial columns: all if there are few, otherwise those that are required, given in some row, or requested. */
export function shownColumns(columns: GridColumn[], isGiven: (key: string) => boolean, asked: string[], hasResults: boolean): GridColumn[] {
  const kept = (c: GridColumn): boolean => c.required || c.key === 'name' || asked.includes(c.key) || isGiven(c.key);
  return columns.filter((c) => (!hasResults && columns.length <= mostShown && c.kind !== 'nested') || kept(c));
}
