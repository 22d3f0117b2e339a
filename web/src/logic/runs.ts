// The list of runs, told in two ways that may overtake each other.
import type { Run } from '../api/types';

const ended = (run: Run): boolean => run.state !== 'queued' && run.state !== 'running';

/**
 * A list that was asked for, on top of what events have told meanwhile: a run that has ended does not run again, and its
 * end may have been heard of before an older list arrives.
 */
export function newerList(known: Run[], list: Run[]): Run[] {
  return list.map((run) => {
    const before = known.find((k) => k.id === run.id);
    return before && ended(before) && !ended(run) ? before : run;
  });
}

const ownName = (run: Run): string => run.name || run.title || run.id;

/** Names under which runs are listed: those that would be called alike are numbered in the order of their start, with what was changed for them. */
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

/** "1-5, 9" or "1 to 5, 9" as the seeds that are meant; null where it says nothing of the kind, or a seed twice. */
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
