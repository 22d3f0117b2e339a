// Events of a run: impacts, changes of the tensioner state, line events, in order of time.
import type { Column, Finding, Impact, MooringInTime, Series } from '../api/types';
import { columnName, tensionerState } from './tensioner';

export type EventKind = 'impact' | 'tensioner' | 'line' | 'finding';

export interface RunEvent {
  time: number;
  kind: EventKind;
  /** "impact on stinger 8", "tensioner pays out". */
  name: string;
  /** A second line for the picture: values of the event. */
  impact?: Impact;
  /** Box or line of the event. */
  object?: string;
}

export const impactEvent = (impact: Impact): RunEvent => ({ time: impact.time, kind: 'impact', name: `impact on ${impact.support}`, object: impact.support, impact });

/** Changes of the tensioner state; the history may be reduced to ranges. */
export function tensionerEvents(series: Series | undefined): RunEvent[] {
  if (!series) return [];
  const out: RunEvent[] = [];
  series.t.forEach((time, i) => {
    const before = i > 0 ? Math.round(series.max[i - 1]!) : null, current = Math.round(series.max[i]!);
    const state = tensionerState(current);
    if (before !== null && current !== before && state && time >= 0) out.push({ time, kind: 'tensioner', name: `tensioner ${state.label}` });
  });
  return out;
}

export function lineEvents(lines: readonly MooringInTime[]): RunEvent[] {
  return lines.flatMap((line) => {
    const said = line.events.map((event): RunEvent => ({ time: event.time, kind: 'line', name: `${line.name}: ${event.what}`, object: line.name }));
    const parts = line.parted_at !== null && !line.events.some((event) => Math.abs(event.time - line.parted_at!) < 1e-6);
    return parts ? [...said, { time: line.parted_at!, kind: 'line', name: `${line.name}: parted`, object: line.name }] : said;
  });
}

const findingEvents = (findings: readonly Finding[]): RunEvent[] => findings.flatMap((f): RunEvent[] =>
  (f.time === undefined ? [] : [{ time: f.time, kind: 'finding', name: f.message.length > 70 ? `${f.message.slice(0, 69)}…` : f.message, object: f.object }]));

interface Sources { impacts: readonly Impact[]; state: Series | undefined; lines: readonly MooringInTime[]; findings: readonly Finding[] }

export function eventsOfRun({ impacts, state, lines, findings }: Sources): RunEvent[] {
  return [...impacts.map(impactEvent), ...tensionerEvents(state), ...lineEvents(lines), ...findingEvents(findings)].sort((a, b) => a.time - b.time);
}

/** The next event after a time, or the previous one; events already shown at that time do not count. */
export function nextEvent(events: readonly RunEvent[], time: number, step: 1 | -1, kind?: EventKind): RunEvent | null {
  const shown = 0.06; // s: resolution of the clock
  const list = kind ? events.filter((event) => event.kind === kind) : events;
  return (step > 0 ? list.find((event) => event.time > time + shown) : list.findLast((event) => event.time < time - shown)) ?? null;
}

/** The hardest impact of a list. */
export const worstImpact = (impacts: readonly Impact[]): Impact | null =>
  impacts.reduce<Impact | null>((worst, impact) => (!worst || impact.peak_force > worst.peak_force ? impact : worst), null);

export interface Extreme { time: number; value: number }

/** Maximum or minimum of a history, from t = 0 on. */
export function findExtreme(series: Series, sign: 1 | -1): Extreme | null {
  let best: Extreme | null = null;
  series.t.forEach((time, i) => {
    const value = sign > 0 ? series.max[i]! : series.min[i]!;
    if (time >= 0 && Number.isFinite(value) && (best === null || sign * value > sign * best.value)) best = { time, value };
  });
  return best;
}

/** Histories whose minimum is relevant as well. */
const smallMatters = /tension|clearance|separation/;

export interface Wanted { column: Column; sign: 1 | -1; name: string }

/** Entries of the menu "Go to max / min": every history, and the minimum of tensions and clearances. */
export function wantedExtremes(columns: readonly Column[]): Wanted[] {
  const shown = columns.filter((c) => !/^(tensioner\/state|step|energy_drift|time)$/.test(c.name));
  const named = (sign: 1 | -1) => (column: Column): Wanted => ({ column, sign, name: columnName(column.name) });
  return [...shown.map(named(1)), ...shown.filter((c) => smallMatters.test(c.name)).map(named(-1))];
}

/** Box or mooring line of a history. */
export const objectOfColumn = (name: string): string | null => /^(?:support|mooring|line)\/([^/]+)\//.exec(name)?.[1] ?? null;
