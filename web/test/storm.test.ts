import { expect, test } from 'vitest';
import {
  directionText, expectedSeconds, firstRange, firstStorm, hullDiffers, libraryHull, missingInStorm, modelSeeds, motionText, seaText, seconds, seedsTyped, seedsValue, tensionerText, waveSide,
  type Known,
} from '../src/logic/storm';

const model = (values: Record<string, string | number | Known>): Map<string, Known> =>
  new Map(Object.entries(values).map(([path, value]) => [path, typeof value === 'object' ? value : { given: true, value, si: typeof value === 'number' ? value : null }]));
const rad = Math.PI / 180;

test('a sea is named by its spectrum and its values, a regular wave by height and period', () => {
  expect(seaText(model({ 'environment.waves.type': 'jonswap', 'environment.waves.hs': '4 m', 'environment.waves.tp': '12.9 s' }))).toBe('JONSWAP, Hs 4 m, Tp 12.9 s');
  expect(seaText(model({ 'environment.waves.type': 'airy', 'environment.waves.height': '3 m', 'environment.waves.period': '9 s' }))).toBe('Airy wave, H 3 m, T 9 s');
  expect(seaText(model({ 'environment.waves.type': 'none' }))).toBe('no waves');
  expect(seaText(model({}))).toBe('');
});

const windSeaAndSwell = model({
  'environment.waves': { given: true, count: 2 },
  'environment.waves[0].type': 'jonswap', 'environment.waves[0].hs': '2.2 m', 'environment.waves[0].tz': '5.7 s',
  'environment.waves[0].from': { given: true, value: '240 deg', si: 240 * rad }, 'environment.waves[0].seed': 7,
  'environment.waves[1].type': 'airy', 'environment.waves[1].height': '1 m', 'environment.waves[1].period': '13 s',
  'environment.waves[1].from': { given: true, value: '300 deg', si: 300 * rad },
  'vessel.heading': { given: true, value: '240 deg', si: 240 * rad },
});

test('several groups of waves are named one after the other, with their directions', () => {
  expect(seaText(windSeaAndSwell)).toBe('JONSWAP, Hs 2.2 m, Tz 5.7 s; Airy wave, H 1 m, T 13 s');
  expect(directionText(windSeaAndSwell)).toBe('240 deg, bow; 300 deg, starboard bow');
  expect(modelSeeds(windSeaAndSwell)).toEqual([7]);
  expect(missingInStorm(windSeaAndSwell)).not.toContain('waves');
});

test('groups of waves that are all none are no waves', () => {
  const none = model({ 'environment.waves': { given: true, count: 1 }, 'environment.waves[0].type': 'none' });
  expect(missingInStorm(none)).toContain('waves');
  expect(directionText(none)).toBe('');
});

test('other spectra and measured elevations are named', () => {
  expect(seaText(model({ 'environment.waves.type': 'torsethaugen', 'environment.waves.hs': '4 m', 'environment.waves.tp': '9 s' }))).toBe('Torsethaugen, Hs 4 m, Tp 9 s');
  expect(seaText(model({ 'environment.waves.type': 'elevation', 'environment.waves.elevation_file': 'eta.csv' }))).toBe('measured elevation, eta.csv');
  expect(seaText(model({ 'environment.waves.type': 'jonswap', 'environment.waves.spectrum_file': '46990.txt' }))).toBe('JONSWAP, 46990.txt');
});

test('the side of the waves counts from the bow', () => {
  const side = (from: number, heading: number): string => waveSide(from * rad, heading * rad);
  expect(side(90, 90)).toBe('bow');
  expect(side(180, 90)).toBe('starboard beam');
  expect(side(0, 90)).toBe('port beam');
  expect(side(270, 90)).toBe('stern');
  expect(side(350, 20)).toBe('port bow');
  expect(side(150, 0)).toBe('starboard quarter');
});

test('the direction is written as in the model with its side', () => {
  const fields = model({ 'environment.waves.type': 'jonswap', 'environment.waves.from': { given: true, value: '180 deg', si: Math.PI }, 'vessel.heading': { given: true, value: '90 deg', si: Math.PI / 2 } });
  expect(directionText(fields)).toBe('180 deg, starboard beam');
  expect(directionText(model({}))).toBe('');
});

