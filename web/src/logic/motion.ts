// The vessel's motion as the form offers it.

export type MotionKind = 'fixed' | 'raos' | 'harmonic' | 'history' | 'coupled';

export const motionWords: Record<MotionKind, string> = {
  fixed: 'fixed', raos: 'RAO file', harmonic: 'harmonic', history: 'motion history (file)', coupled: 'coupled (floating hull)',
};

/** Endings of the files that a kind reads. */
export const fileKinds: Record<'raos' | 'history', string[]> = { raos: ['.csv', '.4', '.yml'], history: ['.csv'] };

interface Known { given: boolean; value?: unknown }

/** Null where the model does not say. */
export function motionKind(fields: ReadonlyMap<string, Known>): MotionKind | null {
  for (const kind of ['raos', 'history', 'harmonic', 'coupled'] as const) if (fields.get(`vessel.motion.${kind}`)?.given) return kind;
  const whole = fields.get('vessel.motion');
  return whole?.given && whole.value === 'fixed' ? 'fixed' : null;
}

/** What is written into the model for a choice. Another file of RAOs keeps what is said about its conventions. */
export function motionValue(kind: MotionKind, file: string, fields: ReadonlyMap<string, Known>): unknown {
  if (kind === 'fixed') return 'fixed';
  if (kind === 'harmonic') return { harmonic: { heave: { amplitude: '0.5 m', period: '8 s' } } };
  const out: Record<string, unknown> = { [kind]: file };
  const convention: Record<string, unknown> = {};
  if (motionKind(fields) === kind) {
    for (const [path, field] of fields) {
      if (!path.startsWith('vessel.motion.convention.') || !field.given || field.value === null || field.value === undefined) continue;
      const keys = path.slice('vessel.motion.convention.'.length).split('.');
      let at = convention;
      for (const key of keys.slice(0, -1)) at = (at[key] ??= {}) as Record<string, unknown>;
      at[keys.at(-1)!] = field.value;
    }
  }
  if (Object.keys(convention).length) out.convention = convention;
  return out;
}

/** Members of a sea that its type asks for: they are shown whether they are given or not. */
export function askedOfWaves(type: unknown): string[] {
  switch (type) {
    case 'jonswap': case 'pierson_moskowitz': return ['hs', 'tp'];
    case 'airy': case 'stokes5': return ['height', 'period'];
    case 'user': return ['spectrum_file'];
    default: return [];
  }
}
