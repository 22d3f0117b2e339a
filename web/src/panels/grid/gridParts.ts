// Common functions of the parts of a grid.
import type { Rectangle } from '../../logic/gridSelection';
import type { ViewColumn, ViewRow } from '../../logic/gridView';

export interface GridCell { row: ViewRow; column: ViewColumn; text: string }
/** Destination of a paste: the selected cells, in the order shown. */
export interface PastePlace { rows: ViewRow[]; column: number; rectangle: Rectangle; all: boolean }

/** Column head for copying. */
export const headText = (c: ViewColumn): string => `${c.group ? `${c.group}: ` : ''}${c.title}${c.unit ? ` [${c.unit}]` : ''}`;

/** The cell or row head under the pointer. */
export function spotUnder(target: EventTarget | null): { row: number; column: number | null } | null {
  const cell = (target as Element | null)?.closest?.<HTMLElement>('[data-row]');
  if (!cell) return null;
  return { row: Number(cell.dataset.row), column: cell.dataset.column === undefined ? null : Number(cell.dataset.column) };
}

/** True if a key starts a new text in the active cell. */
export const isTyped = (e: KeyboardEvent): boolean => e.key.length === 1 && !e.ctrlKey && !e.metaKey && !e.altKey;

/** Pasting outside any field applies to the visible table. */
export function isElsewhere(table: HTMLElement): boolean {
  const focused = document.activeElement;
  return !document.querySelector('dialog[open]') && table.offsetParent !== null && (!focused || (!focused.closest('input, textarea, select, [contenteditable], .cm-editor') && !focused.closest('[role=grid]')));
}
