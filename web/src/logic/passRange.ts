// The range of one number in which every check passes: a coarse scan over the slider, then bisection of its ends.
import type { VerdictKind } from '../api/types';

/** Status of a state: `failed` has no equilibrium, `open` has no check. */
export type Judgement = 'passed' | 'reserved' | 'exceeded' | 'failed' | 'open';
export const judgement = (kind: VerdictKind): Judgement => (kind === 'not judged' ? 'open' : kind);

export interface PassInterval {
  from: number;
  to: number;
  /** True if the interval continues beyond the search range. */
  fromOpen: boolean;
  toOpen: boolean;
  /** Extent of the interval that passes with reservations only. */
  reserved: 'none' | 'partly' | 'all';
}

const scanPoints = 11;
const bisections = 6;

const passes = (j: Judgement): boolean => j === 'passed' || j === 'reserved';

function reservedPart(list: readonly Judgement[]): PassInterval['reserved'] {
  const count = list.filter((j) => j === 'reserved').length;
  return count === 0 ? 'none' : count === list.length ? 'all' : 'partly';
}

/** Values from the start outwards, so that each is near one already evaluated. */
export function scanOrder(low: number, high: number, start: number): number[] {
  const grid = Array.from({ length: scanPoints }, (_v, i) => low + ((high - low) * i) / (scanPoints - 1));
  const near = 1e-6 * (high - low);
  const all = start > low && start < high && grid.every((v) => Math.abs(v - start) > near) ? [...grid, start] : grid;
  return all.sort((a, b) => Math.abs(a - start) - Math.abs(b - start));
}

/** Consecutive failing points after which a direction is abandoned. */
const patience = 2;

/** `judge` rejects to end the search. Null if the model has no check. */
export async function findPassIntervals(judge: (value: number) => Promise<Judgement>, low: number, high: number, start: number): Promise<PassInterval[] | null> {
  const judged: { value: number; judgement: Judgement }[] = [];
  const failures = { below: 0, above: 0 };
  let anyPass = false;
  for (const value of scanOrder(low, high, start)) {
    const side = value < start ? 'below' : 'above';
    if (anyPass && failures[side] >= patience) continue;
    const found = await judge(value);
    judged.push({ value, judgement: found });
    failures[side] = passes(found) ? 0 : failures[side] + 1;
    anyPass ||= passes(found);
  }
  if (judged.every((point) => point.judgement === 'open')) return null;
  judged.sort((a, b) => a.value - b.value);

  const edge = async (passing: number, failing: number): Promise<number> => {
    let good = passing, bad = failing;
    for (let i = 0; i < bisections; ++i) {
      const middle = (good + bad) / 2;
      if (passes(await judge(middle))) good = middle; else bad = middle;
    }
    return good;
  };
  const out: PassInterval[] = [];
  for (let i = 0; i < judged.length; ++i) {
    if (!passes(judged[i]!.judgement)) continue;
    const first = i;
    while (i + 1 < judged.length && passes(judged[i + 1]!.judgement)) ++i;
    const before = judged[first - 1], after = judged[i + 1];
    out.push({
      from: before ? await edge(judged[first]!.value, before.value) : judged[first]!.value,
      to: after ? await edge(judged[i]!.value, after.value) : judged[i]!.value,
      fromOpen: !before,
      toOpen: !after,
      reserved: reservedPart(judged.slice(first, i + 1).map((point) => point.judgement)),
    });
  }
  return out;
}

/** "every check passes from 180 kN to 340 kN" */
export function passSentence(intervals: readonly PassInterval[], text: (value: number) => string): string {
  if (intervals.length === 0) return 'no value of this slider passes every check';
  const part = (i: PassInterval): string => {
    const ends = i.fromOpen && i.toOpen ? 'over the whole range' : i.fromOpen ? `up to ${text(i.to)}` : i.toOpen ? `above ${text(i.from)}` : `from ${text(i.from)} to ${text(i.to)}`;
    return i.reserved === 'none' ? ends : `${ends} (${i.reserved === 'partly' ? 'partly ' : ''}with reservations)`;
  };
  return `every check passes ${intervals.map(part).join(', and ')}`;
}
