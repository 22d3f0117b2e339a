// Numbers of the model that can be varied: every numeric key, and a few variables that set several keys together.
import type { Field } from '../api/types';
import { label, parts } from './formTree';
import type { LiveBase } from './live';
import { parseQuantity, tidy, toSi } from './units';

/** The part of a form field that is needed here. */
export type NumericField = Pick<Field, 'path' | 'si'> & Partial<Pick<Field, 'kind' | 'unit' | 'value' | 'default' | 'given' | 'range'>>;

/** Variables that set several keys: no path contains a blank. */
export const stingerRadius = 'stinger radius';
export const currentFactor = 'current factor';
export const boxHeight = 'box height';

export interface Variable {
  /** Path of the key, or the name of a variable that sets several. */
  id: string;
  name: string;
  /** Unit in the model; empty for plain numbers. */
  unit: string;
  /** SI value of one unit. */
  scale: number;
  /** Value of the model, SI. */
  si: number;
  integer: boolean;
  /** Bounds of the key, SI; an `open` bound is itself excluded. */
  min: number;
  max: number;
  openMin: boolean;
  openMax: boolean;
}

type Bounds = Pick<Variable, 'min' | 'max' | 'openMin' | 'openMax'>;
const unbounded: Bounds = { min: -Infinity, max: Infinity, openMin: false, openMax: false };

/** Reads a range in the notation of the program: "above 0 m and at most 12000 m" or "from 0 to 10". */
export function readBounds(range: string | undefined, scale: number): Bounds {
  const low = /(from|at least|above) (-?[\d.e+-]+)/.exec(range ?? ''), high = /(to|at most|below) (-?[\d.e+-]+)/.exec(range ?? '');
  return {
    min: low ? Number(low[2]) * scale : -Infinity,
    max: high ? Number(high[2]) * scale : Infinity,
    openMin: low?.[1] === 'above',
    openMax: high?.[1] === 'below',
  };
}

const names: Record<string, string> = {
  'tensioner.tension': 'tension',
  'environment.water_depth': 'water depth',
  'vessel.trim': 'trim',
};

function item(path: string, fields: ReadonlyMap<string, NumericField>): string {
  const list = parts(path);
  const place = list.findLastIndex((part) => part.startsWith('['));
  if (place < 1) return '';
  const owner = list.slice(0, place + 1).join('.').replaceAll('.[', '[');
  const given = fields.get(`${owner}.name`)?.value;
  if (given) return String(given);
  const group = list[place - 1] === 'boxes' ? list[place - 2] ?? 'box' : list[place - 1]!;
  return `${label(group)} ${label(list[place]!)}`;
}

/** A short name: "tension", "wall thickness", "stinger 3 z", "waves Hs". */
export function variableName(path: string, fields: ReadonlyMap<string, NumericField>): string {
  const known = names[path];
  if (known) return known;
  if (path === 'tensioner.incline' && (fields.get(path)?.si ?? 0) > Math.PI / 4) return 'tower angle';
  const list = parts(path), last = list.at(-1)!;
  const owner = item(path, fields);
  if (owner) return last.startsWith('[') ? owner : `${owner} ${label(last)}`;
  return last.includes('_') || list.length < 2 ? label(last) : `${label(list.at(-2)!)} ${label(last)}`;
}

const numeric = (field: NumericField): boolean => field.kind === 'quantity' || field.kind === 'number' || field.kind === 'integer';

/** Null if the key has no number, neither given nor as its default. */
export function keyVariable(field: NumericField | undefined, fields: ReadonlyMap<string, NumericField>): Variable | null {
  if (!field || !numeric(field)) return null;
  const written = parseQuantity(String(field.value ?? field.default ?? ''));
  if (!written) return null;
  const unit = field.kind === 'quantity' ? written.unit || field.unit || '' : '';
  const listed = unit ? toSi(1, unit) : 1;
  const scale = Number.isFinite(listed) ? listed : field.si !== null && written.number !== 0 ? field.si / written.number : Number.NaN;
  if (!Number.isFinite(scale) || scale === 0) return null;
  const si = field.si ?? written.number * scale;
  // bounds are in the usual unit of the key, which can differ from that in the model
  const usual = field.unit && field.unit !== unit ? toSi(1, field.unit) : scale;
  const bounds = Number.isFinite(usual) ? readBounds(field.range, usual) : unbounded;
  return { id: field.path, name: variableName(field.path, fields), unit, scale, si, integer: field.kind === 'integer', ...bounds };
}

export function findVariable(id: string, base: LiveBase): Variable | null {
  const plain = { id, name: id, unit: 'm', scale: 1, integer: false, ...unbounded };
  if (id === stingerRadius) return base.radius === null ? null : { ...plain, min: 0, openMin: true, si: base.radius };
  if (id === boxHeight) return base.boxes.some((box) => box.structure === 'stinger') ? { ...plain, name: 'stinger height', si: 0 } : null;
  if (id === currentFactor) return base.current.length ? { ...plain, name: 'current', unit: '%', scale: 0.01, si: 1, min: 0 } : null;
  return keyVariable(base.fields.get(id), base.fields);
}

