// Selected stage of an operation, and selected line.
import { computed, effect, signal, untracked } from '@preact/signals';
import type { MooredState, MooringLine } from '../api/types';
import { largestOfRun, mooredStateAt } from '../logic/moorings';
import { picked } from './look';
import { opened } from './model';
import { runSummary, selectedId } from './runs';
import { calmLay, shownLay } from './shown';

/** Index of the stage from 0; -1: the equilibrium. */
export const stage = signal(-1);
/** Name of the selected line. */
export const chosenLine = signal<string | null>(null);

/** Selecting the same line again clears the selection. */
export function chooseLine(name: string): void {
  const off = chosenLine.value === name;
  chosenLine.value = off ? null : name;
  picked.value = off ? null : { kind: 'line', name };
}

export const mooredState = computed<MooredState | null>(() => { const m = shownLay.value?.moorings; return m ? mooredStateAt(m, stage.value) : null; });
/** The same, at the update rate of panels. */
export const calmState = computed<MooredState | null>(() => { const m = calmLay.value?.moorings; return m ? mooredStateAt(m, stage.value) : null; });

/** Lines with the maximum tensions of the selected run; null without a dynamic run. */
export const linesOfRun = computed<MooringLine[] | null>(() => {
  const lines = calmState.value?.moorings, run = runSummary.value?.dynamic?.moorings;
  return selectedId.value && lines && run?.length && stage.value < 0 ? largestOfRun(lines, run) : null;
});

/** Lines other than moorings in the selected run; null without a dynamic run. */
export const aloneInTime = computed(() => (selectedId.value ? runSummary.value?.dynamic?.lines ?? null : null));

/** For another model or run its equilibrium is shown. */
export function startMoorings(): void {
  effect(() => { void opened.value; void selectedId.value; untracked(() => { stage.value = -1; chosenLine.value = null; }); });
}
