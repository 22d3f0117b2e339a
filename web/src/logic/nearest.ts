// The last state with a solution on the way from a solved state to an unsolved one.

/** Numbers by name, in SI. */
export type Numbers = Record<string, number>;

const bisections = 7;

/** Names whose values differ; null if one state lacks a name of the other. */
export function differing(solved: Numbers, failing: Numbers): string[] | null {
  const names = Object.keys(failing);
  if (names.length !== Object.keys(solved).length || names.some((name) => !(name in solved))) return null;
  return names.filter((name) => solved[name] !== failing[name]);
}

export function between(solved: Numbers, failing: Numbers, share: number): Numbers {
  return Object.fromEntries(Object.entries(failing).map(([name, value]) => [name, solved[name]! + share * (value - solved[name]!)]));
}

/** Bisection along the straight path; `solves` is called for one state after another. */
export async function nearestSolved(solved: Numbers, failing: Numbers, solves: (state: Numbers) => Promise<boolean>): Promise<Numbers> {
  let good = 0, bad = 1;
  for (let i = 0; i < bisections; ++i) {
    const middle = (good + bad) / 2;
    if (await solves(between(solved, failing, middle))) good = middle; else bad = middle;
  }
  return between(solved, failing, good);
}
