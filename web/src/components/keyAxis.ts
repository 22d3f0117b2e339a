// Axes of varied keys, and ranges of the results over them.
import { tidy } from '../logic/units';
import { extent } from './chart/scale';
import type { Axis } from './chart/types';
import { shortened } from './units';

/** `words`: values of the key as text; `values`: the same as numbers, if they are numeric. */
export interface KeyAxis { name: string; words: string[]; values: (number | null)[] }

/** The range of values, extended on both sides but not across zero. */
export function roomAround(values: readonly number[], part: number): [number, number] {
  const [low, high] = extent(values);
  if (low === 0 && high === 0) return [0, 1];
  const room = part * (high - low) || part * Math.abs(high) || 1;
  return [low >= 0 ? Math.max(0, low - room) : low - room, high <= 0 ? Math.min(0, high + room) : high + room];
}

/** The range of values; a single value is centred. */
export function wholeRange(values: readonly number[]): [number, number] {
  const [low, high] = extent(values);
  return low === high ? [low - 0.5, high + 0.5] : [low, high];
}

/** Numeric values of an axis, otherwise the positions in its list. */
export function axisPlaces(axis: KeyAxis): { places: number[]; labels: string[]; numeric: boolean } {
  const numeric = axis.values.length === axis.words.length && axis.values.every((value) => value !== null);
  if (!numeric) return { places: axis.words.map((_, i) => i), labels: axis.words, numeric };
  const places = axis.values as number[];
  return { places, labels: places.map((value) => tidy(value, 6)), numeric };
}

/** Axis of a chart, with names if the values are texts. */
export function keyAxis(axis: KeyAxis): Axis {
  const { places, labels, numeric } = axisPlaces(axis);
  if (numeric) return { range: wholeRange(places), label: axis.name };
  return { range: [-0.3, places.length - 0.7], label: axis.name, names: places.map((value, i) => ({ value, text: shortened(labels[i]!) })) };
}

/** The end of a long name, where paths differ. */
export const nameEnd = (name: string, length: number): string => (name.length > length ? `\u2026${name.slice(1 - length)}` : name);
