// Summary of the storm settings, their default values, and the expected computing time.
import type { Change } from '../api/types';
import { motionKind, motionLabels } from './motion';
import { parseSeeds } from './runs';
import { parseQuantity, tidy, toSi } from './units';
import { waveGroups } from './waves';

export interface Known { given: boolean; value?: unknown; si?: number | null; count?: number }
export type Fields = ReadonlyMap<string, Known>;

const written = (fields: Fields, path: string): string => {
  const field = fields.get(path);
  return field?.given && field.value !== null && field.value !== undefined ? String(field.value) : '';
};
const degrees = 180 / Math.PI;

const seaNames: Record<string, string> = {
  none: 'no waves', airy: 'Airy wave', stokes5: 'Stokes wave', jonswap: 'JONSWAP', pierson_moskowitz: 'Pierson-Moskowitz',
  ochi_hubble: 'Ochi-Hubble', torsethaugen: 'Torsethaugen', user: 'spectrum file', elevation: 'measured elevation',
};
const height: [string, string][] = [['H', 'height'], ['T', 'period']];
const spectral: [string, string][] = [['Hs', 'hs'], ['Tp', 'tp'], ['Tz', 'tz'], ['', 'spectrum_file']];
const seaMembers: Record<string, [string, string][]> = {
  airy: height, stokes5: height, jonswap: spectral, pierson_moskowitz: spectral, torsethaugen: spectral,
  user: [['', 'spectrum_file']], elevation: [['', 'elevation_file']],
};

function groupText(fields: Fields, group: string): string {
  const type = written(fields, `${group}.type`);
  const values = (seaMembers[type] ?? []).map(([name, key]) => [name, written(fields, `${group}.${key}`)] as const).filter(([, value]) => value);
  return [seaNames[type] ?? type, ...values.map(([name, value]) => `${name} ${value}`.trim())].join(', ');
}

/** Groups of waves with a type, "environment.waves", or "environment.waves[0]" and so on. */
const typedGroups = (fields: Fields): string[] => waveGroups(fields).filter((group) => written(fields, `${group}.type`));

/** "JONSWAP, Hs 4 m, Tp 12.9 s", of several groups separated by semicolons; empty if the model has no waves. */
export const seaText = (fields: Fields): string => typedGroups(fields).map((group) => groupText(fields, group)).join('; ');

/** Direction the waves come from, relative to the bow: azimuths in rad, clockwise from north. */
export function waveSide(from: number, heading: number): string {
  const off = (((from - heading) * degrees) % 360 + 360) % 360;
  const away = Math.min(off, 360 - off);
  if (away <= 15) return 'bow';
  if (away >= 165) return 'stern';
  const side = off < 180 ? 'starboard' : 'port';
  if (away >= 75 && away <= 105) return `${side} beam`;
  return `${side} ${away < 90 ? 'bow' : 'quarter'}`;
}

/** "180 deg, port beam"; empty if there are no waves. */
export function directionText(fields: Fields): string {
  const heading = fields.get('vessel.heading')?.si ?? 0;
  return typedGroups(fields).filter((group) => written(fields, `${group}.type`) !== 'none').map((group) => {
    const from = written(fields, `${group}.from`) || '0 deg';
    return `${from}, ${waveSide(fields.get(`${group}.from`)?.si ?? 0, heading)}`;
  }).join('; ');
}

/** Dimensions [m] in the file name of the scaled RAOs of the library hull. */
export function libraryHull(file: string): { length: number; beam: number } | null {
  const match = /(?:^|\/)box-hull-([\d.]+)x([\d.]+)m\.csv$/.exec(file);
  return match ? { length: Number(match[1]), beam: Number(match[2]) } : null;
}

/** True if the library hull was scaled to dimensions other than those of the vessel. */
export function hullDiffers(fields: Fields): boolean {
  const hull = libraryHull(written(fields, 'vessel.motion.raos'));
  const length = fields.get('vessel.length')?.si, beam = fields.get('vessel.beam')?.si;
  if (!hull || typeof length !== 'number' || typeof beam !== 'number') return false;
  return Math.abs(hull.length / length - 1) > 1e-3 || Math.abs(hull.beam / beam - 1) > 1e-3;
}

export interface ItemText { text: string; note?: string }

/** Source of the vessel motion, and a reservation. */
export function motionText(fields: Fields): ItemText {
  const kind = motionKind(fields);
  if (kind === null) return { text: '' };
  const file = written(fields, kind === 'coupled' ? 'vessel.motion.coupled.hydrodynamics' : `vessel.motion.${kind}`);
  const hull = kind === 'raos' ? libraryHull(file) : null;
  if (hull) {
    const size = `${tidy(hull.length)} × ${tidy(hull.beam)} m`;
    const note = hullDiffers(fields) ? `Library hull of ${size}: the vessel has other dimensions.` : `RAOs of a box hull of ${size} scaled from BGL-1: an assumption.`;
    return { text: 'library hull', note };
  }
  return { text: file ? `${motionLabels[kind].replace(/ \(.*/, '')}, ${file.replace(/^.*\//, '')}` : motionLabels[kind] };
}

