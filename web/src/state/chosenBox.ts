// The selected box: the selected object of the model by its result name. Every view marks it.
import { batch, computed, effect, signal, untracked } from '@preact/signals';
import { boxName, boxPath } from '../logic/boxes';
import { base } from './live';
import { cursor, picked } from './look';
import { chosenLine } from './moorings';
import { calmLay } from './shown';
import { object, selectObject } from './workspace';

const supports = computed(() => calmLay.value?.supports ?? []);
/** A box of a generated row has no path: its name is stored here. */
const ofRow = signal<string | null>(null);

export const chosenBox = computed<string | null>(() => boxName(base.value.boxes, supports.value, object.value)
  ?? (ofRow.value !== null && supports.value.some((s) => s.name === ofRow.value) && /^supports\.(ramp|stinger)$/.test(object.value) ? ofRow.value : null));

export const pathOfBox = (name: string): string => boxPath(base.value.boxes, supports.value, name);

export function chooseBox(name: string): void {
  batch(() => {
    ofRow.value = name;
    cursor.value = null;
    if (picked.value?.kind !== 'roller' || picked.value.roller.support.name !== name) picked.value = null;
    chosenLine.value = null;
    selectObject(pathOfBox(name));
  });
}

/** Selecting another object clears the box. */
export function startChosenBox(): void {
  effect(() => {
    const name = chosenBox.value;
    untracked(() => { const p = picked.value; if (p?.kind === 'roller' && p.roller.support.name !== name) picked.value = null; });
  });
}
