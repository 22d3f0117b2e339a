// What the parts of a grid have in common.
import type { Rectangle } from '../../logic/gridSelection';
import type { ViewColumn, ViewRow } from '../../logic/gridView';

export interface GridCell { row: ViewRow; column: ViewColumn; text: string }
/** Where a paste goes: the selected cells, in the order that is seen. */
export interface PastePlace { rows: ViewRow[]; column: number; rectangle: Rectangle; all: boolean }

/** Head of a column as it is copied. */
export const headText = (c: ViewColumn): string => `${c.group ? `${c.group}: ` : ''}${c.title}${c.unit ? ` [${c.unit}]` : ''}`;

/** The cell, or the head of a row, under the pointer. */
export function spotUnder(target: EventTarget | null): { row: number; column: number | null } | null {
  const cell = (target as Element | null)?.closest?.<HTMLElement>('[data-row]');
  if (!cell) return null;
  return { row: Number(cell.dataset.row), column: cell.dataset.column === undefined ? null : Number(cell.dataset.column) };
}

/** Whether a key begins a new text in the active cell. */
export const isTyped = (e: KeyboardEvent): boolean => e.key.length === 1 && !e.ctrlKey && !e.metaKey && !e.altKey;

/** Pasting outside of any field concerns the table that is seen. */
export function isElsewhere(table: HTMLElement): boolean {
  const own = document.activeElement;
  return !document.querySelector('dialog[open]') && table.offsetParent !== null && (!own || (!own.closest('input, textarea, select, [contenteditable], .cm-editor') && !own.closest('[role=grid]')));
}
