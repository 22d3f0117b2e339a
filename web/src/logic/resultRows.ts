// Key results as rows: static, over a storm, and for a comparison.
import type { KeyResults, Region, RegionSummary, Spread } from '../api/results';
import type { Lay, RunSummary } from '../api/types';

export interface ResultRow {
  name: string;
  /** SI unit; "%" for strains. */
  unit: string;
  static: number | null;
  /** Unfavourable extreme over the storm: minimum of clearances and bottom tension, maximum of everything else. */
  storm: number | null;
  compared: number | null;
  /** Path in summary.json of a value that goal seek supports. */
  result?: string;
  title?: string;
}

type InTime = NonNullable<RunSummary['dynamic']>;
type Known = Pick<Lay, 'key' | 'moorings' | 'lines'>;
type Quantity<Of = Known> = { name: string; unit: string; of: (from: Of) => number | null | undefined; storm?: (d: InTime) => number | null | undefined; result?: string; title?: string };

const most = (spread: Spread | null | undefined): number | null => spread?.max ?? null;
const least = (spread: Spread | null | undefined): number | null => spread?.min ?? null;

function regionQuantities(name: string, region: (k: KeyResults) => Region | null, over: (d: InTime) => RegionSummary | null | undefined): Quantity<KeyResults>[] {
  const steel = (pick: (r: Region) => number) => (k: KeyResults): number | null => { const r = region(k); return r && r.von_mises !== 0 ? pick(r) : null; };
  return [
    { name: `${name} von Mises`, unit: 'Pa', of: steel((r) => r.von_mises), storm: (d) => most(over(d)?.max_von_mises), result: `static.${name}.max_von_mises` },
    { name: `${name} bending`, unit: 'Pa', of: steel((r) => r.bending_stress), storm: (d) => most(over(d)?.max_bending_stress), result: `static.${name}.max_bending_stress` },
    { name: `${name} strain`, unit: '%', of: steel((r) => r.strain), storm: (d) => most(over(d)?.max_strain) },
  ];
}

const ofPipe: Quantity<KeyResults>[] = [
  { name: 'top tension', unit: 'N', of: (k) => k.top_tension, storm: (d) => most(d.top_tension), result: 'static.top_tension' },
  { name: 'bottom tension', unit: 'N', of: (k) => k.bottom_tension, storm: (d) => least(d.bottom_tension), result: 'static.bottom_tension',
    title: 'Minimum over the storm: a low tension increases sagbend bending and can compress the pipe.' },
  ...regionQuantities('overbend', (k) => k.overbend, (d) => d.overbend),
  ...regionQuantities('tower', (k) => k.tower, (d) => d.tower),
  ...regionQuantities('sagbend', (k) => k.sagbend, (d) => d.sagbend),
  { name: 'largest reaction', unit: 'N', of: (k) => k.largest_reaction || null, result: 'static.largest_reaction.value', title: 'Maximum of a single roller.',
    storm: (d) => rollerMaximum(d) },
  { name: 'tip clearance', unit: 'm', of: (k) => k.stinger_tip_clearance, storm: (d) => least(d.stinger_tip_clearance), result: 'static.stinger_tip_clearance',
    title: 'Clearance of the pipe above the last stinger roller; minimum over the storm.' },
  { name: 'lay-back', unit: 'm', of: (k) => k.lay_back, storm: (d) => most(d.lay_back), result: 'static.lay_back', title: 'Horizontal distance from stern shoe to touchdown.' },
  { name: 'departure angle', unit: 'rad', of: (k) => k.departure_angle, storm: (d) => most(d.departure_angle), result: 'static.departure_angle' },
  { name: 'stinger radius', unit: 'm', of: (k) => k.stinger_fitted_radius, title: 'Radius of the least-squares circle through the stinger boxes.' },
];

function rollerMaximum(d: InTime): number | null {
  let out: number | null = null;
  // none without a pipe
  for (const box of d.supports ?? []) for (const row of box.rows) for (const roller of Object.values(row as Record<string, { reaction?: Spread }>)) {
    const value = roller.reaction?.max;
    if (value !== undefined && value !== null && (out === null || value > out)) out = value;
  }
  return out;
}

/** Static offset of the moored vessel, and the line with the highest utilisation. */
function ofMoorings({ moorings }: Known): Quantity[] {
  if (!moorings) return [];
  const tensions = (m: Lay['moorings']): number[] => m?.rest.moorings.filter((line) => !line.parted).map((line) => line.fairlead_tension) ?? [];
  const used = (m: Lay['moorings']): number[] => m?.rest.moorings.map((line) => line.utilisation ?? 0) ?? [];
  const inTime = (d: InTime): number[] => d.moorings?.map((line) => line.fairlead_tension.max) ?? [];
  const most = (list: number[]): number | null => (list.length ? Math.max(...list) : null);
  return [
    { name: 'surge', unit: 'm', of: (l) => l.moorings?.rest.vessel.surge, title: 'Static offset of the vessel from its nominal position, positive ahead.' },
    { name: 'sway', unit: 'm', of: (l) => l.moorings?.rest.vessel.sway, title: 'Static offset of the vessel from its nominal position, positive to port.' },
    { name: 'yaw', unit: 'rad', of: (l) => l.moorings?.rest.vessel.yaw },
    { name: 'largest line tension', unit: 'N', of: (l) => most(tensions(l.moorings)), storm: (d) => most(inTime(d)), title: 'Maximum fairlead tension of all mooring lines.' },
    { name: 'of breaking load', unit: '%', of: (l) => most(used(l.moorings)) || null, title: 'Maximum of all mooring lines.' },
  ];
}

/** Lines other than the pipe: the maximum tension of each. */
const ofLines = ({ lines }: Known): Quantity[] => lines.map(({ name }) => ({
  name: `${name}, tension`, unit: 'N',
  of: (l) => l.lines.find((line) => line.name === name)?.largest_tension,
  storm: (d) => d.lines?.find((line) => line.name === name)?.largest_tension,
  title: 'Largest effective tension along the line.',
}));

export function resultRows(lay: Known, storm: InTime | null, compared: Known | null): ResultRow[] {
  const quantities: Quantity[] = [...ofPipe.map((q) => ({ ...q, of: (from: Known) => (from.key ? q.of(from.key) : null) })), ...ofMoorings(lay), ...ofLines(lay)];
  return quantities.map((q) => ({
    name: q.name, unit: q.unit, result: q.result, title: q.title,
    static: q.of(lay) ?? null, storm: storm ? q.storm?.(storm) ?? null : null, compared: compared ? q.of(compared) ?? null : null,
  })).filter((row) => row.static !== null);
}

/** "+4.1 %" of the reference value; the difference itself if that is zero. */
export function changeText(value: number, compared: number): string {
  if (value === compared) return '=';
  if (compared === 0) return value > 0 ? '> 0' : '< 0';
  const percent = (100 * (value - compared)) / Math.abs(compared), digits = Math.abs(percent) < 10 ? 1 : 0;
  return `${percent > 0 ? '+' : '−'}${Math.abs(percent).toFixed(digits)} %`;
}
