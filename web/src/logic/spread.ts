// A mooring spread from a few inputs, and its changes to the model.
import type { Change } from '../api/types';
import { parseQuantity, toSi, tidy } from './units';

export interface SpreadRequest {
  count: number;
  /** Angles from the bow of one side, in deg, bow to stern; the other side is its mirror image. */
  angles: number[];
  distance: string;
  kind: 'wire' | 'fibre' | 'chain';
  diameter: string;
  tension: string;
  winch: boolean;
}

/** Default angles from the bow of one side: two ahead, two astern, the others evenly between them. */
export function usualAngles(count: number): number[] {
  const side = count / 2;
  if (side === 2) return [45, 135];
  if (side === 3) return [30, 90, 150];
  if (side === 4) return [25, 65, 115, 155];
  return Array.from({ length: side }, (_, i) => Math.round(20 + (140 * i) / (side - 1)));
}

export const spreadCounts = [4, 6, 8, 10, 12] as const;

/** Null if the text does not give this number of angles between 0 and 180 deg, ascending. */
export function parseAngles(text: string, count: number): number[] | null {
  const list = text.split(/[,;\s]+/).filter(Boolean).map(Number);
  const good = list.length === count / 2 && list.every((a, i) => Number.isFinite(a) && a > 0 && a < 180 && (i === 0 || a > list[i - 1]!));
  return good ? list : null;
}

/** "bow", "forward breast": numbered if several are the same. */
export function lineNames(angles: readonly number[]): string[] {
  const word = (a: number): string => (a < 45 ? 'bow' : a <= 90 ? 'forward breast' : a <= 135 ? 'aft breast' : 'stern');
  const labels = angles.map(word);
  return labels.map((w, i) => (labels.filter((x) => x === w).length > 1 ? `${w} ${labels.slice(0, i + 1).filter((x) => x === w).length}` : w));
}

const metres = (v: number): string => `${tidy(Number(v.toFixed(2)), 6)} m`;

export interface SpreadHull { length: number; beam: number; freeboard: number }

export type SpreadError = { key: keyof SpreadRequest; text: string };

/** Errors of the inputs, by key. */
export function findSpreadErrors(request: SpreadRequest, typedAngles: string): SpreadError[] {
  const out: SpreadError[] = [];
  const above = (key: 'distance' | 'diameter' | 'tension', unit: string, example: string): void => {
    const q = parseQuantity(request[key]), si = q ? toSi(q.number, q.unit || unit) : Number.NaN;
    if (!(si > 0)) out.push({ key, text: `Enter a value above zero, for example ${example}.` });
  };
  if (!parseAngles(typedAngles, request.count)) out.push({ key: 'angles', text: `${request.count / 2} angles from the bow, between 0 and 180 deg, in ascending order.` });
  above('distance', 'm', '1000 m');
  above('diameter', 'mm', '64 mm');
  above('tension', 'kN', '300 kN');
  return out;
}

const withUnit = (text: string, unit: string): string => { const q = parseQuantity(text); return q && !q.unit ? `${text.trim()} ${unit}` : text.trim(); };

/** Name of the type in the model. */
export const typeName = (request: SpreadRequest): string => `${request.kind === 'chain' ? 'chain' : request.kind === 'fibre' ? 'fibre-core' : 'wire'}-${withUnit(request.diameter, 'mm').replace(/[^\w.]+/g, '')}`;

/** Changes to the model: type and winch unless they are `known` by path, and the lines, which replace the present ones. */
export function spreadChanges(request: SpreadRequest, hull: SpreadHull, known: (path: string) => boolean = () => false): Change[] {
  const type = typeName(request);
  const diameter = withUnit(request.diameter, 'mm');
  const material = request.kind === 'chain' ? { chain: { diameter, link: 'studless' } } : { wire_rope: { diameter, core: request.kind === 'fibre' ? 'fibre' : 'wire' } };
  const names = lineNames(request.angles);
  const line = (i: number, side: 'port' | 'starboard'): Record<string, unknown> => {
    const angle = request.angles[i]!;
    // from the corner at its end of the vessel, at deck level, slightly inboard
    const x = (angle <= 90 ? 1 : -1) * (hull.length / 2 - 0.025 * hull.length), y = (side === 'port' ? 1 : -1) * hull.beam / 2;
    return {
      name: `${side} ${names[i]}`, fairlead: { x: metres(x), y: metres(y), z: metres(0.8 * hull.freeboard) },
      bearing: `${side === 'port' ? 360 - angle : angle} deg`, anchor_distance: withUnit(request.distance, 'm'), type,
      ...(request.winch ? { winch: 'main' } : {}), tension: withUnit(request.tension, 'kN'),
    };
  };
  const count = request.angles.length;
  // anticlockwise from the port bow
  const lines = [...Array.from({ length: count }, (_, i) => line(i, 'port')), ...Array.from({ length: count }, (_, i) => line(count - 1 - i, 'starboard'))];
  return [
    ...[{ path: `moorings.types.${type}`, value: material }, ...(request.winch ? [{ path: 'moorings.winches.main', value: { speed: '0.2 m/s' } }] : [])].filter((c) => !known(c.path)),
    { path: 'moorings.lines', value: null },
    ...lines.map((value, i) => ({ path: `moorings.lines[${i}]`, value })),
  ];
}
