// Ranking of entries by the query: every word must match; whole names rank before prefixes, prefixes before substrings.

export interface SearchEntry {
  id: string;
  /** Shown, and searched first. */
  name: string;
  /** Searched with lower weight: path, synonyms, explanation. */
  more?: string;
  /** Shown at the right end: a value, a shortcut. */
  detail?: string;
  kind: 'command' | 'object' | 'key' | 'finding' | 'example';
  /** Rank among equal matches: 0 by default, higher ranks first. */
  weight?: number;
}

const plain = (text: string): string => text.toLowerCase().replace(/[_.[\]/-]+/g, ' ').trim();

/** Spread of the letters if the text contains them in this order, otherwise null. */
function scattered(word: string, text: string): number | null {
  let place = -1, first = -1;
  for (const letter of word) {
    place = text.indexOf(letter, place + 1);
    if (place < 0) return null;
    if (first < 0) first = place;
  }
  return place - first + 1 - word.length;
}

/** 0: no match. */
function wordScore(word: string, text: string): number {
  if (text === word) return 100;
  const parts = text.split(' ');
  if (parts.includes(word)) return 80 - Math.min(20, parts.indexOf(word) * 4);
  const start = parts.findIndex((w) => w.startsWith(word));
  if (start >= 0) return 60 - Math.min(20, start * 4) - (parts[start]!.length - word.length > 6 ? 2 : 0);
  if (text.includes(word)) return word.length > 1 ? 25 : 4;
  // omitted letters: "tnsion"
  if (word.length >= 4) {
    const gaps = parts.map((w) => (w[0] === word[0] ? scattered(word, w) : null)).filter((gap) => gap !== null);
    if (gaps.length) return Math.max(1, 16 - Math.min(...gaps));
  }
  return 0;
}

interface Prepared<E> { entry: E; name: string; more: string }
export type Prepare<E> = Prepared<E>[];
export const prepare = <E extends SearchEntry>(entries: readonly E[]): Prepare<E> =>
  entries.map((entry) => ({ entry, name: plain(entry.name), more: plain(entry.more ?? '') }));

function entryScore<E extends SearchEntry>({ entry, name, more }: Prepared<E>, terms: readonly string[]): number {
  let sum = 0;
  for (const word of terms) {
    const score = Math.max(wordScore(word, name), 0.5 * wordScore(word, more));
    if (score === 0) return 0;
    sum += score;
  }
  const whole = terms.join(' ');
  const bonus = name === whole ? 60 : name.startsWith(whole) ? 30 : 0;
  return sum / terms.length + bonus + (entry.weight ?? 0) - Math.min(10, name.length / 12);
}

/** Best match first; equal matches keep their order. */
export function findEntries<E extends SearchEntry>(list: Prepare<E>, query: string, count: number): E[] {
  const terms = plain(query).split(/\s+/).filter(Boolean);
  if (terms.length === 0) return list.filter((p) => (p.entry.weight ?? 0) > 0).slice(0, count).map((p) => p.entry);
  return list.map((p, i) => ({ entry: p.entry, score: entryScore(p, terms), i })).filter((p) => p.score > 0)
    .sort((a, b) => b.score - a.score || a.i - b.i).slice(0, count).map((p) => p.entry);
}
