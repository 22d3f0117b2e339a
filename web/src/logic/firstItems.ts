// The first item of a list that the form can create; later items are copies of the last.
import type { Field } from '../api/types';
import type { Node } from './formTree';

/** Null if it has to be written in the YAML. `depth`: water depth in m; `operation`: its type. */
export function firstItem(path: string, depth: number, operation = ''): unknown {
  switch (path) {
    case 'operation.stages': return ['start_up', 'shore_pull', 'hold_back'].includes(operation) ? { pipe_out: '100 m' } : operation === 'move' ? { ahead: '0 m' } : operation === '' || operation === 'moored' || operation === 'lift' ? { name: 'stage 1' } : { cable_out: '50 m' };
    case 'vessel.loads': return { name: 'load 1', at: { x: '0 m', y: '0 m', z: '0 m' }, force: { x: '0 kN', y: '0 kN', z: '0 kN' } };
    case 'moorings.objects': return { name: 'object 1', points: [{ x: '0 m', y: '100 m', z: `${-depth} m` }] };
    default: return null;
  }
}

/** "stage 1" is followed by "stage 2", "port bow" by "port bow 2". */
export function nextName(name: string): string {
  const counted = /^(.*\D)(\d+)$/.exec(name);
  return counted ? `${counted[1]}${Number(counted[2]) + 1}` : `${name} 2`;
}

/** A new item copies the last one, so that it is valid at once and only has to be changed. */
export function copyItem(node: Node<Field>): unknown {
  if (node.children.length === 0) return node.field!.value;
  const out: Record<string, unknown> = {};
  for (const c of node.children) {
    if (!c.given) continue;
    const key = c.path.split('.').at(-1)!;
    // names identify items: a required name is numbered
    if (key === 'name') { if (c.field?.required) out[key] = nextName(String(c.field.value)); continue; }
    out[key] = copyItem(c);
  }
  return out;
}
