// All roller boxes, of ramp and stinger, in one table: where they stand, and what the pipe does on them.
import { arcFaults, rampEnd, wishedBoxes, wishFrom } from '../../logic/gridGenerate';
import { boxLists, isRow, structureAround } from '../../logic/gridTables';
import type { ViewList } from '../../logic/gridView';
import { cursor } from '../../state/look';
import { byPath } from '../../state/model';
import { calmLay } from '../../state/shown';
import { ModelTable } from './ListGrid';

/** Boxes given as a row on an arc, where the program places them. */
function placedBoxes(structure: string): Record<string, string>[] {
  const wish = wishFrom(byPath.value, structure), end = structure === 'supports.stinger' ? rampEnd(byPath.value) : null;
  if (arcFaults(wish, end).length > 0) return [];
  return wishedBoxes(wish, end).map((box) => ({ x: `${box.x.toFixed(3)} m`, z: `${box.z.toFixed(3)} m`, ...(wish.length ? { length: wish.length } : {}) }));
}

export function BoxesGrid() {
  const lists = boxLists(byPath.value).map((list): ViewList => (isRow(byPath.value, list.path) ? { ...list, placed: placedBoxes(structureAround(list.path)) } : list));
  if (lists.length === 0) return <p class="empty">The model has no supports.</p>;
  return (
    <ModelTable
      id="grid-boxes"
      label="Boxes"
      lists={lists}
      choose={(row) => { const box = calmLay.value?.supports.find((s) => s.name === row.name); if (box) cursor.value = box.s; }}
    />
  );
}
