// Which stage of an operation is shown, and which line is looked at.
import { computed, effect, signal, untracked } from '@preact/signals';
import type { MooredState, MooringLine } from '../api/types';
import { largestOfRun, stateOf } from '../logic/moorings';
import { picked } from './look';
import { opened } from './model';
import { runSummary, selectedId } from './runs';
import { calmLay, shownLay } from './shown';

/** Number of the stage from 0; -1 the rest. */
export const stage = signal(-1);
/** Name of the line that is looked at. */
export const chosenLine = signal<string | null>(null);

/** A second choice of the same line ends it. */
export function chooseLine(name: string): void {
  const off = chosenLine.value === name;
  chosenLine.value = off ? null : name;
  picked.value = off ? null : { kind: 'line', name };
}

export const mooredState = computed<MooredState | null>(() => { const m = shownLay.value?.moorings; return m ? stateOf(m, stage.value) : null; });
/** The same, at the pace of panels. */
export const calmState = computed<MooredState | null>(() => { const m = calmLay.value?.moorings; return m ? stateOf(m, stage.value) : null; });

/** The lines with the largest tensions of the run that is looked at; null without a run in time. */
export const linesOfRun = computed<MooringLine[] | null>(() => {
  const lines = calmState.value?.moorings, run = runSummary.value?.dynamic?.moorings;
  return selectedId.value && lines && run?.length && stage.value < 0 ? largestOfRun(lines, run) : null;
});

/** The lines by themselves in the run that is looked at; null without a run in time. */
export const aloneInTime = computed(() => (selectedId.value ? runSummary.value?.dynamic?.lines ?? null : null));

/** Another model, another run: its rest is shown. */
export function startMoorings(): void {
  effect(() => { void opened.value; void selectedId.value; untracked(() => { stage.value = -1; chosenLine.value = null; }); });
}
