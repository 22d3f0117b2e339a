// The list of runs, updated by requests and by events, which may overtake each other.
import type { Run } from '../api/types';

const ended = (run: Run): boolean => run.state !== 'queued' && run.state !== 'running';

/**
 * Merges a requested list with later events: a run that has ended does not run again, and its end event may arrive
 * before an older list.
 */
export function newerList(known: Run[], list: Run[]): Run[] {
  return list.map((run) => {
    const before = known.find((k) => k.id === run.id);
    return before && ended(before) && !ended(run) ? before : run;
  });
}

const ownName = (run: Run): string => run.name || run.title || run.id;

/** Display names of runs: equal names are numbered in the order of their start, with the changed keys. */
export function listedNames(runs: readonly Run[]): Map<string, string> {
  const alike = new Map<string, Run[]>();
  for (const run of runs) if (!run.parent) alike.set(ownName(run), [...(alike.get(ownName(run)) ?? []), run]);
  const names = new Map(runs.map((run) => [run.id, ownName(run)]));
  for (const [name, list] of alike) {
    if (list.length < 2) continue;
    const order = (a: Run, b: Run): number => (a.started || Infinity) - (b.started || Infinity) || (a.id < b.id ? -1 : 1);
    [...list].sort(order).forEach((run, i) => names.set(run.id, `${name} (${i + 1}${run.changed ? `: ${run.changed}` : ''})`));
  }
  return names;
}

export const isStudy = (run: Run): boolean => run.kind === 'seeds' || run.kind === 'comparison';

/** Seeds from "1-5, 9" or "1 to 5, 9"; null if the text is invalid, or a seed is repeated. */
export function parseSeeds(text: string): number[] | null {
  const seeds: number[] = [];
  for (const part of text.split(',')) {
    const match = /^\s*(\d{1,15})\s*(?:(?:-|–|to)\s*(\d{1,15}))?\s*$/.exec(part);
    if (!match) return null;
    const first = Number(match[1]), last = Number(match[2] ?? match[1]);
    if (last < first || last - first >= 10000) return null;
    for (let seed = first; seed <= last; ++seed) seeds.push(seed);
  }
  return seeds.length > 10000 || new Set(seeds).size < seeds.length ? null : seeds;
}
