// Permitted keys at a position of the model, from the JSON Schema of the program.

export interface Schema {
  type?: string | string[];
  properties?: Record<string, Schema>;
  additionalProperties?: Schema | boolean;
  items?: Schema;
  anyOf?: Schema[];
  enum?: (string | number)[];
  description?: string;
  default?: unknown;
  examples?: unknown[];
  'x-unit'?: string;
}

function step(schema: Schema, key: string): Schema[] {
  const out: Schema[] = [];
  for (const s of [schema, ...(schema.anyOf ?? [])]) {
    if (key === '[]') { if (s.items) out.push(s.items); continue; }
    const next = s.properties?.[key] ?? (typeof s.additionalProperties === 'object' ? s.additionalProperties : undefined);
    if (next) out.push(next);
  }
  return out;
}

export function schemasAt(root: Schema, path: string[]): Schema[] {
  let schemas = [root];
  for (const key of path) schemas = schemas.flatMap((s) => step(s, key));
  return schemas.flatMap((s) => [s, ...(s.anyOf ?? [])]);
}

export interface Offer { label: string; detail: string; info: string; group: boolean }

export function keyOffers(root: Schema, path: string[]): Offer[] {
  const seen = new Map<string, Offer>();
  for (const s of schemasAt(root, path)) {
    for (const [label, child] of Object.entries(s.properties ?? {})) {
      const group = [child, ...(child.anyOf ?? [])].some((c) => c.properties !== undefined || c.items !== undefined || typeof c.additionalProperties === 'object');
      const info = child.description ?? child.anyOf?.[0]?.description ?? '';
      if (!seen.has(label)) seen.set(label, { label, detail: child['x-unit'] ?? (group ? 'group' : ''), info, group });
    }
  }
  return [...seen.values()];
}

export function valueOffers(root: Schema, path: string[]): Offer[] {
  const out: Offer[] = [];
  for (const s of schemasAt(root, path)) {
    const info = s.description ?? '';
    for (const value of s.enum ?? []) out.push({ label: String(value), detail: '', info, group: false });
    if (s.default !== undefined && !s.enum) out.push({ label: String(s.default), detail: 'default', info, group: false });
    else for (const value of s.examples ?? []) out.push({ label: String(value), detail: 'example', info, group: false });
  }
  return out;
}
