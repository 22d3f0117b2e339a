import { expect, test } from 'vitest';
import { decode, linesBetween } from '../src/logic/frames';

const packed = (numbers: number[]): string => btoa(String.fromCharCode(...new Uint8Array(new Float32Array(numbers).buffer)));
const identity = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
const frames = { total: 2, from: 0, stations: 1, time: [0, 1], pose: [identity, identity], place: packed([0, 0, 0, 0, 0, 0]), effective_tension: packed([1, 1]), von_mises: packed([1, 1]) };

test('lines are found between two frames, each by its name', () => {
  // two lines of one and two points; the second frame a metre further east
  const first = [1, 2, 3, 4, 5, 6, 7, 8, 9], later = first.map((v, i) => (i % 3 === 0 ? v + 1 : v));
  const chunk = decode({ ...frames, lines: [{ name: 'a', points: 1 }, { name: 'b', points: 2 }], line_place: packed([...first, ...later]) });
  const found = linesBetween(chunk, 0, chunk, 1, 0.25)!;
  expect([...found.get('a')!]).toEqual([1.25, 2, 3]);
  expect([...found.get('b')!]).toEqual([4.25, 5, 6, 7.25, 8, 9]);
});

test('a run that recorded no lines has none to show', () => expect(linesBetween(decode(frames), 0, decode(frames), 1, 0.5)).toBeNull());
