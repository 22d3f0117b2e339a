// Findings as short bullets: subject first, without paths of this machine, the remainder folded.

import type { Finding } from '../api/results';

export type Severity = Finding['severity'];

export interface Bullet {
  severity: Severity;
  /** Name of the finding in the guide; empty for a diagnostic. */
  code: string;
  /** Box or field of the finding; empty if there is none. */
  name: string;
  short: string;
  /** The whole sentence; the same as `short` if that is complete. */
  full: string;
  /** Key of the model, if there is one to go to. */
  key: string;
  /** Name of the object, position along the pipe and time, if known. */
  object?: string;
  from_top?: number;
  time?: number;
}

const longest = 96;

/** "/home/me/models/rao.csv" becomes "rao.csv"; quoted folders and files may contain blanks. */
export function withoutPaths(text: string): string {
  const quoted = text.replace(/(['"`])(?:[A-Za-z]:)?[\\/](?:(?!\1)[^\n])*[\\/]((?:(?!\1)[^\\/\n])+)\1/g, '$1$2$1');
  return quoted.replace(/(?<![\w.])(?:[A-Za-z]:)?[\\/](?:[^\s'"`:;,()\\/]+[\\/])+([^\s'"`:;,()\\/]+)/g, '$1');
}

/** The key of a field as labelled in the form: "stinger box 3 x". */
export function keyName(key: string): string {
  return key.replace(/\.?boxes\[(\d+)\]/g, (_m, i: string) => ` box ${Number(i) + 1}`).replace(/\[(\d+)\]/g, (_m, i: string) => ` ${Number(i) + 1}`)
    .split('.').slice(-2).join(' ').replaceAll('_', ' ').trim();
}

/** The box that a text names first; "stinger 12" does not name "stinger 1". */
function boxIn(text: string, boxes: readonly string[]): string {
  let found = '', first = Infinity;
  for (const box of boxes) {
    const position = box ? text.search(new RegExp(`(?<![\\w])${box.replace(/[.*+?^${}()|[\]\\]/g, '\\$&')}(?![\\w])`)) : -1;
    if (position >= 0 && (position < first || (position === first && box.length > found.length))) { found = box; first = position; }
  }
  return found;
}

/** The first clause of a long sentence, with an ellipsis. */
function clause(text: string): string {
  if (text.length <= longest) return text;
  for (const end of ['; ', ': ', ', ']) {
    const position = text.indexOf(end, 24);
    if (position > 0 && position <= longest) return `${text.slice(0, position)} …`;
  }
  const blank = text.lastIndexOf(' ', longest);
  return `${text.slice(0, blank > 24 ? blank : longest)} …`;
}

/** Without the file and line prefix: "30in 300m.yaml:13: warning: ...", for any folders and blanks. */
export function withoutPlace(text: string): string {
  return text.replace(/^\s*(?:(?:(?!: )[^\n])*?\.ya?ml(?::\d+)+:\s+|[\w.-]+\.ya?ml:\s+)?(?:(?:warning|error):\s*)?/i, '').trim();
}

export function bullet(text: string, boxes: readonly string[], key = '', severity: Severity = 'caution', code = ''): Bullet {
  const full = withoutPaths(withoutPlace(text));
  const box = boxIn(full, boxes);
  // a name at the beginning is not repeated: "...: stinger 8, port roller"
  const rest = box ? full.replace(`: ${box}, `, ': ') : full;
  return { severity, code, name: key ? keyName(key) : box, short: clause(rest), full: rest, key };
}

const rank: Record<Severity, number> = { serious: 0, caution: 1, note: 2 };

/** One bullet for each finding, the serious ones first, otherwise in the order of their first occurrence. */
export function bullets(list: readonly Finding[], boxes: readonly string[]): Bullet[] {
  const out: Bullet[] = [];
  for (const f of list) {
    const b = { ...bullet(f.message, boxes, '', f.severity, f.code), object: f.object, from_top: f.from_top, time: f.time };
    if (!out.some((o) => o.full === b.full)) out.push(b);
  }
  return out.sort((a, b) => rank[a.severity] - rank[b.severity]);
}
