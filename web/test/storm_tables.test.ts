import { expect, test } from 'vitest';
import type { DynamicSummary, Study } from '../src/api/types';
import { boxesTable, extremeName, firstHistories, rollersTable, seedExtremes, shownFrequencies, statisticsTable, studyTable } from '../src/logic/stormTables';

const spread = (min: number, max: number): { min: number; max: number; mean: number; std: number } => ({ min, max, mean: (min + max) / 2, std: 1e3 });
const roller = { reaction: spread(0, 40e3), contact_share: 0.75, impacts: 3, largest_impact_force: 55e3, dent_depth: 0.001 };
const support = {
  name: 'stinger 8', s: 500, reaction: spread(0, 80e3), reaction_percentiles: { p50: 40e3, p90: 60e3, p99: 75e3 }, contact_share: 0.5, impacts: 3,
  left_to_port: null, left_to_starboard: 12, structure: 'stinger', rows: [{ bottom: roller, port: roller }],
};
const summary = {
  top_tension: spread(200e3, 300e3), bottom_tension: spread(150e3, 250e3), lay_back: spread(300, 340), departure_angle: spread(0.2, 0.4), stinger_tip_clearance: null,
  smallest_tension: spread(90e3, 140e3), overbend: null, tower: null, supports: [support], impacts: [{ name: 'stinger 8', count: 3, largest_impact_force: 55e3, dent_depth: 0.001 }],
} as unknown as DynamicSummary;

test('statistics of a run have each quantity in its unit, and omit missing ones', () => {
  const table = statisticsTable(summary, null);
  expect(table.rows[0]).toEqual(['top tension', 'kN', null, '200.0', '250.0', '300.0', '1.0']);
  expect(table.rows.map((row) => row[0])).not.toContain('stinger tip clearance');
  expect(table.rows.find((row) => row[0] === 'lay-back')).toEqual(['lay-back', 'm', null, '300.000', '320.000', '340.000', '1000.000']);
});

test('boxes have reactions over time, contact, impacts, and a mark if the pipe left them', () => {
  const table = boxesTable(summary, null);
  expect(table.rows[0]).toEqual(['stinger 8', null, 0, 40, 75, 80, 1, 50, 3, 55, 1]);
  expect(table.columns.map((column) => column.title)).toContain('99 %');
  expect(table.marks).toEqual(['over']);
});

test('rollers are listed by box, row and place', () => {
  const rows = rollersTable(summary).rows;
  expect(rows.map((row) => row.slice(0, 3))).toEqual([['stinger 8', 1, 'bottom'], ['stinger 8', 1, 'port']]);
  expect(rows[0]!.slice(3)).toEqual([0, 20, 40, 1, 75, 3, 55, 1]);
});

const study = (kind: Study['kind']): Study => ({
  kind, cases: [{ id: 'a', name: 'off', words: 'Off' }, { id: 'b', name: 'on', words: 'On' }], findings: [],
  quantities: [{ name: 'top', text: 'Largest tension', unit: 'kN', factor: 1e-3, values: [300e3, null], mean: 310e3, std: 5e3, min: 300e3, max: 320e3, gumbel: { estimate: 350e3, low: 330e3, high: 380e3 }, acer: null }],
});

test('seeds are shown by their statistics, variants side by side', () => {
  expect(studyTable(study('seeds')).rows).toEqual([['Largest tension', 'kN', '310', '5', '300', '320']]);
  const variants = studyTable(study('comparison'));
  expect(variants.columns.map((column) => column.title)).toEqual(['quantity', 'unit', 'Off', 'On']);
  expect(variants.rows).toEqual([['Largest tension', 'kN', '300', null]]);
});

test('extremes over seeds have confidence intervals, and need enough seeds', () => {
  expect(seedExtremes(study('seeds'))!.rows).toEqual([['Largest tension', 'kN', '350', '330', '380', null, null, null]]);
  const few = study('seeds');
  few.quantities[0]!.gumbel = null;
  expect(seedExtremes(few)).toBeNull();
});

test('names of extremes are words', () => {
  expect(extremeName('overbend_von_mises_peak')).toBe('overbend von Mises');
  expect(extremeName('support/stinger 8/reaction')).toBe('stinger 8, reaction');
});

test('the histories that matter come first, as far as a run has them', () => {
  expect(firstHistories(['elevation', 'heave', 'overbend_von_mises', 'top_tension', 'step'])).toEqual(['top_tension', 'overbend_von_mises', 'heave', 'elevation']);
  expect(firstHistories(['vessel/surge', 'vessel/heave', 'mooring/bow/fairlead_tension'])).toEqual(['vessel/heave', 'mooring/bow/fairlead_tension', 'vessel/surge']);
});

test('a spectrum is shown as far as it has something', () => {
  const frequency = Array.from({ length: 100 }, (_, i) => i / 100);
  expect(shownFrequencies(frequency, frequency.map((f) => (f < 0.2 ? 1 : 0)))).toBe(24);
  expect(shownFrequencies(frequency, frequency.map(() => 1))).toBe(100);
});
