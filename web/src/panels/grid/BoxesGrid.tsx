// All roller boxes of ramp and stinger in one table: positions and results.
import { findArcErrors, rampEnd, generatedBoxes, readArcRequest } from '../../logic/gridGenerate';
import { boxLists, isRow, structureAround } from '../../logic/gridTables';
import type { ViewList } from '../../logic/gridView';
import { cursor } from '../../state/look';
import { byPath } from '../../state/model';
import { calmLay } from '../../state/shown';
import { ModelTable } from './ListGrid';

/** Boxes given as a row on an arc, which the program places. */
function placedBoxes(structure: string): Record<string, string>[] {
  const request = readArcRequest(byPath.value, structure), end = structure === 'supports.stinger' ? rampEnd(byPath.value) : null;
  if (findArcErrors(request, end).length > 0) return [];
  return generatedBoxes(request, end).map((box) => ({ x: `${box.x.toFixed(3)} m`, z: `${box.z.toFixed(3)} m`, ...(request.length ? { length: request.length } : {}) }));
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
