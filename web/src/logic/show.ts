// How results are shown: names, units and factors from SI come from the program's table of quantities.
import { quantities, shownUnits } from '../api/results';

export { quantities };
export type Shown = (typeof quantities)[number];

export const quantity = (key: string): Shown | undefined => quantities.find((q) => q.key === key);

/** Unit and factor in which values of an SI unit are shown. */
export function display(unit: string): [string, number] {
  const shown = shownUnits[unit];
  return shown ? [shown.unit, shown.factor] : [unit, 1];
}

export function duration(seconds: number): string {
  if (!Number.isFinite(seconds)) return '–';
  if (seconds < 90) return `${Math.round(seconds)} s`;
  const minutes = Math.round(seconds / 60);
  return minutes < 90 ? `${minutes} min` : `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

/** The name of an axis, and what is left of it where there is less room: its unit in the end. */
export function axisNames(name: string): string[] {
  const way = /\b(?:from|along) .*/.exec(name)?.[0], unit = /\[.*\]$/.exec(name)?.[0];
  return [name, way, unit].filter((part): part is string => part !== undefined);
}
