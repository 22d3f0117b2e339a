// A first operation on the line, sized from the solved lay: head, cable and stages that reach the seabed.
import type { Change } from '../api/types';
import { tidy } from './units';

export const firstOperations = ['abandonment', 'recovery', 'lay_down', 'start_up', 'move', 'shore_pull', 'hold_back', 'passage', 'ballast', 'lift'] as const;
export type FirstOperation = (typeof firstOperations)[number];

/** The lay data used for a first operation. SI units; `tip` and `touchdown` are arc lengths from the tensioner. */
export interface LaySize {
  joint: number; tip: number; touchdown: number;
  /** Top tension, and horizontal tension at touchdown. */
  tension: number; bottomTension: number;
  /** Height of the tensioner above the water. */
  height: number;
  /** Water depth at a horizontal distance from the tensioner. */
  depthAt: (distance: number) => number;
}

/** Model parts that some operations require: a structure in the pipe, a tank of the stinger, lines on a pipe with their lengths in m. */
export interface OperationParts { structure: string; tank: string; davits: { name: string; length: number }[] }

/** Reason why the model cannot have an operation; empty if it can. */
export function missingPart(type: FirstOperation, parts: OperationParts): string {
  if (type === 'passage' && !parts.structure) return 'requires a structure in the pipe (pipe.structures)';
  if (type === 'ballast' && !parts.tank) return 'requires a tank in the stinger (supports.stinger.tanks)';
  if (type === 'lift' && parts.davits.length === 0) return 'requires lines attached to another line';
  return '';
}

/** Operations that need no solved lay: none of their values depends on it. */
export const needsLay = (type: FirstOperation): boolean => type !== 'ballast' && type !== 'lift';

// Six-strand wire rope with a wire core, over its squared diameter, as the program derives it from the diameter.
const rope = { weight: 39126, submerged: 34070, stiffness: 4.04e10, breaking: 6.334e8 };
const ropeSizes = [13, 16, 19, 22, 26, 32, 38, 44, 52, 58, 64, 70, 76, 83, 89, 96, 102, 114, 127, 140, 152];
const breakingOverTension = 3;
const headLength = 6;
const steelInWater = 0.87; // submerged weight over weight in air

/** Length of a cable with the top tension `tension`, from its top down by `height` to its end, where `lift` pulls upwards. */
export function suspendedLength(tension: number, height: number, weight: number, lift: number): number {
  const end = Math.max(tension - weight * height, 0);
  const up = Math.min(lift, end);
  return (Math.sqrt(tension ** 2 - end ** 2 + up ** 2) - up) / weight;
}

interface Sized { diameter: number; submerged: number; headWeight: number }

function sized(lay: LaySize): Sized {
  const depth = lay.depthAt(lay.touchdown);
  const millimetres = ropeSizes.find((d) => rope.breaking * (d / 1e3) ** 2 >= breakingOverTension * lay.tension) ?? ropeSizes.at(-1)!;
  const pipeWeight = (lay.tension - lay.bottomTension) / (depth + lay.height);
  // Heavier than the pipe by at most half of the bottom tension: the lay tension carries it at any depth.
  const headWeight = Math.max(Math.min(0.1 * lay.tension, headLength * pipeWeight + 0.5 * lay.bottomTension), 100);
  return { diameter: millimetres / 1e3, submerged: rope.submerged * (millimetres / 1e3) ** 2, headWeight };
}

/** Water depth at the end of the operation: on a sloping seabed that of the head, not that of the touchdown of the lay. */
function toTheBed(lay: LaySize, weight: number, lift: number): number {
  let length = lay.touchdown;
  for (let i = 0; i < 4; ++i) length = suspendedLength(lay.tension, lay.depthAt(length) + lay.height, weight, lift);
  return length;
}

const metres = (v: number): string => `${Math.max(1, Math.round(v))} m`;
const perMetre = (v: number): string => `${tidy(v, 3)} N/m`;
const force = (v: number): string => `${tidy(v / 1e3, 3)} kN`;

const set = (key: string, value: unknown): Change => ({ path: `operation.${key}`, value });
const evenStages = (from: number, to: number, steps: number): Change => set('stages', { from: metres(from), to: metres(to), steps, tension: 'hold' });

const headKeys = (weight: number): Change => set('head', { length: `${headLength} m`, weight_in_air: force(weight / steelInWater), weight_submerged: force(weight) });

