// Pinned keys: sliders under the picture, stored in the browser for each model.
import { computed, signal } from '@preact/signals';
import { findVariable, usualVariables, variableEnds, type Variable } from '../logic/variables';
import { base } from './live';
import { fileName, title } from './model';

/** `ends`: range of the slider, SI; the default about the value of the model if omitted. */
export interface Pin { id: string; ends?: [number, number] }

const store = 'overbend.pins';
const keptModels = 60;

type Kept = Record<string, Pin[]>;
function readKept(): Kept {
  try { return JSON.parse(localStorage.getItem(store) ?? '{}') as Kept; } catch { return {}; }
}
const kept = signal<Kept>(readKept());

const model = computed(() => fileName.value || title.value);
const usual = computed<Pin[]>(() => usualVariables(base.value).map((id) => ({ id })));
const pins = computed<Pin[]>(() => kept.value[model.value] ?? usual.value);

function keep(list: Pin[]): void {
  const others = Object.entries(kept.value).filter(([name]) => name !== model.value).slice(1 - keptModels);
  kept.value = Object.fromEntries([...others, [model.value, list]]);
  try { localStorage.setItem(store, JSON.stringify(kept.value)); } catch { /* private window */ }
}

export interface Slider { variable: Variable; low: number; high: number }

/** Pins available for the open model. */
export const sliders = computed<Slider[]>(() => pins.value.flatMap(({ id, ends }) => {
  const variable = findVariable(id, base.value);
  if (!variable) return [];
  const [low, high] = ends ?? variableEnds(variable);
  return [{ variable, low, high }];
}));

export const isPinned = (id: string): boolean => pins.value.some((pin) => pin.id === id);
export function addPin(id: string): void { if (!isPinned(id)) keep([...pins.value, { id }]); }
export function removePin(id: string): void { keep(pins.value.filter((pin) => pin.id !== id)); }
export function setPinEnds(id: string, ends: [number, number] | undefined): void {
  keep(pins.value.map((pin) => (pin.id === id ? { id, ...(ends ? { ends } : {}) } : pin)));
}
