// Boxes in a row on an arc, placed as in the program (model/vessel): a preview before they are
// written, and the changes that write them as a row or as a list.
import type { Change, Field } from '../api/types';
import { parseQuantity, tidy, toSi, fromSi, sameFamily } from './units';

/** Lengths in m, `incline` in rad, positive downwards astern. */
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

/** Direction at the last box: tangent of the circle through the last three. */
export function lastIncline(boxes: Point[], fallback: number): number {
  const [a, b, c] = boxes.slice(-3);
  if (!b) return fallback;
  if (!c) return dip(a!, b);
  return dip(b, c) + (dip(a!, c) - dip(a!, b));
}

export interface ArcRequest { radius: string; count: string; spacing: string; length: string; x: string; z: string; incline: string }
export interface ArcError { key: keyof ArcRequest; text: string }

const lengthIn = (text: string): number | null => {
  const q = parseQuantity(text);
  return q && q.unit && sameFamily(q.unit, 'm') ? toSi(q.number, q.unit) : null;
};

function angleIn(text: string): number | null {
  const q = parseQuantity(text);
  return q && sameFamily(q.unit, 'rad') ? toSi(q.number, q.unit) : null;
}

/** End of the ramp: its last box with the direction of its curve; null without listed boxes. */
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

export function findArcErrors(request: ArcRequest, end: ArcPlace | null): ArcError[] {
  const errors: ArcError[] = [];
  const positive = (key: 'radius' | 'spacing'): void => {
    const value = lengthIn(request[key]);
    if (value === null || value <= 0) errors.push({ key, text: 'Enter a length above 0, for example 120 m.' });
  };
  positive('radius');
  positive('spacing');
  if (!/^\d+$/.test(request.count.trim()) || Number(request.count) < 1 || Number(request.count) > 1000) errors.push({ key: 'count', text: 'Enter a whole number from 1 to 1000.' });
  if (request.length.trim() && lengthIn(request.length) === null) errors.push({ key: 'length', text: 'Enter a length, for example 4 m.' });
  const placed = [request.x, request.z].filter((text) => text.trim()).length;
  for (const key of ['x', 'z'] as const) {
    if (request[key].trim() ? lengthIn(request[key]) === null : placed === 1 || !end) errors.push({ key, text: 'Enter a length, for example 5 m.' });
  }
  if (request.incline.trim() && angleIn(request.incline) === null) errors.push({ key: 'incline', text: 'Enter an angle, for example 15 deg.' });
  return errors;
}

/** First box of the row: given, or one spacing behind the end of the ramp. */
function firstPlace(request: ArcRequest, end: ArcPlace | null): ArcPlace | null {
  const radius = lengthIn(request.radius), spacing = lengthIn(request.spacing), x = lengthIn(request.x), z = lengthIn(request.z), incline = angleIn(request.incline);
  if (x !== null && z !== null) return { x, z, incline: incline ?? end?.incline ?? 0 };
  return end && radius && spacing ? alongArc(end, radius, spacing) : null;
}

/** Boxes of a request without errors. */
export function generatedBoxes(request: ArcRequest, end: ArcPlace | null): ArcPlace[] {
  const first = firstPlace(request, end), radius = lengthIn(request.radius), spacing = lengthIn(request.spacing);
  return first && radius && spacing ? arcBoxes(first, radius, spacing, Number(request.count)) : [];
}

/** Row of the model, or default values if there is none. */
export function readArcRequest(byPath: Map<string, Field>, structure: string): ArcRequest {
  const text = (path: string, fallback = ''): string => String(byPath.get(`${structure}.${path}`)?.value ?? fallback);
  const count = byPath.get(`${structure}.boxes`)?.count;
  return {
    radius: text('radius', '120 m'), count: text('boxes.count', String(count || 8)), spacing: text('boxes.spacing', '4 m'),
    length: text('boxes.length', text('boxes[0].length')), x: text('boxes.first.x'), z: text('boxes.first.z'), incline: text('boxes.first.incline'),
  };
}

/** The boxes as a row: the radius remains a key that can be varied. */
export function rowChanges(structure: string, request: ArcRequest): Change[] {
  const first = request.x.trim() ? { first: { x: request.x, z: request.z, ...(request.incline.trim() ? { incline: request.incline } : {}) } } : {};
  const length = request.length.trim() ? { length: request.length } : {};
  return [
    { path: `${structure}.boxes`, value: { count: Number(request.count), spacing: request.spacing, ...length, ...first } },
    { path: `${structure}.radius`, value: request.radius },
  ];
}

/** The boxes as a list: each with its position, in the unit of the radius. */
export function writtenOut(structure: string, request: ArcRequest, boxes: ArcPlace[], hasRadius: boolean): Change[] {
  const unit = parseQuantity(request.radius)!.unit;
  const text = (metres: number): string => `${tidy(Number(fromSi(metres, unit).toFixed(4)), 9)} ${unit}`;
  const length = request.length.trim() ? { length: request.length } : {};
  const items = boxes.map((box) => ({ x: text(box.x), z: text(box.z), ...length }));
  return [
    { path: `${structure}.boxes`, value: null },
    ...items.map((value, i) => ({ path: `${structure}.boxes[${i}]`, value })),
    ...(hasRadius ? [{ path: `${structure}.radius`, value: null }] : []),
  ];
}
