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
