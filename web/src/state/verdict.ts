// The verdict on the results shown, and its checks.
import { computed, signal } from '@preact/signals';
import type { Check, Verdict } from '../api/types';
import { calmLay, shownRun } from './shown';
import { runChecks, runSummary } from './runs';

export const shownVerdict = computed<Verdict | null>(() => {
  if (!shownRun.value) return calmLay.value?.verdict ?? null;
  return runSummary.value?.dynamic?.verdict ?? runSummary.value?.verdict ?? null;
});
export const shownChecks = computed<Check[]>(() => (shownRun.value ? runChecks.value : calmLay.value?.checks) ?? []);
/** The check whose calculation is unfolded. */
export const openedCheck = signal('');
