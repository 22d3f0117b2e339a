// Groups of waves, and the elevation of the water surface from the wave components used in the analysis.

/** Paths of the groups of waves: the only one, given or not, or the items of a list. */
export function waveGroups(fields: ReadonlyMap<string, { given: boolean; count?: number }>): string[] {
  const count = fields.get('environment.waves')?.count;
  return count === undefined ? ['environment.waves'] : Array.from({ length: count }, (_, i) => `environment.waves[${i}]`);
}

export interface Wave { amplitude: number; number: number; frequency: number; phase: number; direction: number }

export function elevation(waves: Wave[], x: number, y: number, t: number): number {
  let sum = 0;
  for (const w of waves) {
    sum += w.amplitude * Math.cos(w.number * (x * Math.cos(w.direction) + y * Math.sin(w.direction)) - w.frequency * t + w.phase);
  }
  return sum;
}

/** Elevations on a grid. A component is the product of a factor in x and one in y, which saves most of the cosines. */
export function surface(waves: Wave[], xs: number[], ys: number[], t: number, out: Float32Array): Float32Array {
  out.fill(0);
  const nx = xs.length;
  const xc = new Float64Array(nx), xsn = new Float64Array(nx);
  for (const w of waves) {
    const kx = w.number * Math.cos(w.direction), ky = w.number * Math.sin(w.direction);
    for (let i = 0; i < nx; ++i) { xc[i] = w.amplitude * Math.cos(kx * xs[i]!); xsn[i] = w.amplitude * Math.sin(kx * xs[i]!); }
    for (let j = 0; j < ys.length; ++j) {
      const angle = ky * ys[j]! - w.frequency * t + w.phase;
      const c = Math.cos(angle), s = Math.sin(angle);
      const row = j * nx;
      for (let i = 0; i < nx; ++i) out[row + i]! += xc[i]! * c - xsn[i]! * s;
    }
  }
  return out;
}
