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
