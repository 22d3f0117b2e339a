// Code checks in order of importance.
import type { Check, SheetLine } from '../api/types';
import type { SheetLine as DrawnLine } from '../components/document';
import { display } from './show';

const regions = ['tower', 'overbend', 'stinger tip', 'sagbend', 'seabed', 'line'];

const judged = (c: Check): boolean => c.status === 'passed' || c.status === 'exceeded';

/** The governing check of each region, tensioner first. */
export function governing(checks: readonly Check[]): Check[] {
  return regions.flatMap((region) => {
    const those = checks.filter((c) => c.region === region && c.governing && judged(c));
    return those.length ? [those.reduce((a, b) => (b.utilisation! > a.utilisation! ? b : a))] : [];
  });
}

/** All checks: the governing ones by utilisation, then those for information, then those not evaluated. */
export function ranked(checks: readonly Check[]): Check[] {
  const rank = (c: Check): number => (!judged(c) ? 2 : c.governing ? 0 : 1);
  return [...checks].sort((a, b) => rank(a) - rank(b) || (b.utilisation ?? 0) - (a.utilisation ?? 0));
}

export const level = (c: Check): 'over' | 'near' | 'good' | 'open' =>
  (!judged(c) ? 'open' : !c.governing ? 'open' : c.utilisation! > 1 ? 'over' : c.utilisation! > 0.87 ? 'near' : 'good');

export const regionName = (region: string): string => (region === 'line' ? 'whole line' : region);

/** Value of a line of a calculation sheet with its unit: "448 MPa". */
function sheetValue(line: SheetLine): string {
  const [unit, factor] = line.units === '1' ? ['', 1] : display(line.units === 'm' ? 'mm' : line.units);
  const value = line.value * factor;
  const text = Number(value.toPrecision(6)).toString();
  return unit ? `${text} ${unit}` : text;
}

function confirmation({ confirmation: kind, sources }: SheetLine): string {
  if (kind === 'not needed') return '';
  const of = sources ? `: ${sources}` : '';
  return kind === 'unconfirmed' ? `Recalled, not confirmed by a public text${of}` : `Confirmed by ${kind}${of}`;
}

/** A calculation sheet for drawing. */
export const drawnSheet = (lines: readonly SheetLine[]): DrawnLine[] => lines.map((line) => (
  { ...line, numbers: '', value: sheetValue(line), confirmed: confirmation(line), soft: line.confirmation === 'unconfirmed' }));
