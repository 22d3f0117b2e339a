// Playback state, lit impacts, and cards over the picture.
import { computed, signal } from '@preact/signals';
import type { Rect } from '../../logic/labelPlaces';
import { shown as frame } from '../../state/animation';
import { impacts } from '../../state/runs';

/** Cards and buttons over the picture [px]: names avoid them. */
export const cards = signal<Rect[]>([]);

export const flashing = signal(0);
export const animating = computed(() => frame.value !== null);

const flashTime = 0.7; // s

/** Impacts around a time with their brightness. */
export function flashesAt(time: number) {
  const largest = impacts.value[0]?.peak_force || 1;
  return impacts.value.filter((i) => i.time <= time && time < i.time + flashTime)
    .map((i) => ({ ...i, strength: Math.min(1, i.peak_force / largest) * (1 - (time - i.time) / flashTime) }));
}