export const variableText = (variable: Variable, si: number, digits = 5): string => `${tidy(si / variable.scale, digits)} ${variable.unit}`.trimEnd();

const smallest: Record<string, number> = { m: 0.01, mm: 0.1, deg: 0.05, kN: 1, '%': 1, ft: 0.02, in: 0.01 };
const isPlace = (id: string): boolean => id === boxHeight || /\.(x|y|z|offset)$/.test(id);

/** Step of one pixel or one arrow key, in the unit of the variable: a hundredth of the leading decimal place. */
export function variableStep(variable: Variable): number {
  if (variable.integer) return 1;
  const number = Math.abs(variable.si / variable.scale);
  if (number === 0 || isPlace(variable.id) || variable.unit === 'deg') return smallest[variable.unit] ?? 0.01;
  return 10 ** (Math.floor(Math.log10(number) + 1e-9) - 2);
}

type Keys = Pick<KeyboardEvent, 'shiftKey' | 'altKey'>;
export type Pace = 'fine' | 'usual' | 'coarse';
export const paceFactor: Record<Pace, number> = { fine: 0.1, usual: 1, coarse: 10 };
export const pace = (event: Keys): Pace => (event.shiftKey ? 'coarse' : event.altKey ? 'fine' : 'usual');

/** Rounds values to whole steps, also for coarse movements. */
export const gridStep = (variable: Variable, keys: Keys): number => variableStep(variable) * (pace(keys) === 'fine' ? paceFactor.fine : 1);

/** The nearest SI value on whole steps, within the bounds of the key. */
export function onStep(variable: Variable, si: number, step: number): number {
  const { scale, integer, min, max, openMin, openMax } = variable;
  const grid = integer ? Math.max(1, Math.round(step)) : step;
  const low = min / scale + (openMin ? grid : 0), high = max / scale - (openMax ? grid : 0);
  const number = Math.min(high, Math.max(low, Math.round(si / scale / grid) * grid));
  return Number(number.toPrecision(10)) * scale;
}

/** Slider range about the value of the model, SI. */
export function variableEnds(variable: Variable): [number, number] {
  const { id, si, scale, unit } = variable;
  if (id === currentFactor) return [0, 2];
  if (id === boxHeight) return [-0.5, 0.5];
  if (isPlace(id)) return [si - 1, si + 1];
  const number = si / scale;
  if (number === 0) return unit === 'deg' ? [-2 * scale, 2 * scale] : [0, 100 * (smallest[unit] ?? 0.01) * scale];
  if (unit === 'deg') return [Math.floor(number - 5) * scale, Math.ceil(number + 5) * scale];
  const [low, high] = id === 'tensioner.tension' ? [0.4, 2.5] : id === 'environment.water_depth' ? [0.5, 1.6] : [0.6, 2];
  const ends = roundEnds(number, low, high);
  return [ends[0] * scale, ends[1] * scale];
}

/** Round numbers at these multiples of a value. */
export function roundEnds(value: number, low: number, high: number): [number, number] {
  const size = Math.abs(value), step = 10 ** Math.floor(Math.log10(size) + 1e-9) / 2;
  const near = Math.max(step / 10, size * low < step ? size * low : Math.floor((size * low) / step) * step);
  const far = Math.ceil((size * high) / step) * step;
  const round = (v: number): number => Number(v.toPrecision(6));
  return value < 0 ? [-round(far), -round(near)] : [round(near), round(far)];
}

/** Numeric keys of the model, for the search. */
export const variableFields = <F extends NumericField>(fields: readonly F[]): F[] => fields.filter((field) => numeric(field) && (field.given || field.default !== null));

/** Default sliders: the keys that are usually varied in this kind of model. */
export function usualVariables(base: LiveBase): string[] {
  const given = (path: string): boolean => base.fields.get(path)?.si != null && base.fields.get(path)?.given !== false;
  const first = (...paths: string[]): string[] => paths.filter(given).slice(0, 1);
  if (given('tensioner.tension')) {
    const incline = base.fields.get('tensioner.incline')?.si ?? 0;
    const curve = given('supports.stinger.radius') ? ['supports.stinger.radius'] : base.radius !== null ? [stingerRadius] : first('supports.stinger.angle');
    return ['tensioner.tension', ...first('environment.water_depth'), ...(incline > Math.PI / 4 ? ['tensioner.incline'] : curve)];
  }
  return [
    ...first('environment.water_depth'),
    ...(base.current.length ? [currentFactor] : []),
    ...first('moorings.lines[0].length', 'moorings.lines[0].tension', 'moorings.lines[0].anchor_distance'),
    ...first('lines[0].length', 'lines[0].segments[0].length'),
  ];
}
