// A first operation on the line, sized by the lay that is solved: head, cable and stages that reach the seabed.
import type { Change } from '../api/types';
import { tidy } from './units';

export type FirstOperation = 'abandonment' | 'start_up' | 'move';

/** The lay as far as a first operation needs it. SI units; `tip` and `touchdown` along the pipe from the tensioner. */
export interface LaySize {
  joint: number; tip: number; touchdown: number;
  /** Tension at the top, and the horizontal one at touchdown. */
  tension: number; bottomTension: number;
  /** Height of the tensioner above the water. */
  height: number;
  /** Water depth at a horizontal distance from the tensioner. */
  depthAt: (distance: number) => number;
}

// Six-strand wire rope with a wire core, over its squared diameter, as the program makes it of its diameter.
const rope = { weight: 39126, submerged: 34070, stiffness: 4.04e10, breaking: 6.334e8 };
const ropeSizes = [13, 16, 19, 22, 26, 32, 38, 44, 52, 58, 64, 70, 76, 83, 89, 96, 102, 114, 127, 140, 152];
const breakingOverTension = 3;
const headLength = 6;
const steelInWater = 0.87; // submerged weight over weight in air

/** Length of a cable with `tension` at the top, from the top down by `height` to where `lift` pulls upwards at its end. */
export function hangingLength(tension: number, height: number, weight: number, lift: number): number {
  const end = Math.max(tension - weight * height, 0);
  const up = Math.min(lift, end);
  return (Math.sqrt(tension ** 2 - end ** 2 + up ** 2) - up) / weight;
}

interface Sized { diameter: number; submerged: number; headWeight: number }

function sized(lay: LaySize): Sized {
  const depth = lay.depthAt(lay.touchdown);
  const millimetres = ropeSizes.find((d) => rope.breaking * (d / 1e3) ** 2 >= breakingOverTension * lay.tension) ?? ropeSizes.at(-1)!;
  const pipeWeight = (lay.tension - lay.bottomTension) / (depth + lay.height);
  // Heavier than the pipe by no more than half of the bottom tension: the tension of the lay carries it at any depth.
  const headWeight = Math.max(Math.min(0.1 * lay.tension, headLength * pipeWeight + 0.5 * lay.bottomTension), 100);
  return { diameter: millimetres / 1e3, submerged: rope.submerged * (millimetres / 1e3) ** 2, headWeight };
}

/** Where it ends the depth counts: on a bed that slopes down, that of the head and not that of the lay's touchdown. */
function toTheBed(lay: LaySize, weight: number, lift: number): number {
  let length = lay.touchdown;
  for (let i = 0; i < 4; ++i) length = hangingLength(lay.tension, lay.depthAt(length) + lay.height, weight, lift);
  return length;
}

const metres = (v: number): string => `${Math.max(1, Math.round(v))} m`;
const perMetre = (v: number): string => `${tidy(v, 3)} N/m`;
const force = (v: number): string => `${tidy(v / 1e3, 3)} kN`;

/** Generated stages at the tension of the tensioner, to be changed in the form. */
export function firstOperation(type: FirstOperation, lay: LaySize): Change[] {
  const set = (key: string, value: unknown): Change => ({ path: `operation.${key}`, value });
  const stages = (from: number, to: number, steps: number): Change => set('stages', { from: metres(from), to: metres(to), steps, tension: 'hold' });
  if (type === 'move') return [set('type', type), set('stages', { from: '0 m', to: metres(lay.joint), steps: 4, tension: 'hold' })];
  const { diameter, submerged, headWeight } = sized(lay), d2 = diameter ** 2;
  const head = { length: `${headLength} m`, weight_in_air: force(headWeight / steelInWater), weight_submerged: force(headWeight) };
  const cable = { diameter: `${tidy(1e3 * diameter)} mm`, weight_in_air: perMetre(rope.weight * d2), weight_submerged: perMetre(submerged), axial_stiffness: force(rope.stiffness * d2), breaking_load: force(rope.breaking * d2) };
  if (type === 'start_up') {
    // long enough that the anchor is hardly lifted while all of the cable hangs
    const length = 1.1 * toTheBed(lay, submerged, 0), far = lay.depthAt(length + lay.touchdown);
    return [set('type', type), set('head', head), set('cable', { ...cable, length: metres(length) }), set('anchor', { depth: `${tidy(far - diameter / 2, 7)} m` }), stages(lay.tip + 10, lay.touchdown, 6)];
  }
  // half of the head's weight at the end of the cable would lift it; over the rollers the cable is longer by less than to the tip
  const out = 1.02 * (lay.tip + toTheBed(lay, submerged, headWeight / 4));
  return [set('type', type), set('head', head), set('cable', cable), stages(0.3 * lay.tip, Math.ceil(out), 10)];
}
