// Numbers as written in spreadsheets: decimal point or comma, thousands separated by comma, point, space or
// apostrophe, followed by a unit.

export type DecimalMark = '.' | ',' | null;
export interface ReadNumber { digits: string; rest: string }

const front = /^([-+−–]?)\s*(\d[\d.,]*|[.,]\d+)([eE][-+]?\d+)?\s*(.*)$/;

/** Groups of three separated by spaces or apostrophes become one number: "12 345" and "12'345". */
function withoutSpaces(text: string): string {
  return text.replace(/[\u00a0\u202f\u2009]/g, ' ').trim().replace(/(\d)[ '’](?=\d{3}(?!\d))/g, '$1');
}

const isGrouped = (digits: string, mark: string): boolean => {
  const [first, ...rest] = digits.split(mark);
  return rest.length > 0 && /^[1-9]\d{0,2}$/.test(first!) && rest.every((part) => /^\d{3}$/.test(part));
};

/** The unambiguous decimal mark of this number; null if it may be either. */
function certainMark(body: string): DecimalMark {
  const point = body.lastIndexOf('.'), comma = body.lastIndexOf(',');
  if (point >= 0 && comma >= 0) return point > comma ? '.' : ',';
  const mark = point >= 0 ? '.' : ',';
  const count = body.split(mark).length - 1;
  if (count === 0) return null;
  if (count > 1) return mark === '.' ? ',' : '.';
  return isGrouped(body, mark) ? null : mark;
}

/** The common decimal mark of the numbers of a table; null if none of them shows it. */
export function decimalMark(cells: string[]): DecimalMark {
  const seen = new Set(cells.map((cell) => { const match = front.exec(withoutSpaces(cell)); return match ? certainMark(match[2]!) : null; }));
  if (seen.has('.') === seen.has(',')) return null;
  return seen.has(',') ? ',' : '.';
}

function plain(body: string, decimal: DecimalMark): string | 'ambiguous' | null {
  const mark = certainMark(body) ?? decimal ?? (body.includes(',') ? null : '.');
  if (mark === null) return 'ambiguous';
  const otherMark = mark === '.' ? ',' : '.';
  const [whole, fraction, ...more] = body.split(mark);
  if (more.length > 0 || fraction?.includes(otherMark)) return null;
  if (whole!.includes(otherMark) && !isGrouped(whole!, otherMark)) return null;
  const digits = whole!.replaceAll(otherMark, '') || '0';
  return fraction ? `${digits}.${fraction}` : digits;
}

/** Number at the beginning of a text in plain notation, and the remaining text. `decimal`: the mark of the whole table. */
export function readNumber(text: string, decimal: DecimalMark = null): ReadNumber | 'ambiguous' | null {
  const match = front.exec(withoutSpaces(text));
  if (!match) return null;
  const digits = plain(match[2]!, decimal);
  if (digits === null || digits === 'ambiguous') return digits;
  const sign = match[1] === '' || match[1] === '+' ? '' : '-';
  return { digits: `${sign}${digits}${match[3] ?? ''}`, rest: match[4]!.trim() };
}
