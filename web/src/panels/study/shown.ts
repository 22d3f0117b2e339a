// What is drawn of the study that is shown.
import { computed } from '@preact/signals';
import { cellsOver, foremost, gridAxes, shapeOf, spreadAxes, type Cell } from '../../logic/studies';
import { kTension } from '../../logic/layGrid';
import { caseKeys, chosenCase, fixed, matrix, openInLay, output, triedValues } from '../../state/studies';

export const shape = computed(() => (matrix.value ? shapeOf(matrix.value) : null));

/** Keys along the drawing: one, or columns and rows. */
export const axes = computed<number[]>(() => {
  const m = matrix.value;
  if (!m) return [];
  return shape.value === 'grid' ? gridAxes(m) : shape.value === 'curve' ? spreadAxes(m) : [];
});

export const cells = computed<Cell[][]>(() => (matrix.value && axes.value.length ? cellsOver(matrix.value, axes.value, fixed.value, output.value) : []));

/** Other keys, which are held at one of their values. */
export const heldAxes = computed<number[]>(() => (matrix.value ? spreadAxes(matrix.value).filter((a) => axes.value.length > 0 && !axes.value.includes(a)) : []));

/** Columns are tensions: the table says what to ask of the vessel. */
export const isLayGrid = computed(() => shape.value === 'grid' && matrix.value!.inputs[axes.value[0]!]!.key === kTension && matrix.value!.analysis === 'static');

export function chooseCell(cell: Cell): void { chosenCase.value = foremost(cell)?.number ?? null; }

/** Tries the case out in Lay where its keys allow that. */
export function openCell(cell: Cell): void {
  const m = matrix.value, c = foremost(cell);
  const set = m && c ? triedValues(caseKeys(m, c)) : null;
  if (set) openInLay(set); else chooseCell(cell);
}
