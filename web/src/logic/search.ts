// Ranking of entries by what was typed: every word has to be found, whole names before beginnings before parts.

export interface SearchEntry {
  id: string;
  /** Shown, and searched first. */
  name: string;
  /** Searched as well, of less weight: path, synonyms, explanation. */
  more?: string;
  /** Shown at the right end: a value, a shortcut. */
  detail?: string;
  kind: 'command' | 'object' | 'key' | 'finding' | 'example';
  /** Before others that fit as well: 0 usual, above sooner. */
  weight?: number;
}

const plain = (text: string): string => text.toLowerCase().replace(/[_.[\]/-]+/g, ' ').trim();

/** Whether the letters stand in the text in this order; how far apart, or null. */
function scattered(word: string, text: string): number | null {
  let place = -1, first = -1;
  for (const letter of word) {
    place = text.indexOf(letter, place + 1);
    if (place < 0) return null;
    if (first < 0) first = place;
  }
  return place - first + 1 - word.length;
}

/** 0: not there. */
function wordScore(word: string, text: string): number {
  if (text === word) return 100;
  const words = text.split(' ');
  if (words.includes(word)) return 80 - Math.min(20, words.indexOf(word) * 4);
  const start = words.findIndex((w) => w.startsWith(word));
  if (start >= 0) return 60 - Math.min(20, start * 4) - (words[start]!.length - word.length > 6 ? 2 : 0);
  if (text.includes(word)) return word.length > 1 ? 25 : 4;
  // letters of one word left out: "tnsion"
  if (word.length >= 4) {
    const gaps = words.map((w) => (w[0] === word[0] ? scattered(word, w) : null)).filter((gap) => gap !== null);
    if (gaps.length) return Math.max(1, 16 - Math.min(...gaps));
  }
  return 0;
}

interface Prepared<E> { entry: E; name: string; more: string }
export type Prepare<E> = Prepared<E>[];
export const prepare = <E extends SearchEntry>(entries: readonly E[]): Prepare<E> =>
  entries.map((entry) => ({ entry, name: plain(entry.name), more: plain(entry.more ?? '') }));

function entryScore<E extends SearchEntry>({ entry, name, more }: Prepared<E>, words: readonly string[]): number {
  let sum = 0;
  for (const word of words) {
    const score = Math.max(wordScore(word, name), 0.5 * wordScore(word, more));
    if (score === 0) return 0;
    sum += score;
  }
  const whole = words.join(' ');
  const bonus = name === whole ? 60 : name.startsWith(whole) ? 30 : 0;
  return sum / words.length + bonus + (entry.weight ?? 0) - Math.min(10, name.length / 12);
}

/** The best first; entries that fit equally well stay in their order. */
export function findEntries<E extends SearchEntry>(list: Prepare<E>, query: string, count: number): E[] {
  const words = plain(query).split(/\s+/).filter(Boolean);
  if (words.length === 0) return list.filter((p) => (p.entry.weight ?? 0) > 0).slice(0, count).map((p) => p.entry);
  return list.map((p, i) => ({ entry: p.entry, score: entryScore(p, words), i })).filter((p) => p.score > 0)
    .sort((a, b) => b.score - a.score || a.i - b.i).slice(0, count).map((p) => p.entry);
}