function cableKeys(diameter: number): Record<string, string> {
  const d2 = diameter ** 2;
  return {
    diameter: `${tidy(1e3 * diameter)} mm`, weight_in_air: perMetre(rope.weight * d2), weight_submerged: perMetre(rope.submerged * d2),
    axial_stiffness: force(rope.stiffness * d2), breaking_load: force(rope.breaking * d2),
  };
}

function startUp(lay: LaySize): Change[] {
  const { diameter, submerged, headWeight } = sized(lay);
  // long enough that the anchor is hardly lifted while the cable is fully suspended
  const length = 1.1 * toTheBed(lay, submerged, 0), depth = lay.depthAt(length + lay.touchdown);
  return [
    set('type', 'start_up'), headKeys(headWeight), set('cable', { ...cableKeys(diameter), length: metres(length) }),
    set('anchor', { depth: `${tidy(depth - diameter / 2, 7)} m` }), evenStages(lay.tip + 10, lay.touchdown, 6),
  ];
}

/** The head is lowered on the cable, or recovered: both list their stages from the vessel to the seabed. */
function toOrFromBed(type: FirstOperation, lay: LaySize): Change[] {
  const { diameter, submerged, headWeight } = sized(lay);
  // half of the head's weight at the end of the cable would lift it; over the rollers the cable is longer by less than to the tip
  const out = 1.02 * (lay.tip + toTheBed(lay, submerged, headWeight / 4));
  return [set('type', type), headKeys(headWeight), set('cable', cableKeys(diameter)), evenStages(0.3 * lay.tip, Math.ceil(out), 10)];
}

const pullLength = 600; // m of pipe above the seabed, for which friction leaves a tension
const pullFriction = 0.5;

/** Pipe that a winch on the seabed pulls from the vessel; held back, friction may use up to half of the tension. */
function pull(type: 'shore_pull' | 'hold_back', lay: LaySize): Change[] {
  const { headWeight } = sized(lay), depth = lay.depthAt(lay.touchdown);
  const weight = (lay.tension - lay.bottomTension) / (depth + lay.height);
  const length = type === 'shore_pull' ? pullLength : Math.min(pullLength, (0.4 * lay.bottomTension) / (pullFriction * weight));
  const from = 1.2 * lay.touchdown, to = from + length, distance = to + 100;
  const { diameter } = sized({ ...lay, tension: lay.tension + pullFriction * weight * length });
  return [
    set('type', type), headKeys(headWeight), set('cable', cableKeys(diameter)),
    set('winch', { distance: metres(distance), depth: `${tidy(lay.depthAt(distance) - diameter / 2, 7)} m` }), evenStages(from, to, 8),
  ];
}

/** Hauls in every davit cable in steps of 2 m, by at most half of its length. */
function lift(davits: OperationParts['davits']): Change[] {
  const step = Math.min(2, ...davits.map((d) => d.length / 8));
  const lengths = (k: number): Record<string, string> => Object.fromEntries(davits.map((d) => [d.name, `${tidy(d.length - k * step, 4)} m`]));
  return [set('type', 'lift'), set('stages', [0, 1, 2, 3, 4].map((k) => ({ name: k ? `hauled in ${tidy(k * step, 3)} m` : 'initial lengths', lengths: lengths(k) })))];
}

/** Stages at the lay tension, to be changed afterwards. `lay` may be null if needsLay() is false. */
export function firstOperation(type: FirstOperation, lay: LaySize | null, parts: OperationParts = { structure: '', tank: '', davits: [] }): Change[] {
  if (type === 'lift') return lift(parts.davits);
  if (type === 'ballast') return [set('type', type), set('tank', parts.tank), set('stages', [0, 0.25, 0.5, 0.75, 1].map((ballast) => ({ ballast })))];
  if (!lay) return [];
  if (type === 'move') return [set('type', type), set('stages', { from: '0 m', to: metres(lay.joint), steps: 4, tension: 'hold' })];
  if (type === 'passage') return [set('type', type), set('structure', parts.structure), evenStages(Math.max(4, 0.05 * lay.tip), lay.touchdown, 20)];
  if (type === 'start_up') return startUp(lay);
  return type === 'shore_pull' || type === 'hold_back' ? pull(type, lay) : toOrFromBed(type, lay);
}
