// Findings as short bullets: what they are about in front, no paths of this machine, the rest to be unfolded.

import type { Finding } from '../api/results';

export type Severity = Finding['severity'];

export interface Bullet {
  severity: Severity;
  /** Name of the finding in the guide; empty of a diagnostic. */
  code: string;
  /** Box or field that it is about; empty where it is about none. */
  name: string;
  short: string;
  /** The whole sentence; the same as `short` where that says everything. */
  full: string;
  /** Key of the model, where there is one to lead to. */
  key: string;
  /** Name of what it is about, place along the pipe and time, as far as they are known. */
  object?: string;
  from_top?: number;
  time?: number;
}

const longest = 96;

/** "/home/me/models/rao.csv" becomes "rao.csv"; between quotes folders and files may have blanks. */
export function withoutPaths(text: string): string {
  const quoted = text.replace(/(['"`])(?:[A-Za-z]:)?[\\/](?:(?!\1)[^\n])*[\\/]((?:(?!\1)[^\\/\n])+)\1/g, '$1$2$1');
  return quoted.replace(/(?<![\w.])(?:[A-Za-z]:)?[\\/](?:[^\s'"`:;,()\\/]+[\\/])+([^\s'"`:;,()\\/]+)/g, '$1');
}

/** The key of a field in the words of the form: "stinger box 3 x". */
export function keyName(key: string): string {
  return key.replace(/\.?boxes\[(\d+)\]/g, (_m, i: string) => ` box ${Number(i) + 1}`).replace(/\[(\d+)\]/g, (_m, i: string) => ` ${Number(i) + 1}`)
    .split('.').slice(-2).join(' ').replaceAll('_', ' ').trim();
}

/** The box that a text names first; "stinger 1" is not named by "stinger 12". */
function boxIn(text: string, boxes: readonly string[]): string {
  let found = '', first = Infinity;
  for (const box of boxes) {
    const at = box ? text.search(new RegExp(`(?<![\\w])${box.replace(/[.*+?^${}()|[\]\\]/g, '\\$&')}(?![\\w])`)) : -1;
    if (at >= 0 && (at < first || (at === first && box.length > found.length))) { found = box; first = at; }
  }
  return found;
}

/** The first clause, where the sentence is longer than a bullet; the mark at its end says that there is more. */
function clause(text: string): string {
  if (text.length <= longest) return text;
  for (const end of ['; ', ': ', ', ']) {
    const at = text.indexOf(end, 24);
    if (at > 0 && at <= longest) return `${text.slice(0, at)} …`;
  }
  const blank = text.lastIndexOf(' ', longest);
  return `${text.slice(0, blank > 24 ? blank : longest)} …`;
}

/** Without the place in a file that stands in front: "30in 300m.yaml:13: warning: ...", with whatever folders and blanks. */
export function withoutPlace(text: string): string {
  return text.replace(/^\s*(?:(?:(?!: )[^\n])*?\.ya?ml(?::\d+)+:\s+|[\w.-]+\.ya?ml:\s+)?(?:(?:warning|error):\s*)?/i, '').trim();
}

export function bullet(text: string, boxes: readonly string[], key = '', severity: Severity = 'caution', code = ''): Bullet {
  const full = withoutPaths(withoutPlace(text));
  const box = boxIn(full, boxes);
  // a name that stands in front need not be said again: "...: stinger 8, port roller"
  const rest = box ? full.replace(`: ${box}, `, ': ') : full;
  return { severity, code, name: key ? keyName(key) : box, short: clause(rest), full: rest, key };
}

const rank: Record<Severity, number> = { serious: 0, caution: 1, note: 2 };

/** One bullet for each finding, the serious ones first, otherwise in the order of their first mention. */
export function bullets(list: readonly Finding[], boxes: readonly string[]): Bullet[] {
  const out: Bullet[] = [];
  for (const f of list) {
    const b = { ...bullet(f.message, boxes, '', f.severity, f.code), object: f.object, from_top: f.from_top, time: f.time };
    if (!out.some((o) => o.full === b.full)) out.push(b);
  }
  return out.sort((a, b) => rank[a.severity] - rank[b.severity]);
}