test('a library hull is named with its dimensions', () => {
  expect(libraryHull('box-hull-118.5x29m.csv')).toEqual({ length: 118.5, beam: 29 });
  expect(libraryHull('data/bgl1/rao.csv')).toBeNull();
  const scaled = { 'vessel.motion.raos': 'box-hull-120x30m.csv', 'vessel.length': 120, 'vessel.beam': 30 };
  expect(motionText(model(scaled))).toEqual({ text: 'library hull', note: 'RAOs of a box hull of 120 × 30 m scaled from BGL-1: an assumption.' });
  expect(hullDiffers(model(scaled))).toBe(false);
  expect(motionText(model({ ...scaled, 'vessel.length': 130 })).note).toBe('Library hull of 120 × 30 m: the vessel has other dimensions.');
  expect(motionText(model({ 'vessel.motion.raos': 'data/bgl1/rao.csv' }))).toEqual({ text: 'RAO file, rao.csv' });
  expect(motionText(model({ 'vessel.motion': 'fixed' }))).toEqual({ text: 'fixed' });
});

test('a tensioner is named by its range, or by its mode without one', () => {
  expect(tensionerText(model({ 'tensioner.range[0]': '200 kN', 'tensioner.range[1]': '300 kN', 'tensioner.tension': '250 kN' })).text).toBe('200 … 300 kN');
  expect(tensionerText(model({ 'tensioner.mode': 'locked', 'tensioner.tension': '250 kN' })).text).toBe('250 kN, locked');
  const constant = tensionerText(model({ 'tensioner.tension': '250 kN' }));
  expect(constant.text).toBe('250 kN, constant');
  expect(constant.note).toMatch(/Without a range/);
  expect(tensionerText(model({})).text).toBe('');
});

test('the default range is a fifth to either side of the tension', () => {
  expect(firstRange(model({ 'tensioner.tension': '250 kN' }))![0]).toEqual({ path: 'tensioner.range', value: ['200 kN', '300 kN'] });
  expect(firstRange(model({}))).toBeNull();
});

test('seeds are a number or a list', () => {
  expect(seedsValue('10')).toBe(10);
  expect(seedsValue('3, 7-9')).toEqual([3, 7, 8, 9]);
  for (const wrong of ['', '0', 'five', '3, 3']) expect(seedsValue(wrong)).toBeNull();
  expect(seedsTyped([1, 2, 3])).toBe('3');
  expect(seedsTyped([3, 7])).toBe('3, 7');
  expect(modelSeeds(model({ 'analysis.dynamic.seeds': 3 }))).toEqual([1, 2, 3]);
  expect(modelSeeds(model({ 'analysis.dynamic.seeds': { given: true, value: null }, 'analysis.dynamic.seeds[0]': 4, 'analysis.dynamic.seeds[1]': 9 }))).toEqual([4, 9]);
  expect(modelSeeds(model({ 'environment.waves.seed': 5 }))).toEqual([5]);
});

test('a new model gets waves on the bow, the library hull and three hours', () => {
  const fields = model({ vessel: { given: true }, 'vessel.motion': 'fixed', 'vessel.heading': { given: true, value: '90 deg', si: Math.PI / 2 } });
  expect(missingInStorm(fields)).toEqual(['waves', 'vessel motion', 'duration']);
  expect(firstStorm(fields, 'box-hull-120x30m.csv')).toEqual([
    { path: 'environment.waves', value: { type: 'jonswap', hs: '2 m', tp: '8 s', from: '90 deg' } },
    { path: 'vessel.motion', value: { raos: 'box-hull-120x30m.csv' } },
    { path: 'analysis.dynamic', value: { duration: '3 h' } },
  ]);
});

test('a model with a storm keeps its values, also a fixed vessel', () => {
  const fields = model({ vessel: { given: true }, 'vessel.motion': 'fixed', 'environment.waves.type': 'airy', 'analysis.dynamic': { given: true } });
  expect(missingInStorm(fields)).toEqual([]);
  expect(firstStorm(fields, null)).toEqual([]);
});

test('the expected time follows from the pace, and from the seeds that run side by side', () => {
  expect(expectedSeconds({ ratio: 0.01, sideBySide: 3 }, 10800, 10)).toBeCloseTo(432);
  expect(expectedSeconds({ ratio: 0.01, sideBySide: 8 }, 600, 1)).toBeCloseTo(6);
  expect(expectedSeconds(null, 600, 1)).toBeNull();
  expect(seconds('3 h')).toBe(10800);
  expect(seconds('soon')).toBeNaN();
});
