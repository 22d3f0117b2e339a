import { describe, expect, test } from 'vitest';
import { firstOperation, suspendedLength, missingPart, type FirstOperation, type LaySize } from '../src/logic/firstOperation';
import { cableText, designChanges, headText, listChanges, shortenedEnd, stageCount, stagesText, tensionText, type Fields } from '../src/logic/operationKeys';
import { stageCharts } from '../src/logic/stageCharts';
import { cell, stageColumns, isSetting, partAt, stageLevel, stageName, stageTable, whyNot } from '../src/logic/operation';
import { shape } from '../src/charts/data';
import { firstItem } from '../src/logic/firstItems';
import type { Lay, LineParts, Operation, OperationStage, StageValues } from '../src/api/types';

const values: StageValues = { top_tension: 300e3, bottom_tension: 200e3, head_x: 40, head_z: -15.75, head_clearance: 73, cable_tension: 300e3, cable_utilisation: 0.07, sagbend_von_mises: 60e6, sagbend_strain: 3e-4, overbend_strain: null, stinger_tip_clearance: null, largest_reaction: 14e3, largest_reaction_support: 'ramp 4', lay_back: 360, utilisation: 0.5, check: 'a check', verdict: 'PASSED', end_height: null, largest_moment: null, largest_bending_stress: null, davit_tension: null };
const stage = (part: Partial<OperationStage>): OperationStage => ({ name: 'stage 1', out: 92, tension: 300e3, barge_ahead: 0, governing: '', values, parts: null, failure: null, findings: [], ...part });
const failed = stage({ name: 'down', values: null, failure: { what: 'no equilibrium', where: 'at the winch', why: 'too little tension.', least_tension: 61.5e3 } });
const operation = (stages: OperationStage[]): Operation => ({ title: 'Abandonment', out_name: 'Cable out', stages, hold_points: [], findings: [] });

describe('parts of a line', () => {
  const above: LineParts = { head_from: 92, head_to: 98, cable_at_far_end: false };
  const below: LineParts = { head_from: 200, head_to: 206, cable_at_far_end: true };
  test('abandoned: cable, head, pipe from the winch on', () => expect([0, 91, 95, 99, 500].map((s) => partAt(above, s))).toEqual(['cable', 'cable', 'head', 'pipe', 'pipe']));
  test('started: pipe, head, cable to the anchor', () => expect([0, 199, 203, 207, 500].map((s) => partAt(below, s))).toEqual(['pipe', 'pipe', 'head', 'cable', 'cable']));
  test('a lay is all pipe', () => expect(partAt(null, 3)).toBe('pipe'));
  test('the elevation draws each by itself, without gaps between them', () => {
    const lay = { pipe: { s: [0, 50, 95, 120, 200], x: [0, 50, 95, 120, 200], y: [0, 0, 0, 0, 0], z: [5, 0, -20, -40, -80] }, supports: [], touchdown: null, key: null } as unknown as Lay;
    const lines = shape(lay, null, false, above).lines;
    expect(lines.map((l) => l.name)).toEqual(['pipe', 'head', 'cable']);
    expect(lines[2]!.values).toEqual([5, 0, -20, null, null]);
    expect(lines[1]!.values).toEqual([null, null, -20, -40, null]);
    expect(lines[0]!.values).toEqual([null, null, null, -40, -80]);
  });
});

