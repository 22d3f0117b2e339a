// Trial values on top of the model, and the key changes that they represent.
import { fittedRadius, withRadius, type Box } from './stinger';
import { tidy } from './units';
import { boxHeight, currentFactor, keyVariable, stingerRadius, variableText, type NumericField } from './variables';

/** `name`: the one in the results. */
export interface LiveBox { path: string; name: string; index: number; x: number; z: number; structure: string }

export interface LiveBase {
  fields: ReadonlyMap<string, NumericField>;
  radius: number | null; // m, fitted to the listed boxes of the stinger; null if it is a separate key
  current: number[]; // m/s by row
  boxes: LiveBox[];
}

/** SI values by key, or by the name of a variable that sets several keys. */
export type LiveValues = Record<string, number>;

export function readBase(list: readonly NumericField[]): LiveBase {
  const fields = new Map(list.map((f) => [f.path, f]));
  const si = (path: string): number | null => fields.get(path)?.si ?? null;
  const boxes: LiveBox[] = [];
  for (const structure of ['ramp', 'stinger']) {
    for (let index = 0; ; ++index) {
      const path = `supports.${structure}.boxes[${index}]`;
      const x = si(`${path}.x`), z = si(`${path}.z`);
      if (x === null || z === null) break;
      const given = fields.get(`${path}.name`)?.value;
      boxes.push({ path, name: given ? String(given) : `${structure} ${index + 1}`, index, x, z, structure });
    }
  }
  const current: number[] = [];
  for (let i = 0; ; ++i) {
    const speed = si(`environment.current[${i}].speed`);
    if (speed === null) break;
    current.push(speed);
  }
  const row = si('supports.stinger.boxes.count') !== null;
  return { fields, radius: row ? null : fittedRadius(boxes.filter((b) => b.structure === 'stinger')), current, boxes };
}

const metres = (v: number): string => `${tidy(Math.round(v * 1e4) / 1e4, 8)} m`;

/** Positions of the stinger boxes for another radius, then raised. */
function boxChanges(base: LiveBase, values: LiveValues): [string, string][] {
  const stinger = base.boxes.filter((b) => b.structure === 'stinger');
  const radius = values[stingerRadius], raise = values[boxHeight] ?? 0;
  const moved: Box[] | null = radius !== undefined && base.radius ? withRadius(stinger, radius / base.radius) : null;
  const out: [string, string][] = [];
  for (const box of stinger) {
    const place = moved?.[box.index] ?? box;
    if (Math.abs(place.x - box.x) > 1e-6) out.push([`${box.path}.x`, metres(place.x)]);
    if (Math.abs(place.z + raise - box.z) > 1e-6) out.push([`${box.path}.z`, metres(place.z + raise)]);
  }
  return out;
}

/** The value of a key takes precedence over a variable that sets several keys. */
export function liveChanges(base: LiveBase, values: LiveValues): { path: string; value: string | number }[] {
  const out = new Map<string, string | number>(boxChanges(base, values));
  const factor = values[currentFactor];
  if (factor !== undefined) base.current.forEach((speed, i) => out.set(`environment.current[${i}].speed`, `${tidy(speed * factor, 5)} m/s`));
  for (const [id, si] of Object.entries(values)) {
    const variable = keyVariable(base.fields.get(id), base.fields);
    if (!variable) continue;
    const text = variableText(variable, si, 7);
    out.set(id, variable.unit ? text : Number(text));
  }
  return [...out].map(([path, value]) => ({ path, value }));
}
