import { describe, expect, it } from 'vitest';
import type { KeyResults, Region } from '../src/api/results';
import { changeText, resultRows } from '../src/logic/resultRows';

const region = (von_mises: number): Region => ({ von_mises, bending_stress: von_mises / 2, strain: 0.001, utilisation: 0.5, s: 10 }) as Region;
const key = (top: number): KeyResults => ({
  top_tension: top, bottom_tension: 2e5, lay_back: 300, suspended_length: 400, departure_angle: 0.4, stinger_tip_clearance: 0.3, ramp_fitted_radius: null,
  stinger_fitted_radius: 120, largest_reaction: 0, overbend: region(3e8), tower: null, sagbend: region(0),
});
const spread = (min: number, max: number) => ({ min, max, mean: (min + max) / 2 });

describe('key results as rows', () => {
  const storm = { top_tension: spread(1e5, 3e5), bottom_tension: spread(1, 2), stinger_tip_clearance: spread(0.06, 0.5), supports: [], overbend: { max_von_mises: spread(3e8, 4e8) } };
  const lay = (top: number) => ({ key: key(top), moorings: null, lines: [] });
  const rows = resultRows(lay(2.5e5), storm as never, lay(2e5));
  const row = (name: string) => rows.find((r) => r.name === name);

  it('have the maximum of a storm, but the minimum of clearances and bottom tension', () => {
    expect(row('top tension')).toMatchObject({ static: 2.5e5, storm: 3e5, compared: 2e5 });
    expect(row('overbend von Mises')!.storm).toBe(4e8);
    expect(row('tip clearance')!.storm).toBe(0.06);
    expect(row('bottom tension')!.storm).toBe(1);
  });
  it('omit quantities that the model does not have', () => {
    expect(row('tower von Mises')).toBeUndefined();
    expect(row('sagbend von Mises')).toBeUndefined(); // a cable alone reaches the seabed: no steel there
    expect(row('largest reaction')).toBeUndefined();
  });
  it('are of moorings and lines if there is no pipe', () => {
    const moored = { rest: { name: '', vessel: { surge: -1, sway: 2, yaw: 0 }, moorings: [{ fairlead_tension: 4e5, utilisation: 0.2 }, { fairlead_tension: 3e5, utilisation: 0.1 }] }, operation: '', stages: [] };
    const rows = resultRows({ key: null, moorings: moored as never, lines: [{ name: 'jumper', largest_tension: 9e3 }] as never }, null, null);
    expect(rows.map((r) => [r.name, r.static])).toEqual([['surge', -1], ['sway', 2], ['yaw', 0], ['largest line tension', 4e5], ['of breaking load', 0.2], ['jumper, tension', 9e3]]);
  });
  it('have the path of values that goal seek supports', () => {
    expect(row('overbend von Mises')!.result).toBe('static.overbend.max_von_mises');
  });
});

describe('a change as text', () => {
  it.each([[104.1, 100, '+4.1 %'], [80, 100, '−20 %'], [-0.5, -1, '+50 %'], [1, 1, '='], [1, 0, '> 0']])('of %d against %d is %s', (value, before, text) => {
    expect(changeText(value, before)).toBe(text);
  });
});
