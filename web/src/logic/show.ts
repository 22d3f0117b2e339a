// Quantities along the pipe: name, unit on the page, and factor from SI.
export interface Shown { key: 'tension' | 'moment' | 'bending_stress' | 'von_mises' | 'strain' | 'utilisation' | 'checks'; name: string; unit: string; factor: number }

export const quantities: Shown[] = [
  { key: 'tension', name: 'Effective tension', unit: 'kN', factor: 1e-3 },
  { key: 'moment', name: 'Bending moment', unit: 'kN m', factor: 1e-3 },
  { key: 'bending_stress', name: 'Bending stress', unit: 'MPa', factor: 1e-6 },
  { key: 'von_mises', name: 'von Mises stress', unit: 'MPa', factor: 1e-6 },
  { key: 'strain', name: 'Strain', unit: '%', factor: 100 },
  { key: 'utilisation', name: 'von Mises stress / yield stress', unit: '–', factor: 1 },
  { key: 'checks', name: 'Utilisation of code checks', unit: '–', factor: 1 },
];

export const quantity = (key: string): Shown | undefined => quantities.find((q) => q.key === key);

const scales: Record<string, [string, number]> = { N: ['kN', 1e-3], Pa: ['MPa', 1e-6], rad: ['deg', 180 / Math.PI], 'N m': ['kN m', 1e-3], 'N/m': ['kN/m', 1e-3], 'rad/s': ['deg/s', 180 / Math.PI] };

/** Unit and factor in which a history of the results is shown. */
export function display(unit: string): [string, number] {
  return scales[unit] ?? [unit === '1' ? '–' : unit, 1];
}

export function duration(seconds: number): string {
  if (!Number.isFinite(seconds)) return '–';
  if (seconds < 90) return `${Math.round(seconds)} s`;
  const minutes = Math.round(seconds / 60);
  return minutes < 90 ? `${minutes} min` : `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}
