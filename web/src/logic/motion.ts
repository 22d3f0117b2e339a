// Choices of the vessel motion in the form.

export type MotionKind = 'fixed' | 'raos' | 'harmonic' | 'history' | 'coupled';

export const motionLabels: Record<MotionKind, string> = {
  fixed: 'fixed', raos: 'RAO file', harmonic: 'harmonic', history: 'motion history (file)', coupled: 'coupled (floating hull)',
};

export type FileKind = 'raos' | 'history' | 'coupled';

/** A data file of the folder, with the kinds that its contents allow. */
export interface DataFile { name: string; kinds: FileKind[] }

/** Contents of a file of each kind, for messages. */
export const fileLabels: Record<FileKind, string> = { raos: 'RAOs', history: 'a recorded motion', coupled: 'the hydrodynamics of a hull' };

/** Name of hydrodynamic files in the model: WAMIT's common stem, or the file. */
export const hydrodynamics = (file: string): string => file.replace(/\.hst$/, '');

interface Known { given: boolean; value?: unknown; si?: number | null }

const sea = 1025; // kg/m^3

/** A floating hull as a loaded box: default values for data that the files do not contain. */
function coupledValue(file: string, fields: ReadonlyMap<string, Known>): unknown {
  const si = (key: string, fallback: number): number => fields.get(`vessel.${key}`)?.si ?? fallback;
  const length = si('length', 120), beam = si('beam', 30), draught = si('draught', 5), depth = si('depth', 9);
  const metres = (v: number): string => `${Number(v.toPrecision(4))} m`;
  return {
    hydrodynamics: hydrodynamics(file), mass: `${Math.round((sea * length * beam * draught) / 1e3)} t`,
    centre_of_gravity: { x: '0 m', y: '0 m', z: metres(0.65 * depth - draught) },
    gyration: { roll: metres(0.35 * beam), pitch: metres(length / 4), yaw: metres(length / 4) },
    current: { transverse: 0.8, longitudinal: 0.5 },
  };
}

/** Null if the model gives none. */
export function motionKind(fields: ReadonlyMap<string, Known>): MotionKind | null {
  for (const kind of ['raos', 'history', 'harmonic', 'coupled'] as const) if (fields.get(`vessel.motion.${kind}`)?.given) return kind;
  const whole = fields.get('vessel.motion');
  return whole?.given && whole.value === 'fixed' ? 'fixed' : null;
}

/** Value written into the model for a choice. A new RAO file keeps the given conventions. */
export function motionValue(kind: MotionKind, file: string, fields: ReadonlyMap<string, Known>): unknown {
  if (kind === 'fixed') return 'fixed';
  if (kind === 'coupled') return { coupled: coupledValue(file, fields) };
  if (kind === 'harmonic') return { harmonic: { heave: { amplitude: '0.5 m', period: '8 s' } } };
  const out: Record<string, unknown> = { [kind]: file };
  const convention: Record<string, unknown> = {};
  if (motionKind(fields) === kind) {
    for (const [path, field] of fields) {
      if (!path.startsWith('vessel.motion.convention.') || !field.given || field.value === null || field.value === undefined) continue;
      const keys = path.slice('vessel.motion.convention.'.length).split('.');
      let group = convention;
      for (const key of keys.slice(0, -1)) group = (group[key] ??= {}) as Record<string, unknown>;
      group[keys.at(-1)!] = field.value;
    }
  }
  if (Object.keys(convention).length) out.convention = convention;
  return out;
}

/** Keys required by the type of sea: shown even if they are not given. */
export function askedOfWaves(type: unknown): string[] {
  switch (type) {
    case 'jonswap': case 'pierson_moskowitz': return ['hs', 'tp'];
    case 'airy': case 'stokes5': return ['height', 'period'];
    case 'ochi_hubble': return ['parts'];
    case 'torsethaugen': return ['hs', 'tp', 'model'];
    case 'user': return ['spectrum_file'];
    case 'elevation': return ['elevation_file'];
    default: return [];
  }
}