describe('the table of stages', () => {
  test('has the columns with information', () => {
    const names = stageColumns(operation([stage({}), failed])).map((c) => c.name);
    expect(names).toContain('head z');
    expect(names).not.toContain('tip');
    expect(names).not.toContain('ahead');
    expect(stageColumns(operation([stage({}), stage({ barge_ahead: 12 })])).map((c) => c.name)).toContain('ahead');
  });
  test('shows values in engineering units, never -0', () => {
    const columns = new Map(stageColumns(operation([stage({})])).map((c) => [c.name, c]));
    expect(cell(columns.get('top')!, stage({}))).toBe('300.0');
    expect(cell(columns.get('strain')!, stage({}))).toBe('0.030');
    expect(cell(columns.get('cable')!, stage({}))).toBe('7.0');
    expect(cell(columns.get('head z')!, stage({ values: { ...values, head_z: -0.001 } }))).toBe('0.0');
    expect(cell(columns.get('top')!, failed)).toBe('–');
  });
  test('judges a stage by its largest utilisation', () => {
    expect([0.5, 0.9, 1.01, null].map((u) => stageLevel(stage({ values: { ...values, utilisation: u } })))).toEqual(['good', 'good', 'over', 'unknown']);
    expect(stageLevel(failed)).toBe('gone');
  });
  test('judges a stage by its findings as well', () => expect(stageLevel(stage({ values: { ...values, verdict: 'PASSED WITH RESERVATIONS: 1 serious finding: pipe-off-rollers' } }))).toBe('near'));
  test('distinguishes inputs of a stage from its results', () => expect(stageColumns(operation([stage({})])).filter(isSetting).map((c) => c.name)).toEqual(['cable out', 'top']));
  test('goes to a spreadsheet with numbers, and with a text if a stage has no solution', () => {
    const table = stageTable(operation([stage({}), failed]));
    expect(table.columns[1]).toMatchObject({ title: 'cable out', unit: 'm' });
    expect(table.rows[0]!.slice(0, 3)).toEqual(['1', 92, 300]);
    expect(table.rows[1]!.at(-1)).toMatch(/no equilibrium/);
  });
  test('reports the reason of a failed stage and its minimum tension', () => {
    expect(whyNot(failed)).toBe('no equilibrium, at the winch: too little tension. The minimum top tension is 61.5 kN.');
    expect(whyNot(stage({}))).toBe('');
    expect(stageName(stage({}), 0)).toBe('1');
    expect(stageName(failed, 4)).toBe('5 down');
  });
});

