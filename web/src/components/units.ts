// Formatting of numbers: in the shown units, with fixed decimals.
import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import type { ShownUnits } from './document';

const nothing = '-';

/** Fixed decimals, never "-0.0"; "-" if not finite. */
export function fixed(value: number, digits: number): string {
  if (!Number.isFinite(value)) return nothing;
  const text = value.toFixed(digits);
  return Number(text) === 0 ? (0).toFixed(digits) : text;
}

/** A number with a given number of significant digits, without trailing zeros. */
export const significant = (value: number, digits: number): string => String(Number(value.toPrecision(digits)));

/** Short name for limited space. */
export const shortened = (name: string, length = 16): string => (name.length > length ? `${name.slice(0, length - 1)}\u2026` : name);

type ShownUnit = ShownUnits[string];

/** Shows SI values; `digits`: decimals of metric values. */
export interface Units {
  /** The shown unit of an SI unit; the SI unit itself by default. "section": lengths of a cross-section. */
  unit(si: string): ShownUnit;
  /** "276.5" */
  number(value: number, si: string, digits: number): string;
  /** "276.5 kN" */
  shown(value: number, si: string, digits: number): string;
  /** "Tension [kN]"; the title only for dimensionless numbers. */
  title(title: string, si: string): string;
}

export function makeUnits(unit: (si: string) => ShownUnit): Units {
  const number: Units['number'] = (value, si, digits) => {
    const { factor, more } = unit(si);
    return fixed(value * factor, Math.max(0, digits + more));
  };
  return {
    unit,
    number,
    shown: (value, si, digits) => `${number(value, si, digits)} ${unit(si).name}`.trimEnd(),
    title: (title, si) => (unit(si).name ? `${title} [${unit(si).name}]` : title),
  };
}

export function unitsFromTable(table: ShownUnits): Units {
  return makeUnits((si) => table[si] ?? { name: si === 'section' ? 'm' : si, factor: 1, more: 0 });
}

/** SI units if no others are given. */
export const UnitsContext = createContext(unitsFromTable({}));

export const useUnits = (): Units => useContext(UnitsContext);
