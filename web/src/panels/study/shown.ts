// Axes and selection of the study shown.
import { computed } from '@preact/signals';
import { cellsOver, foremost, gridAxes, findShape, spreadAxes, type Cell } from '../../logic/studies';
import { kTension } from '../../logic/layGrid';
import { caseKeys, chosenCase, fixed, matrix, openInLay, output, triedValues } from '../../state/studies';

export const shape = computed(() => (matrix.value ? findShape(matrix.value) : null));

/** Keys along the drawing: one, or columns and rows. */
export const axes = computed<number[]>(() => {
  const m = matrix.value;
  if (!m) return [];
  return shape.value === 'grid' ? gridAxes(m) : shape.value === 'curve' ? spreadAxes(m) : [];
});

export const cells = computed<Cell[][]>(() => (matrix.value && axes.value.length ? cellsOver(matrix.value, axes.value, fixed.value, output.value) : []));

/** The other keys, held at one of their values. */
export const heldAxes = computed<number[]>(() => (matrix.value ? spreadAxes(matrix.value).filter((a) => axes.value.length > 0 && !axes.value.includes(a)) : []));

/** True if the columns are tensions: the table then gives permissible tensions. */
export const isLayGrid = computed(() => shape.value === 'grid' && matrix.value!.inputs[axes.value[0]!]!.key === kTension && matrix.value!.analysis === 'static');

export function chooseCell(cell: Cell): void { chosenCase.value = foremost(cell)?.number ?? null; }

/** Tries the case out in Lay if its keys can be tried out. */
export function openCell(cell: Cell): void {
  const m = matrix.value, c = foremost(cell);
  const set = m && c ? triedValues(caseKeys(m, c)) : null;
  if (set) openInLay(set); else chooseCell(cell);
}
