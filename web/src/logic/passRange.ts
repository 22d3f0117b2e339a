// The range of one number in which every check passes: a coarse scan over the slider, then bisection of its ends.
import type { VerdictKind } from '../api/types';

/** What a state says: `failed` has no equilibrium, `open` is judged by no check. */
export type Judgement = 'passed' | 'reserved' | 'exceeded' | 'failed' | 'open';
export const judgement = (kind: VerdictKind): Judgement => (kind === 'not judged' ? 'open' : kind);

export interface PassInterval {
  from: number;
  to: number;
  /** Whether the interval goes on beyond what was searched. */
  fromOpen: boolean;
  toOpen: boolean;
  /** How much of it passes with reservations only. */
  reserved: 'none' | 'partly' | 'all';
}

const scanPoints = 11;
const bisections = 6;

const passes = (j: Judgement): boolean => j === 'passed' || j === 'reserved';

function reservedPart(list: readonly Judgement[]): PassInterval['reserved'] {
  const count = list.filter((j) => j === 'reserved').length;
  return count === 0 ? 'none' : count === list.length ? 'all' : 'partly';
}

/** Values from the middle outwards, so that each is near one that was judged before. */
export function scanOrder(low: number, high: number, own: number): number[] {
  const grid = Array.from({ length: scanPoints }, (_v, i) => low + ((high - low) * i) / (scanPoints - 1));
  const near = 1e-6 * (high - low);
  const all = own > low && own < high && grid.every((v) => Math.abs(v - own) > near) ? [...grid, own] : grid;
  return all.sort((a, b) => Math.abs(a - own) - Math.abs(b - own));
}

/** Points that fail one after another, seen from where it passes, after which a direction is given up. */
const patience = 2;

/** `judge` rejects when the search is to end. Null where no check judges the model. */
export async function findPassIntervals(judge: (value: number) => Promise<Judgement>, low: number, high: number, own: number): Promise<PassInterval[] | null> {
  const judged: { value: number; judgement: Judgement }[] = [];
  const failures = { below: 0, above: 0 };
  let anyPass = false;
  for (const value of scanOrder(low, high, own)) {
    const side = value < own ? 'below' : 'above';
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
  if (intervals.length === 0) return 'in no part of this slider does every check pass';
  const part = (i: PassInterval): string => {
    const ends = i.fromOpen && i.toOpen ? 'on the whole slider' : i.fromOpen ? `up to ${text(i.to)}` : i.toOpen ? `above ${text(i.from)}` : `from ${text(i.from)} to ${text(i.to)}`;
    return i.reserved === 'none' ? ends : `${ends} (${i.reserved === 'partly' ? 'in part ' : ''}with reservations)`;
  };
  return `every check passes ${intervals.map(part).join(', and ')}`;
}
