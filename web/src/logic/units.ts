// Engineering units: reading typed values, and conversion to the other unit system.
// The program reads far more units; this table only covers values displayed by the page.

interface Unit { family: string; factor: number; twin?: string }

const table: Record<string, Unit> = {
  m: { family: 'length', factor: 1, twin: 'ft' },
  mm: { family: 'length', factor: 1e-3, twin: 'in' },
  cm: { family: 'length', factor: 1e-2, twin: 'in' },
  km: { family: 'length', factor: 1e3, twin: 'ft' },
  in: { family: 'length', factor: 0.0254, twin: 'mm' },
  ft: { family: 'length', factor: 0.3048, twin: 'm' },
  N: { family: 'force', factor: 1, twin: 'lbf' },
  kN: { family: 'force', factor: 1e3, twin: 'kip' },
  MN: { family: 'force', factor: 1e6, twin: 'kip' },
  lbf: { family: 'force', factor: 4.4482216152605, twin: 'N' },
  kip: { family: 'force', factor: 4448.2216152605, twin: 'kN' },
  tf: { family: 'force', factor: 9806.65, twin: 'kN' },
  t: { family: 'mass', factor: 1000, twin: 'lb' },
  kg: { family: 'mass', factor: 1, twin: 'lb' },
  lb: { family: 'mass', factor: 0.45359237, twin: 'kg' },
  Pa: { family: 'pressure', factor: 1, twin: 'psi' },
  kPa: { family: 'pressure', factor: 1e3, twin: 'psi' },
  MPa: { family: 'pressure', factor: 1e6, twin: 'ksi' },
  GPa: { family: 'pressure', factor: 1e9, twin: 'ksi' },
  bar: { family: 'pressure', factor: 1e5, twin: 'psi' },
  psi: { family: 'pressure', factor: 6894.757293168, twin: 'MPa' },
  ksi: { family: 'pressure', factor: 6894757.293168, twin: 'MPa' },
  'N/m^2': { family: 'pressure', factor: 1, twin: 'psi' },
  'kN/m^2': { family: 'pressure', factor: 1e3, twin: 'psi' },
  'N/m^3': { family: 'weight density', factor: 1, twin: 'lbf/ft^3' },
  'kN/m^3': { family: 'weight density', factor: 1e3, twin: 'lbf/ft^3' },
  'lbf/ft^3': { family: 'weight density', factor: 157.08746061538, twin: 'kN/m^3' },
  'm/s': { family: 'speed', factor: 1, twin: 'knot' },
  'ft/s': { family: 'speed', factor: 0.3048, twin: 'm/s' },
  knot: { family: 'speed', factor: 1852 / 3600, twin: 'm/s' },
  rad: { family: 'angle', factor: 1, twin: 'deg' },
  deg: { family: 'angle', factor: Math.PI / 180 },
  s: { family: 'time', factor: 1 },
  min: { family: 'time', factor: 60, twin: 's' },
  h: { family: 'time', factor: 3600, twin: 's' },
  'kN m': { family: 'moment', factor: 1e3, twin: 'kip ft' },
  'kip ft': { family: 'moment', factor: 1355.8179483314004, twin: 'kN m' },
  'lbf/ft': { family: 'stiffness', factor: 14.593902937206, twin: 'kN/m' },
  'kN/m': { family: 'stiffness', factor: 1e3, twin: 'kip/ft' },
  'kip/ft': { family: 'stiffness', factor: 14593.902937206, twin: 'kN/m' },
  'N/m': { family: 'stiffness', factor: 1, twin: 'lbf/ft' },
  'MN/m': { family: 'stiffness', factor: 1e6, twin: 'kip/ft' },
  'N m': { family: 'moment', factor: 1 },
  'MN m': { family: 'moment', factor: 1e6, twin: 'kip ft' },
  'N/mm^2': { family: 'pressure', factor: 1e6, twin: 'ksi' },
  'kN m^2': { family: 'bending stiffness', factor: 1e3 },
  'N m^2': { family: 'bending stiffness', factor: 1 },
  'MN m^2': { family: 'bending stiffness', factor: 1e6 },
  'kg/m': { family: 'mass per length', factor: 1, twin: 'lb/ft' },
  't/m': { family: 'mass per length', factor: 1e3, twin: 'lb/ft' },
  'lb/ft': { family: 'mass per length', factor: 1.4881639435696, twin: 'kg/m' },
  'm^2': { family: 'area', factor: 1, twin: 'ft^2' },
  'mm^2': { family: 'area', factor: 1e-6 },
  'ft^2': { family: 'area', factor: 0.09290304, twin: 'm^2' },
  'm^3': { family: 'volume', factor: 1 },
  '1/m': { family: 'curvature', factor: 1, twin: '1/ft' },
  '1/ft': { family: 'curvature', factor: 1 / 0.3048, twin: '1/m' },
  'km/h': { family: 'speed', factor: 1 / 3.6, twin: 'knot' },
  'm/min': { family: 'speed', factor: 1 / 60 },
  ms: { family: 'time', factor: 1e-3 },
  '%': { family: 'share', factor: 0.01 },
};

