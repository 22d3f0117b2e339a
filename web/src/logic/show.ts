// Display of results: names, units and factors from SI come from the program's table of quantities.
import { quantities as table, shownUnits, type ShownUnit } from '../api/results';
import { makeUnits } from '../components/units';
import { tidy, twin } from './units';

/** Unit system of the page, given by the program. Typed values keep their unit. */
export const unitSystem: 'metric' | 'us' = typeof document !== 'undefined' && document.documentElement.dataset.units === 'us' ? 'us' : 'metric';

export const quantities = table.map(({ metric, us, ...q }) => ({ ...q, ...(unitSystem === 'us' ? us : metric) }));
export type Shown = (typeof quantities)[number];

export const quantity = (key: string): Shown | undefined => quantities.find((q) => q.key === key);

const millimetre: ShownUnit = unitSystem === 'us' ? { unit: 'in', factor: 1 / 0.0254, digits: 3, more: 2 } : { unit: 'mm', factor: 1e3, digits: 1, more: 0 };

/** Format of values of an SI unit; "mm": lengths of a section [m]. */
export const shownUnit = (si: string): ShownUnit => (si === 'mm' ? millimetre : shownUnits[unitSystem][si] ?? { unit: si, factor: 1, digits: 3, more: 0 });

/** Unit and factor for values of an SI unit. */
export function display(si: string): [string, number] {
  const shown = shownUnit(si);
  return [shown.unit, shown.factor];
}

/** An SI value in its shown unit, without the unit: about `digits` significant figures. */
export const numberIn = (value: number, si: string, digits = 4): string => tidy(value * shownUnit(si).factor, digits);

/** The same with its unit: "276.5 kN". */
export const text = (value: number, si: string, digits = 4): string => `${numberIn(value, si, digits)} ${shownUnit(si).unit}`;

/** The same for components, which have neither a dash for dimensionless numbers nor "mm". */
export const pageUnits = makeUnits((si) => {
  const { unit, factor, more } = shownUnit(si === 'section' ? 'mm' : si);
  return { name: unit === '–' ? '' : unit, factor, more };
});

/** With the number of decimals of a metric value. */
export const fixedIn = pageUnits.number;

/** A number with its unit, and in the other unit system. */
export function withTwin(number: string, unit = ''): string {
  const shown = `${number} ${unit}`.trimEnd(), converted = twin(shown);
  return converted ? `${shown} (${converted})` : shown;
}

export const unitName = (si: string): string => shownUnit(si).unit;

export function duration(seconds: number): string {
  if (!Number.isFinite(seconds)) return '–';
  if (seconds < 90) return `${Math.round(seconds)} s`;
  const minutes = Math.round(seconds / 60);
  return minutes < 90 ? `${minutes} min` : `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

/** Variants of an axis label, from long to short; the shortest is its unit. */
export function axisNames(name: string): string[] {
  const way = /\b(?:from|along) .*/.exec(name)?.[0], unit = /\[.*\]$/.exec(name)?.[0];
  return [name, way, unit].filter((part): part is string => part !== undefined);
}