describe('a first operation', () => {
  const size: LaySize = { joint: 12.2, tip: 85, touchdown: 420, tension: 300e3, bottomTension: 196e3, height: 6, depthAt: () => 89 };
  const keys = (type: FirstOperation, lay = size): Record<string, Record<string, string>> => Object.fromEntries(firstOperation(type, lay).map((c) => [c.path.replace('operation.', ''), c.value])) as never;
  const number = (text: string | undefined): number => Number.parseFloat(text ?? '');
  test('its cable follows a catenary', () => {
    // H = 200 kN, 200 N/m: a = 1000 m; from the lowest point to 1000 m aside the cable is a sinh(1), its top is a (cosh(1) - 1) higher
    const rise = 1000 * (Math.cosh(1) - 1), tension = 200e3 * Math.cosh(1);
    expect(suspendedLength(tension, rise, 200, 0)).toBeCloseTo(1000 * Math.sinh(1), 6);
    // the part beyond 500 m, where the vertical force is H sinh(0.5)
    expect(suspendedLength(tension, 1000 * (Math.cosh(1) - Math.cosh(0.5)), 200, 200e3 * Math.sinh(0.5))).toBeCloseTo(1000 * (Math.sinh(1) - Math.sinh(0.5)), 6);
  });
  test('of abandonment has the cable length to reach the seabed at the lay tension', () => {
    const k = keys('abandonment'), weight = number(k.cable!.weight_submerged);
    const least = suspendedLength(300e3, 95, weight, 1e3 * number(k.head!.weight_submerged) / 2);
    expect(number(k.stages!.to)).toBeGreaterThan(least);
    expect(number(k.stages!.to)).toBeLessThan(1.1 * (85 + suspendedLength(300e3, 95, weight, 0)));
    expect(k.stages).toMatchObject({ steps: 10, tension: 'hold' });
  });
  test('has more cable in deeper water, also if the seabed slopes down beyond touchdown', () => {
    const to = (depthAt: (d: number) => number): number => number(keys('abandonment', { ...size, depthAt }).stages!.to);
    expect(to(() => 200)).toBeGreaterThan(1.3 * to(() => 89));
    expect(to((d) => 89 + 0.05 * Math.max(d - 420, 0))).toBeGreaterThan(1.1 * to(() => 89));
  });
  test.each([3e3, 300e3, 4000e3])('has a cable of three times the tension of %d N, and a head that this tension carries', (tension) => {
    const k = keys('abandonment', { ...size, tension, bottomTension: 0.3 * tension });
    expect(1e3 * number(k.cable!.breaking_load)).toBeGreaterThanOrEqual(2.99 * tension);
    expect(1e3 * number(k.head!.weight_submerged)).toBeLessThanOrEqual(0.1 * tension);
  });
  test('of start-up has an anchor on the seabed', () => expect(number(keys('start_up').anchor!.depth)).toBeCloseTo(89, 1));
  test('of a move advances by one joint', () => expect(keys('move').stages).toMatchObject({ from: '0 m', to: '12 m' }));
  test.each(['recovery', 'lay_down'] as const)('of %s has the stages of the abandonment', (type) => {
    const { type: _a, ...lay } = keys('abandonment'), { type: _b, ...same } = keys(type);
    expect(same).toEqual(lay);
  });
  test('of a shore pull has a winch on the seabed, beyond the last stage', () => {
    const k = keys('shore_pull');
    expect(number(k.winch!.distance)).toBeGreaterThan(number(k.stages!.to));
    expect(number(k.winch!.depth)).toBeCloseTo(89, 0);
  });
  test('of a hold-back pulls no more pipe than friction leaves a tension for', () => {
    const k = keys('hold_back'), weight = (size.tension - size.bottomTension) / (89 + size.height);
    expect(0.5 * weight * (number(k.stages!.to) - number(k.stages!.from))).toBeLessThan(0.5 * size.bottomTension);
  });
  test('of a lift hauls in every davit', () => {
    const changes = firstOperation('lift', null, { structure: '', tank: '', davits: [{ name: 'davit 1', length: 20 }, { name: 'davit 2', length: 21 }] });
    const stages = changes.find((c) => c.path === 'operation.stages')!.value as { lengths: Record<string, string> }[];
    expect(stages.map((s) => s.lengths['davit 1'])).toEqual(['20 m', '18 m', '16 m', '14 m', '12 m']);
  });
  test('reports missing parts of the model', () => {
    const nothing = { structure: '', tank: '', davits: [] };
    expect(missingPart('passage', nothing)).toMatch(/pipe.structures/);
    expect(missingPart('lift', nothing)).toMatch(/lines/);
    expect(missingPart('abandonment', nothing)).toBe('');
    expect(missingPart('passage', { ...nothing, structure: 'tee' })).toBe('');
  });
  test('a stage added in the form is one of its operation', () => {
    expect(firstItem('operation.stages', 89, 'abandonment')).toEqual({ cable_out: '50 m' });
    expect(firstItem('operation.stages', 89, 'start_up')).toEqual({ pipe_out: '100 m' });
    expect(firstItem('operation.stages', 89, 'moored')).toEqual({ name: 'stage 1' });
  });
});

