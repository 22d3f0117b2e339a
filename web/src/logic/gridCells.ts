// A cell of a grid: a value of the model as a number in the unit of its column, and conversion of typed text to a value.
import type { Field } from '../api/types';
import type { GridColumn } from './gridColumns';
import { readNumber, type DecimalMark } from './gridNumbers';
import { fromSi, parseQuantity, sameFamily, tidy, toSi, unitsLike } from './units';

/** `value`: sent to the program, null removes the key. */
export type ReadCell = { value: string | number | null } | { message: string };

/** Unit of the column head: the most frequent unit of its values, otherwise that of the schema. */
export function headUnit(written: (string | number | null)[], schemaUnit: string): string {
  const counts = new Map<string, number>();
  for (const value of written) {
    const unit = value === null ? '' : parseQuantity(String(value))?.unit;
    if (unit) counts.set(unit, (counts.get(unit) ?? 0) + 1);
  }
  let most = 0, unit = unitsLike(schemaUnit)[0]!;
  for (const [name, count] of counts) if (count > most) { most = count; unit = name; }
  return unit;
}

/** A value in the unit of the head, without the unit if it is the same. */
export function shownValue(value: string | number | null, unit: string): string {
  if (value === null) return '';
  const text = String(value);
  if (!unit) return text;
  const quantity = parseQuantity(text);
  if (!quantity?.unit) return text;
  if (quantity.unit === unit) return /^[-+]?[\d.]+(?:[eE][-+]?\d+)?/.exec(text.trim())?.[0] ?? text;
  return sameFamily(quantity.unit, unit) ? tidy(fromSi(toSi(quantity.number, quantity.unit), unit), 7) : text;
}

const spelling = (unit: string): string => unit.replace(/²/g, '^2').replace(/³/g, '^3').replace(/°/g, 'deg').replace(/[·.]/g, ' ').replace(/([a-zA-Z])([23])$/, '$1^$2').trim();

/** The unit as the program writes it; null if it is of another kind. */
export function unitLike(typed: string, unit: string): string | null {
  const candidates = unitsLike(unit), plain = spelling(typed), bare = (name: string): string => name.toLowerCase().replace(/[\s*]/g, '');
  const wanted = [typed, plain].flatMap((text) => [text, parseQuantity(`1 ${text}`)?.unit]);
  const alike = candidates.filter((name) => bare(name) === bare(plain));
  return candidates.find((name) => wanted.includes(name)) ?? (alike.length === 1 ? alike[0]! : null);
}

const listed = (names: string[]): string => names.slice(0, 6).join(', ');

function readQuantity(text: string, column: GridColumn, unit: string, decimal: DecimalMark): ReadCell {
  const number = readNumber(text, decimal);
  if (number === 'ambiguous') return ambiguous(text);
  if (!number) return { message: `Enter a number in ${unit}, or with its unit.` };
  if (!number.rest) return { value: `${number.digits} ${unit}` };
  const known = unitLike(number.rest, unit);
  if (known) return { value: `${number.digits} ${known}` };
  return { message: `“${number.rest}” is not a unit of ${column.title}. Units: ${listed(unitsLike(unit))}.` };
}

function ambiguous(text: string): ReadCell {
  return { message: `“${text.trim()}” is ambiguous: enter ${text.trim().replace(',', '')} or ${text.trim().replace(',', '.')}.` };
}

function readPlain(text: string, column: GridColumn, decimal: DecimalMark): ReadCell {
  const number = readNumber(text, decimal);
  if (number === 'ambiguous') return ambiguous(text);
  if (!number || number.rest) return { message: 'Enter a number without unit.' };
  if (column.kind === 'integer' && !Number.isInteger(Number(number.digits))) return { message: 'Enter a whole number.' };
  return { value: Number(number.digits) };
}

function readChoice(text: string, column: GridColumn): ReadCell {
  const flat = (word: string): string => word.trim().toLowerCase().replace(/[\s_-]+/g, ' ');
  const choice = column.choices.find((c) => flat(c) === flat(text));
  return choice === undefined ? { message: `One of: ${column.choices.join(', ')}.` } : { value: choice };
}

/** Reads typed or pasted text as a value of the column. `unit`: default for a bare number. */
export function readCell(text: string, column: GridColumn, unit: string, decimal: DecimalMark = null): ReadCell {
  if (text.trim() === '') return { value: null };
  switch (column.kind) {
    case 'quantity': return readQuantity(text, column, unit, decimal);
    case 'number': case 'integer': return readPlain(text, column, decimal);
    case 'choice': return readChoice(text, column);
    case 'text': return { value: text.trim() };
    case 'nested': return { message: 'Select it to edit its contents.' };
  }
}

/** Short text of a nested group or list. */
export function summary(field: Field | undefined, members: Field[]): string {
  if (!field?.given) return '';
  if (field.kind === 'list') return field.count === 1 ? '1 item' : `${field.count ?? 0} items`;
  const values = members.filter((m) => m.given && m.value !== null).slice(0, 3).map((m) => String(m.value));
  return values.join(', ') || 'given';
}
