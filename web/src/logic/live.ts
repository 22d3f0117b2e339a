// Sliders: which values of the model can be tried out, between which ends, and what to send for them.
import { fromSi, tidy } from './units';
import { fittedRadius, withRadius, type Box } from './stinger';

/** The part of a form field that is needed here. */
export interface Known { path: string; si: number | null; value?: unknown; count?: number }

export interface LiveBox { key: string; name: string; index: number; path: string; x: number; z: number; structure: string }

export interface LiveBase {
  tension: number | null; // N
  depth: number | null; // m
  radius: number | null; // m, of a row; fitted to listed boxes
  row: boolean; // the stinger's boxes are told as a row, which follows from the radius
  trim: number; // rad
  current: number[]; // m/s by row
  boxes: LiveBox[];
}

/** Values set by sliders: tension [N], depth [m], radius [m], trim [rad], current [factor], "stinger 3" [m upwards]. */
export type LiveValues = Record<string, number>;

export function readBase(fields: Known[]): LiveBase {
  const by = new Map(fields.map((f) => [f.path, f]));
  const si = (path: string): number | null => by.get(path)?.si ?? null;
  const boxes: LiveBox[] = [];
  for (const structure of ['ramp', 'stinger']) {
    for (let i = 0; ; ++i) {
      const path = `supports.${structure}.boxes[${i}]`;
      const x = si(`${path}.x`);
      const z = si(`${path}.z`);
      if (x === null || z === null) break;
      const given = by.get(`${path}.name`)?.value;
      boxes.push({ key: `${structure} ${i + 1}`, name: given ? String(given) : `${structure} ${i + 1}`, index: i, path, x, z, structure });
    }
  }
  const current: number[] = [];
  for (let i = 0; ; ++i) {
    const speed = si(`environment.current[${i}].speed`);
    if (speed === null) break;
    current.push(speed);
  }
  const stinger = boxes.filter((b) => b.structure === 'stinger');
  const row = si('supports.stinger.boxes.count') !== null;
  return {
    tension: si('tensioner.tension'), depth: si('environment.water_depth'),
    radius: row ? si('supports.stinger.radius') : fittedRadius(stinger), row,
    trim: si('vessel.trim') ?? 0, current, boxes,
  };
}

const metres = (v: number): string => `${tidy(Math.round(v * 1e4) / 1e4, 8)} m`;

export function liveChanges(base: LiveBase, values: LiveValues): { path: string; value: string }[] {
  const out: { path: string; value: string }[] = [];
  const { tension, depth, radius, trim, current } = values;
  if (tension !== undefined) out.push({ path: 'tensioner.tension', value: `${tidy(tension / 1e3, 6)} kN` });
  if (depth !== undefined) out.push({ path: 'environment.water_depth', value: metres(depth) });
  if (trim !== undefined) out.push({ path: 'vessel.trim', value: `${tidy(fromSi(trim, 'deg'), 5)} deg` });
  if (current !== undefined) base.current.forEach((speed, i) => out.push({ path: `environment.current[${i}].speed`, value: `${tidy(speed * current, 5)} m/s` }));

  const stinger = base.boxes.filter((b) => b.structure === 'stinger');
  const moved: Box[] | null = radius !== undefined && base.radius && !base.row ? withRadius(stinger, radius / base.radius) : null;
  if (radius !== undefined && base.row) out.push({ path: 'supports.stinger.radius', value: metres(radius) });
  for (const box of base.boxes) {
    const raise = values[box.key] ?? 0;
    const on = moved && box.structure === 'stinger' ? moved[box.index]! : box;
    if (Math.abs(on.x - box.x) > 1e-6) out.push({ path: `${box.path}.x`, value: metres(on.x) });
    if (Math.abs(on.z + raise - box.z) > 1e-6) out.push({ path: `${box.path}.z`, value: metres(on.z + raise) });
  }
  return out;
}

/** Round ends of a slider about a value that the model has. */
export function span(value: number, low: number, high: number): [number, number] {
  const step = 10 ** Math.floor(Math.log10(Math.abs(value) || 1)) / 2;
  return [Math.max(step, Math.floor((value * low) / step) * step), Math.ceil((value * high) / step) * step];
}