const alias: Record<string, string> = { 'kN*m': 'kN m', 'kip*ft': 'kip ft', 'N*m': 'N m', 'MN*m': 'MN m', 'kN*m^2': 'kN m^2', 'N*m^2': 'N m^2', 'MN*m^2': 'MN m^2', te: 't', mt: 't', tonf: 'tf', inch: 'in', knots: 'knot', kn: 'knot', sec: 's', hour: 'h', degree: 'deg', degrees: 'deg', '"': 'in', "'": 'ft' };

export interface Quantity { number: number; unit: string }

const pattern = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*$/;

export function known(unit: string): boolean {
  return (alias[unit] ?? unit) in table;
}

/** Reads "16 in", "406.4 mm" or a bare number; null if the text does not begin with a number. */
export function parseQuantity(text: string): Quantity | null {
  const match = pattern.exec(text);
  if (!match) return null;
  const unit = match[2]!;
  return { number: Number(match[1]), unit: alias[unit] ?? unit };
}

export function sameFamily(a: string, b: string): boolean {
  const first = table[a];
  return first !== undefined && first.family === table[b]?.family;
}

/** Names of the units of one kind, starting with this one. */
export function unitsLike(unit: string): string[] {
  const canonical = alias[unit] ?? unit;
  return table[canonical] ? [canonical, ...Object.keys(table).filter((name) => name !== canonical && sameFamily(name, canonical))] : [unit];
}

export function toSi(number: number, unit: string): number {
  const u = table[alias[unit] ?? unit];
  return u ? number * u.factor : Number.NaN;
}

export function fromSi(si: number, unit: string): number {
  const u = table[alias[unit] ?? unit];
  return u ? si / u.factor : Number.NaN;
}

/** A number with about `digits` significant figures, without round-off noise. */
export function tidy(value: number, digits = 5): string {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e7 || size < 1e-4) return Number(value.toPrecision(digits)).toExponential();
  const rounded = Number(value.toPrecision(digits));
  return String(Math.abs(rounded) < 1e-12 ? 0 : rounded);
}

/** A length [m] to a tenth of a millimetre: contact forces alone indent a pipe by more. */
export function tidyLength(value: number): string {
  return tidy(Number(value.toFixed(4)), 4);
}

export function write(si: number, unit: string, digits = 5): string {
  return `${tidy(fromSi(si, unit), digits)} ${unit}`;
}

/** The value in the other unit system: "16 in" gives "406.4 mm". Empty if there is none. */
export function twin(text: string): string {
  const q = parseQuantity(text);
  if (!q || !q.unit) return '';
  const twinUnit = table[q.unit]?.twin;
  return twinUnit ? write(toSi(q.number, q.unit), twinUnit, 4) : '';
}

/** Value to send for typed text: a bare number takes the previous unit. */
export function complete(typed: string, unit: string): string {
  const q = parseQuantity(typed);
  if (!q || !unit) return typed.trim();
  return q.unit ? `${typed.trim().match(/^[-+]?[\d.]+(?:[eE][-+]?\d+)?/)![0]} ${q.unit}` : `${typed.trim()} ${unit}`;
}

/** The value converted to the unit of another value, if both are of the same kind. */
export function convertLike(text: string, before: string): string {
  const value = parseQuantity(text), old = parseQuantity(before);
  if (!value || !old || value.unit === old.unit || !sameFamily(value.unit, old.unit)) return text;
  return `${tidy(fromSi(toSi(value.number, value.unit), old.unit), 7)} ${old.unit}`;
}
