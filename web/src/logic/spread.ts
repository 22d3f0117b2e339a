// A spread of mooring lines from a few answers: what is written into the model.
import type { Change } from '../api/types';
import { parseQuantity, toSi, tidy } from './units';

export interface SpreadWish {
  count: number;
  /** Angles from the bow of one side, in deg, bow to stern; the other side is its mirror image. */
  angles: number[];
  distance: string;
  kind: 'wire' | 'fibre' | 'chain';
  diameter: string;
  tension: string;
  winch: boolean;
}

/** Angles from the bow of one side for so many lines: two ahead, two astern, the others abeam between them. */
export function usualAngles(count: number): number[] {
  const side = count / 2;
  if (side === 2) return [45, 135];
  if (side === 3) return [30, 90, 150];
  if (side === 4) return [25, 65, 115, 155];
  return Array.from({ length: side }, (_, i) => Math.round(20 + (140 * i) / (side - 1)));
}

export const spreadCounts = [4, 6, 8, 10, 12] as const;

/** Null where the text does not hold so many angles between 0 and 180 deg, rising. */
export function parseAngles(text: string, count: number): number[] | null {
  const list = text.split(/[,;\s]+/).filter(Boolean).map(Number);
  const good = list.length === count / 2 && list.every((a, i) => Number.isFinite(a) && a > 0 && a < 180 && (i === 0 || a > list[i - 1]!));
  return good ? list : null;
}

/** "bow", "forward breast": told apart by number where several have the same. */
export function lineNames(angles: readonly number[]): string[] {
  const word = (a: number): string => (a < 45 ? 'bow' : a <= 90 ? 'forward breast' : a <= 135 ? 'aft breast' : 'stern');
  const words = angles.map(word);
  return words.map((w, i) => (words.filter((x) => x === w).length > 1 ? `${w} ${words.slice(0, i + 1).filter((x) => x === w).length}` : w));
}

const metres = (v: number): string => `${tidy(Number(v.toFixed(2)), 6)} m`;

export interface SpreadHull { length: number; beam: number; freeboard: number }

export type SpreadFault = { key: keyof SpreadWish; text: string };

/** What is wrong with an answer, by its key. */
export function spreadFaults(wish: SpreadWish, typedAngles: string): SpreadFault[] {
  const out: SpreadFault[] = [];
  const above = (key: 'distance' | 'diameter' | 'tension', unit: string, example: string): void => {
    const q = parseQuantity(wish[key]), si = q ? toSi(q.number, q.unit || unit) : Number.NaN;
    if (!(si > 0)) out.push({ key, text: `Above zero, like "${example}".` });
  };
  if (!parseAngles(typedAngles, wish.count)) out.push({ key: 'angles', text: `${wish.count / 2} angles from the bow, between 0 and 180 deg, rising.` });
  above('distance', 'm', '1000 m');
  above('diameter', 'mm', '64 mm');
  above('tension', 'kN', '300 kN');
  return out;
}

const withUnit = (text: string, unit: string): string => { const q = parseQuantity(text); return q && !q.unit ? `${text.trim()} ${unit}` : text.trim(); };

/** The type's name in the model. */
export const typeName = (wish: SpreadWish): string => `${wish.kind === 'chain' ? 'chain' : wish.kind === 'fibre' ? 'fibre-core' : 'wire'}-${withUnit(wish.diameter, 'mm').replace(/[^\w.]+/g, '')}`;

/** What is written: type and winch if they are not `known` by their paths, and the lines in the place of those that were there. */
export function spreadChanges(wish: SpreadWish, hull: SpreadHull, known: (path: string) => boolean = () => false): Change[] {
  const type = typeName(wish);
  const diameter = withUnit(wish.diameter, 'mm');
  const material = wish.kind === 'chain' ? { chain: { diameter, link: 'studless' } } : { wire_rope: { diameter, core: wish.kind === 'fibre' ? 'fibre' : 'wire' } };
  const names = lineNames(wish.angles);
  const line = (i: number, side: 'port' | 'starboard'): Record<string, unknown> => {
    const angle = wish.angles[i]!;
    // from the corner at its end of the ship, at deck level, a little inside the hull's ends
    const x = (angle <= 90 ? 1 : -1) * (hull.length / 2 - 0.025 * hull.length), y = (side === 'port' ? 1 : -1) * hull.beam / 2;
    return {
      name: `${side} ${names[i]}`, fairlead: { x: metres(x), y: metres(y), z: metres(0.8 * hull.freeboard) },
      bearing: `${side === 'port' ? 360 - angle : angle} deg`, anchor_distance: withUnit(wish.distance, 'm'), type,
      ...(wish.winch ? { winch: 'main' } : {}), tension: withUnit(wish.tension, 'kN'),
    };
  };
  const count = wish.angles.length;
  // anticlockwise from the port bow
  const lines = [...Array.from({ length: count }, (_, i) => line(i, 'port')), ...Array.from({ length: count }, (_, i) => line(count - 1 - i, 'starboard'))];
  return [
    ...[{ path: `moorings.types.${type}`, value: material }, ...(wish.winch ? [{ path: 'moorings.winches.main', value: { speed: '0.2 m/s' } }] : [])].filter((c) => !known(c.path)),
    { path: 'moorings.lines', value: null },
    ...lines.map((value, i) => ({ path: `moorings.lines[${i}]`, value })),
  ];
}
