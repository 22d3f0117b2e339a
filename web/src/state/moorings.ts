// Which stage of an operation is shown, which line is looked at, and whether the plan stands in the place of the 3-D view.
import { computed, effect, signal, untracked } from '@preact/signals';
import type { MooredState } from '../api/types';
import { stateOf } from '../logic/moorings';
import { opened } from './model';
import { selectedId } from './runs';
import { calmLay, shownLay } from './shown';

/** Number of the stage from 0; -1 the rest. */
export const stage = signal(-1);
/** Name of the line that is looked at. */
export const chosenLine = signal<string | null>(null);
export const planShown = signal(false);

export const mooredState = computed<MooredState | null>(() => { const m = shownLay.value?.moorings; return m ? stateOf(m, stage.value) : null; });
/** The same, at the pace of panels. */
export const calmState = computed<MooredState | null>(() => { const m = calmLay.value?.moorings; return m ? stateOf(m, stage.value) : null; });

/** Another model, another run: its rest is shown. */
export function startMoorings(): void {
  effect(() => { void opened.value; void selectedId.value; untracked(() => { stage.value = -1; chosenLine.value = null; }); });
  effect(() => { if (shownLay.value && !shownLay.value.moorings) planShown.value = false; });
}
