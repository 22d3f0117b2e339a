// Adds a missing object, with default values if the program can solve the model then, otherwise empty.
import { firstItem } from '../logic/firstItems';
import type { FieldNode } from '../logic/modelTree';
import { byPath, setKeys } from '../state/model';
import { dialog } from '../state/look';
import { sayError } from '../state/notices';
import { goTo, selectObject } from '../state/workspace';

export async function addObject(node: FieldNode): Promise<void> {
  selectObject(node.path);
  if (node.path === 'moorings') { dialog.value = 'spread'; return; }
  if (node.path === 'operation') { goTo('operation'); return; }
  if (node.path === 'lay_table') { goTo('study'); return; }
  const list = node.field?.kind === 'list';
  const first = list ? firstItem(node.path, byPath.value.get('environment.water_depth')?.si ?? 0, String(byPath.value.get('operation.type')?.value ?? '')) : null;
  if (first === null || first === undefined) return; // shows its properties, each with a description
  try { await setKeys([{ path: `${node.path}[0]`, value: first }]); } catch (error) { sayError(error); }
}
