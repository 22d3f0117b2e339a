// Boxes as a row on an arc, as the program places them (model/vessel/box_row.cpp): numbers to look at before they are
// written, and the changes that write them as a row or as a list.
import type { Change, Field } from '../api/types';
import { parseQuantity, tidy, toSi, fromSi, sameFamily } from './units';

/** Lengths in m, `incline` in rad, positive where it dips astern. */
export interface ArcPlace { x: number; z: number; incline: number }

export function alongArc(from: ArcPlace, radius: number, distance: number): ArcPlace {
  const turn = distance / radius, half = turn / 2;
  const chord = half === 0 ? distance : (distance * Math.sin(half)) / half;
  const along = from.incline + half;
  return { x: from.x + chord * Math.cos(along), z: from.z - chord * Math.sin(along), incline: from.incline + turn };
}

export const arcBoxes = (first: ArcPlace, radius: number, spacing: number, count: number): ArcPlace[] =>
  Array.from({ length: count }, (_none, i) => alongArc(first, radius, i * spacing));

type Point = { x: number; z: number };
const dip = (a: Point, b: Point): number => Math.atan2(a.z - b.z, b.x - a.x);

/** Direction at the last of some boxes: that of the circle through the last three. */
export function lastIncline(boxes: Point[], fallback: number): number {
  const [a, b, c] = boxes.slice(-3);
  if (!b) return fallback;
  if (!c) return dip(a!, b);
  return dip(b, c) + (dip(a!, c) - dip(a!, b));
}

export interface ArcWish { radius: string; count: string; spacing: string; length: string; x: string; z: string; incline: string }
export interface ArcFault { key: keyof ArcWish; text: string }

const lengthIn = (text: string): number | null => {
  const q = parseQuantity(text);
  return q && q.unit && sameFamily(q.unit, 'm') ? toSi(q.number, q.unit) : null;
};

function angleIn(text: string): number | null {
  const q = parseQuantity(text);
  return q && sameFamily(q.unit, 'rad') ? toSi(q.number, q.unit) : null;
}

/** End of the ramp: its last box with the direction of its curve there; null without listed boxes. */
export function rampEnd(byPath: Map<string, Field>): ArcPlace | null {
  const si = (path: string): number | null => byPath.get(path)?.si ?? null;
  const fallback = si('tensioner.incline') ?? 0;
  const list = byPath.get('supports.ramp.boxes');
  if (list?.kind === 'map') return rowEnd(si, fallback);
  const boxes: Point[] = [];
  for (let i = 0; i < (list?.count ?? 0); ++i) {
    const x = si(`supports.ramp.boxes[${i}].x`), z = si(`supports.ramp.boxes[${i}].z`);
    if (x === null || z === null) return null;
    boxes.push({ x, z });
  }
  const last = boxes.at(-1);
  return last ? { ...last, incline: si(`supports.ramp.boxes[${boxes.length - 1}].incline`) ?? lastIncline(boxes, fallback) } : null;
}

function rowEnd(si: (path: string) => number | null, fallback: number): ArcPlace | null {
  const row = 'supports.ramp.boxes', radius = si('supports.ramp.radius');
  const x = si(`${row}.first.x`), z = si(`${row}.first.z`), count = si(`${row}.count`), spacing = si(`${row}.spacing`);
  if (radius === null || x === null || z === null || count === null || spacing === null) return null;
  return alongArc({ x, z, incline: si(`${row}.first.incline`) ?? fallback }, radius, (count - 1) * spacing);
}

export function arcFaults(wish: ArcWish, end: ArcPlace | null): ArcFault[] {
  const faults: ArcFault[] = [];
  const positive = (key: 'radius' | 'spacing'): void => {
    const value = lengthIn(wish[key]);
    if (value === null || value <= 0) faults.push({ key, text: 'A length above 0, like “120 m”.' });
  };
  positive('radius');
  positive('spacing');
  if (!/^\d+$/.test(wish.count.trim()) || Number(wish.count) < 1 || Number(wish.count) > 1000) faults.push({ key: 'count', text: 'A whole number from 1 to 1000.' });
  if (wish.length.trim() && lengthIn(wish.length) === null) faults.push({ key: 'length', text: 'A length, like “4 m”.' });
  const placed = [wish.x, wish.z].filter((text) => text.trim()).length;
  for (const key of ['x', 'z'] as const) {
    if (wish[key].trim() ? lengthIn(wish[key]) === null : placed === 1 || !end) faults.push({ key, text: 'A length, like “5 m”.' });
  }
  if (wish.incline.trim() && angleIn(wish.incline) === null) faults.push({ key: 'incline', text: 'An angle, like “15 deg”.' });
  return faults;
}

/** First box of the row: given, or one spacing behind the end of the ramp. */
function firstPlace(wish: ArcWish, end: ArcPlace | null): ArcPlace | null {
  const radius = lengthIn(wish.radius), spacing = lengthIn(wish.spacing), x = lengthIn(wish.x), z = lengthIn(wish.z), incline = angleIn(wish.incline);
  if (x !== null && z !== null) return { x, z, incline: incline ?? end?.incline ?? 0 };
  return end && radius && spacing ? alongArc(end, radius, spacing) : null;
}

/** The boxes of a wish without faults. */
export function wishedBoxes(wish: ArcWish, end: ArcPlace | null): ArcPlace[] {
  const first = firstPlace(wish, end), radius = lengthIn(wish.radius), spacing = lengthIn(wish.spacing);
  return first && radius && spacing ? arcBoxes(first, radius, spacing, Number(wish.count)) : [];
}

/** What the model says of a row, or a beginning for one that is not there. */
export function wishFrom(byPath: Map<string, Field>, structure: string): ArcWish {
  const text = (path: string, other = ''): string => String(byPath.get(`${structure}.${path}`)?.value ?? other);
  const count = byPath.get(`${structure}.boxes`)?.count;
  return {
    radius: text('radius', '120 m'), count: text('boxes.count', String(count || 8)), spacing: text('boxes.spacing', '4 m'),
    length: text('boxes.length', text('boxes[0].length')), x: text('boxes.first.x'), z: text('boxes.first.z'), incline: text('boxes.first.incline'),
  };
}

/** The boxes as a row: the radius stays a key that can be varied. */
export function rowChanges(structure: string, wish: ArcWish): Change[] {
  const first = wish.x.trim() ? { first: { x: wish.x, z: wish.z, ...(wish.incline.trim() ? { incline: wish.incline } : {}) } } : {};
  const length = wish.length.trim() ? { length: wish.length } : {};
  return [
    { path: `${structure}.boxes`, value: { count: Number(wish.count), spacing: wish.spacing, ...length, ...first } },
    { path: `${structure}.radius`, value: wish.radius },
  ];
}

/** The same written out: every box with its place, in the unit of the radius. */
export function writtenOut(structure: string, wish: ArcWish, boxes: ArcPlace[], hasRadius: boolean): Change[] {
  const unit = parseQuantity(wish.radius)!.unit;
  const text = (metres: number): string => `${tidy(Number(fromSi(metres, unit).toFixed(4)), 9)} ${unit}`;
  const length = wish.length.trim() ? { length: wish.length } : {};
  const items = boxes.map((box) => ({ x: text(box.x), z: text(box.z), ...length }));
  return [
    { path: `${structure}.boxes`, value: null },
    ...items.map((value, i) => ({ path: `${structure}.boxes[${i}]`, value })),
    ...(hasRadius ? [{ path: `${structure}.radius`, value: null }] : []),
  ];
}
