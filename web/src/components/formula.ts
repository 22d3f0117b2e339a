// Splits a formula in the program's notation into typeset pieces: "sigma_eq = sqrt(sigma_l^2 + 3 tau^2)".

export type Piece = { kind: 'text'; text: string } | { kind: 'index'; text: string } | { kind: 'power'; pieces: Piece[] };

type TokenKind = 'number' | 'name' | 'open' | 'close' | 'sign';
interface Token { kind: TokenKind; text: string }

const pattern = /(?<number>\d[\d.]*)|(?<name>\p{L}[\p{L}\d_]*)|(?<open>\()|(?<close>\))|(?<sign>[^\s])/gu;
const functions = new Set(['sqrt', 'exp', 'ln', 'log10', 'max', 'min']);
const narrowSpace = '\u202f';

const letters = new Map([
  ['alpha', 'α'],
  ['beta', 'β'],
  ['gamma', 'γ'],
  ['delta', 'δ'],
  ['eps', 'ε'],
  ['nu', 'ν'],
  ['sigma', 'σ'],
  ['pi', 'π'],
  ['dp', 'Δp'],
  ['log10', 'log'],
]);

function tokens(formula: string): Token[] {
  return [...formula.matchAll(pattern)].map((match) => {
    const [kind] = Object.entries(match.groups!).find(([, text]) => text !== undefined)!;
    return { kind: kind as TokenKind, text: match[0] };
  });
}

/** True if two consecutive tokens are factors of a product; a function and its bracket are not. */
function multiplies(left: Token, right: Token): boolean {
  const ends = left.kind === 'number' || left.kind === 'close' || (left.kind === 'name' && !functions.has(left.text));
  return ends && right.kind !== 'close' && right.kind !== 'sign';
}

/** A binary sign has space around it; a sign before a number or after a bracket has none. */
function sign(text: string, before: Token | undefined): string {
  if (text === ',') return ', ';
  if (text === '/' || text === '^') return text;
  const shown = text === '-' ? '−' : text;
  return before === undefined || before.kind === 'open' ? shown : ` ${shown} `;
}

const greek = (word: string): string => letters.get(word) ?? word;

function symbol(name: string): Piece[] {
  const cut = name.indexOf('_');
  if (cut < 0) return [{ kind: 'text', text: greek(name) }];
  return [{ kind: 'text', text: greek(name.slice(0, cut)) }, { kind: 'index', text: greek(name.slice(cut + 1)) }];
}

/** Merges consecutive texts. */
function joined(pieces: Piece[]): Piece[] {
  const out: Piece[] = [];
  for (const piece of pieces) {
    const last = out.at(-1);
    if (last?.kind === 'text' && piece.kind === 'text') out[out.length - 1] = { kind: 'text', text: last.text + piece.text };
    else out.push(piece);
  }
  return out;
}

export function formulaPieces(formula: string): Piece[] {
  const all = tokens(formula);
  const out: Piece[] = [];
  for (let i = 0; i < all.length; ++i) {
    const token = all[i]!, before = all[i - 1], after = all[i + 1];
    if (before !== undefined && multiplies(before, token)) out.push({ kind: 'text', text: narrowSpace });
    if (token.text === '^' && after !== undefined && after.kind !== 'open') {
      out.push({ kind: 'power', pieces: symbol(after.text) });
      ++i;
    } else if (token.kind === 'sign') {
      out.push({ kind: 'text', text: sign(token.text, before) });
    } else {
      out.push(...symbol(token.text));
    }
  }
  return joined(out);
}