/** "200 kN … 300 kN, controlled"; empty without a tensioner. */
export function tensionerText(fields: Fields): ItemText {
  const mode = written(fields, 'tensioner.mode'), tension = written(fields, 'tensioner.tension');
  const low = written(fields, 'tensioner.range[0]'), high = written(fields, 'tensioner.range[1]');
  if (mode === 'locked') return { text: tension ? `${tension}, locked` : 'locked' };
  if (mode !== 'constant' && low && high) return { text: rangeText(low, high) };
  if (!tension && !mode) return { text: '' };
  const note = mode ? undefined : 'Without a range the tensioner is ideal: its tension is constant.';
  return { text: [tension, 'constant'].filter(Boolean).join(', '), note };
}

/** Two values, with a single unit if it is the same. */
export function rangeText(low: string, high: string): string {
  const a = parseQuantity(low), b = parseQuantity(high);
  return a && b && a.unit === b.unit ? `${tidy(a.number)} … ${high}` : `${low} … ${high}`;
}

/** Default range: tension ± one fifth, in its unit; null if there is no tension. */
export function firstRange(fields: Fields): Change[] | null {
  const q = parseQuantity(written(fields, 'tensioner.tension'));
  if (!q) return null;
  const side = (factor: number): string => `${tidy(factor * q.number, 3)} ${q.unit}`.trim();
  return [
    { path: 'tensioner.range', value: [side(0.8), side(1.2)] },
    { path: 'tensioner.velocity', value: '0.5 m/s' },
    { path: 'tensioner.mode', value: 'controlled' },
  ];
}

/** Seeds of the model, in order: those listed, or 1 to a number; a single one by default. */
export function modelSeeds(fields: Fields): number[] {
  const whole = fields.get('analysis.dynamic.seeds');
  const count = Number(whole?.value);
  if (whole?.given && Number.isInteger(count) && count > 0) return Array.from({ length: count }, (_, i) => i + 1);
  const list: number[] = [];
  for (let i = 0; fields.get(`analysis.dynamic.seeds[${i}]`)?.given; ++i) list.push(Number(fields.get(`analysis.dynamic.seeds[${i}]`)!.value));
  const regular = ['none', 'airy', 'stokes5', 'elevation'];
  const random = typedGroups(fields).find((group) => !regular.includes(written(fields, `${group}.type`))) ?? 'environment.waves';
  return list.length ? list : [Number(fields.get(`${random}.seed`)?.value ?? 1) || 1];
}

/** "10" as seeds 1 to 10, "3, 7-9" as a list, in the notation of the model; null if the text is invalid. */
export function seedsValue(typed: string): number | number[] | null {
  const count = /^\s*(\d{1,5})\s*$/.exec(typed);
  if (count) return Number(count[1]) >= 1 && Number(count[1]) <= 10000 ? Number(count[1]) : null;
  return parseSeeds(typed);
}

/** As typed: the number of seeds if they count from 1, otherwise the list. */
export function seedsTyped(seeds: readonly number[]): string {
  return seeds.every((seed, i) => seed === i + 1) ? String(seeds.length) : seeds.join(', ');
}

/** Seconds of "3 h"; NaN if it is not a time. */
export function seconds(typed: string): number {
  const q = parseQuantity(typed);
  return q ? (q.unit ? toSi(q.number, q.unit) : q.number) : Number.NaN;
}

const isGiven = (fields: Fields, path: string): boolean => fields.get(path)?.given === true;
const noWaves = (fields: Fields): boolean => typedGroups(fields).every((group) => written(fields, `${group}.type`) === 'none');
const noMotion = (fields: Fields): boolean => [null, 'fixed'].includes(motionKind(fields));

/** Missing input for a storm run; empty if there is none. */
export function missingInStorm(fields: Fields): string[] {
  const missing: string[] = [];
  if (noWaves(fields)) missing.push('waves');
  if (noMotion(fields) && isGiven(fields, 'vessel') && (noWaves(fields) || !isGiven(fields, 'analysis.dynamic'))) missing.push('vessel motion');
  if (!isGiven(fields, 'analysis.dynamic')) missing.push('duration');
  return missing;
}

/** Default values of missing input: a moderate sea on the bow, the library hull in `hullFile`, three hours. */
export function firstStorm(fields: Fields, hullFile: string | null): Change[] {
  const missing = missingInStorm(fields), changes: Change[] = [];
  const bow = tidy(((fields.get('vessel.heading')?.si ?? 0) * degrees + 360) % 360, 4);
  if (missing.includes('waves')) changes.push({ path: 'environment.waves', value: { type: 'jonswap', hs: '2 m', tp: '8 s', from: `${bow} deg` } });
  if (missing.includes('vessel motion') && hullFile) changes.push({ path: 'vessel.motion', value: { raos: hullFile } });
  if (missing.includes('duration')) changes.push({ path: 'analysis.dynamic', value: { duration: '3 h' } });
  return changes;
}

/** Speed of earlier runs: seconds of computing per second of sea, and the number of parallel seeds. */
export interface Pace { ratio: number; sideBySide: number }

/** Expected computing time in seconds; null without a known speed. */
export function expectedSeconds(pace: Pace | null, sea: number, runs: number): number | null {
  return pace && Number.isFinite(sea) ? pace.ratio * sea * Math.ceil(runs / Math.max(1, Math.min(pace.sideBySide, runs))) : null;
}