describe('the settings of an operation', () => {
  const field = (value: string | number | null, si: number | null = null, kind = 'quantity', count = 0): unknown => ({ value, si, kind, count, given: true, default: null });
  const even = new Map<string, unknown>([
    ['operation.type', field('abandonment', null, 'choice')], ['operation.stages', field(null, null, 'map')],
    ['operation.stages.from', field('30 m', 30)], ['operation.stages.to', field('400 m', 400)], ['operation.stages.steps', field('6', 6, 'integer')], ['operation.stages.tension', field('hold', null, 'choice')],
    ['operation.head.length', field('6 m', 6)], ['operation.head.weight_in_air', field('40 kN', 40e3)], ['operation.cable.diameter', field('76 mm', 0.076)], ['operation.cable.breaking_load', field('4200 kN', 4.2e6)],
    ['tensioner.tension', field('250 kN', 250e3)],
  ]) as unknown as Fields;
  const listed = new Map<string, unknown>([
    ['operation.type', field('recovery', null, 'choice')], ['operation.stages', field(null, null, 'list', 3)],
    ...[60, 170, 400].flatMap((out, i) => [[`operation.stages[${i}].cable_out`, field(`${out} m`, out)], [`operation.stages[${i}].tension`, field(`${280 - 60 * i} kN`, 280e3 - 60e3 * i)]] as [string, unknown][]),
  ]) as unknown as Fields;
  test('are summarised', () => {
    expect([headText(even), cableText(even)]).toEqual(['6 m, 40 kN', '76 mm, 4200 kN']);
    expect([stagesText(even), tensionText(even)]).toEqual(['7, cable out 30 to 400 m', 'constant, 250 kN']);
    expect([stagesText(listed), tensionText(listed)]).toEqual(['3, cable out 60 to 400 m', '280 … 160 kN']);
    expect(stageCount(listed)).toBe(3);
  });
  test('of a designed procedure seek the tension within the given limits', () => {
    expect(designChanges(even)).toEqual([{ path: 'operation.stages.tension', value: 'seek' }, { path: 'operation.stages.limits', value: { utilisation: 0.9 } }]);
    const limited = new Map([...even, ['operation.stages.limits.tip_clearance', field('0.3 m', 0.3)]]) as unknown as Fields;
    expect(designChanges(limited)).toEqual([{ path: 'operation.stages.tension', value: 'seek' }]);
    expect(tensionText(new Map([...limited, ['operation.stages.tension', field('seek', null, 'choice')]]) as unknown as Fields)).toBe('seek: tip clearance above 0.3 m');
  });
  const procedure = (clearances: number[]): OperationStage[] => clearances.map((head_clearance, i) => stage({ out: 100 * (i + 1), values: { ...values, head_clearance } }));
  test('of a designed procedure end one stage after the head reaches the seabed', () => {
    expect(shortenedEnd('abandonment', procedure([60, 20, 0.1, -0.05, -0.05, -0.05]))).toBe(400);
    expect(shortenedEnd('recovery', procedure([60, 20, 0.1, -0.05, -0.05, -0.05]).reverse())).toBe(400);
    expect(shortenedEnd('abandonment', procedure([60, 40, 20, 0.1, -0.05]))).toBeNull();
    expect(shortenedEnd('abandonment', procedure([60, 40, 20, 10]))).toBeNull();
    expect(shortenedEnd('start_up', procedure([60, 20, 0.1, -0.05, -0.05, -0.05]))).toBeNull();
  });
  test('of listed stages are designed at as many even steps', () => expect(designChanges(listed)).toEqual([{ path: 'operation.stages', value: { from: '60 m', to: '400 m', steps: 2, tension: 'seek', limits: { utilisation: 0.9 } } }]));
  test('are listed with the tensions that were found, a recovery from the vessel to the bed', () => {
    const list = (type: string): unknown => listChanges(type, [stage({ out: 30 }), stage({ name: 'low', out: 400, tension: 120e3 })])[0]!.value;
    expect(list('abandonment')).toEqual([{ cable_out: '30 m', tension: '300 kN' }, { name: 'low', cable_out: '400 m', tension: '120 kN' }]);
    expect(list('recovery')).toEqual([{ name: 'low', cable_out: '400 m', tension: '120 kN' }, { cable_out: '30 m', tension: '300 kN' }]);
  });
});

describe('diagrams over the stages', () => {
  const two = operation([stage({ out: 200, values: { ...values, top_tension: 200e3, cable_tension: 200e3 } }), stage({ out: 92 }), { ...failed, out: 150 }]);
  test('run over the length paid out, for any order of the stages', () => {
    const { charts, stages, x } = stageCharts(two);
    expect(charts[0]!.x).toEqual([92, 150, 200]);
    expect(stages).toEqual([1, 2, 0]);
    expect(x).toEqual([200, 92, 150]);
    expect(charts[0]!.lines.map((l) => l.name)).toEqual(['top', 'bottom']);
    expect(charts[0]!.lines[0]!.values).toEqual([300, null, 200]);
  });
  test('are only those that say something', () => {
    const titles = stageCharts(two).charts.map((chart) => chart.title);
    expect(titles).toContain('Utilisation');
    expect(titles).not.toContain('Clearance at the stinger tip');
    expect(titles).not.toContain('Vessel ahead');
  });
});
