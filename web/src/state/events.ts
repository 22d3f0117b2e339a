// Events of the run shown, and navigation to them: the picture shows that time, and the location is marked.
import { computed, effect, signal, untracked } from '@preact/signals';
import type { Series } from '../api/types';
import {
  eventsOfRun, findExtreme, impactEvent, nextEvent, objectOfColumn, wantedExtremes, worstImpact, type EventKind, type RunEvent, type Wanted,
} from '../logic/events';
import { text } from '../logic/show';
import { active, playing, seek, time } from './animation';
import { chooseBox } from './chosenBox';
import { chosenLine } from './moorings';
import { columns, fetchSeries, impacts, runLay, runSummary, selected } from './runs';

const tensioner = signal<Series | undefined>(undefined);
const most = 20000; // points: longer histories are reduced by the program
const justAfter = 0.03; // s: an impact is lit from this time before it to this time after it

export const events = computed<RunEvent[]>(() => {
  const run = runSummary.value?.dynamic;
  if (!active.value) return [];
  return eventsOfRun({ impacts: impacts.value, state: tensioner.value, lines: run?.moorings ?? [], findings: run?.findings ?? [] });
});

/** Entries of the menu "Go to max / min". */
export const extremes = computed(() => wantedExtremes(columns.value));

/** The event that the picture was moved to; null once the clock has advanced. */
export const reached = signal<{ time: number; title: string; detail: string } | null>(null);
/** Box that the camera flies to; a new object each time. */
export const approach = signal<{ box: string } | null>(null);

function markObject(name: string | undefined, near: boolean): void {
  if (!name) return;
  if (runLay.peek()?.supports.some((s) => s.name === name)) {
    chooseBox(name);
    if (near) approach.value = { box: name };
  } else chosenLine.value = name;
}

function goToTime(t: number, title: string, detail: string, object: string | undefined, near: boolean): void {
  playing.value = false;
  seek(t);
  markObject(object, near);
  reached.value = { time: time.value, title, detail };
}

export function goToEvent(event: RunEvent, near = false): void {
  const { impact } = event;
  const detail = impact ? `${text(impact.peak_force, 'N', 4)} at ${text(impact.approach_velocity, 'm/s', 3)}, row ${impact.row + 1}, ${impact.position} roller` : '';
  goToTime(event.time + (impact ? justAfter : 0), event.name, detail, event.object, near);
}

export function goToNext(step: 1 | -1, kind?: EventKind): void {
  const event = nextEvent(events.value, time.value, step, kind);
  if (event) goToEvent(event);
}

export function goToWorstImpact(): void {
  const impact = worstImpact(impacts.value);
  if (impact) goToEvent({ ...impactEvent(impact), name: `worst impact: ${impact.support}` }, true);
}

export async function goToExtreme({ column, sign, name }: Wanted): Promise<void> {
  const id = selected.value?.id;
  if (!id) return;
  const whole = (await fetchSeries(id, [column.name], 0, null, most))[column.name];
  let found = whole && findExtreme(whole, sign);
  if (!found || selected.value?.id !== id) return;
  // reduced histories give the time only to the width of a range
  const width = whole!.t.length > 1 ? (whole!.t.at(-1)! - whole!.t[0]!) / (whole!.t.length - 1) : 0;
  const close = (await fetchSeries(id, [column.name], Math.max(0, found.time - width), found.time + 2 * width, most))[column.name];
  found = (close && findExtreme(close, sign)) ?? found;
  goToTime(found.time, `${sign > 0 ? 'largest' : 'smallest'}: ${name}`, text(found.value, column.unit, 4), objectOfColumn(column.name) ?? undefined, false);
}

export function startEvents(): void {
  effect(() => {
    const id = active.value ? selected.value?.id : undefined, known = columns.value.some((c) => c.name === 'tensioner/state');
    untracked(() => {
      tensioner.value = undefined;
      reached.value = null;
      if (!id || !known) return;
      void fetchSeries(id, ['tensioner/state'], 0, null, most).then((got) => { if (selected.peek()?.id === id) tensioner.value = got['tensioner/state']; }).catch(() => undefined);
    });
  });
  effect(() => { const event = reached.peek(); if (event && Math.abs(time.value - event.time) > 1) reached.value = null; });
}
