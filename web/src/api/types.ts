// What the program answers; see docs/api.md. SI units, frame W. The types of results are made by the program.
import type { TableData } from '../components/document';
import type { Check, DynamicSummary, Finding, Spread, Statics, Vector, Verdict } from './results';

export type * from './results';

export interface Diagnostic { severity: 'error' | 'warning'; line: number; column: number; key: string; message: string }

export interface Field {
  path: string;
  kind: 'map' | 'list' | 'quantity' | 'number' | 'integer' | 'text' | 'choice';
  value: string | number | null;
  si: number | null;
  unit: string;
  default: string | number | null;
  given: boolean;
  line: number | null;
  text: string;
  choices?: string[];
  required?: boolean;
  left_out?: string;
  range?: string;
  count?: number;
}

export interface Info { version: string; folder: string; examples: { name: string; title: string }[]; has_model: boolean }

export interface ModelAnswer {
  text: string; name: string; saved: boolean; revision: number; diagnostics: Diagnostic[]; fields: Field[];
  /** Version of the model's file as the program last read or wrote it; null for a model without file. */
  disk?: string | null;
}

/** Save was refused: the file has become another one since it was read. */
export interface DiskConflict { error: { reason: string }; disk: { name: string; text: string; version: string }; revision?: number }

export interface Change { path: string; value: unknown }

/** A static state: of the open model with the values tried out, or of a run. */
export interface Lay extends Statics {
  status: 'converged';
  /** By name; left out while a value is dragged. */
  tables?: Record<string, TableData>;
  /** Of a dynamic run beside those of its static state. */
  run_tables?: Record<string, TableData>;
}

export interface Converged extends Lay { elapsed_ms: number; solve_ms: number; warm: boolean; revision: number }

export type StaticAnswer = Converged
  | { status: 'failed'; what: string; where: string; why: string }
  | { status: 'invalid'; diagnostics: Diagnostic[] };

export interface Structure { name: string; place: Vector; direction: Vector; length: number }

export interface Vessel { name: string; length: number; beam: number; height: number; draught: number; pose: number[] }

/** Heights at knots, linear in between: `z` along `x` from `origin`, or row by row over `x` east and `y` north. */
export interface BedShape { x: number[]; z: number[]; y?: number[]; origin?: [number, number]; along?: [number, number] }

export interface Scene {
  status: 'ok';
  /** Null where the model speaks of none. The pose is that of the vessel as described. */
  vessel: Vessel | null;
  /** Those besides the vessel that lines are on, as described. */
  bodies?: Vessel[];
  ramp: Structure[]; stinger: Structure[];
  /** Null without a pipe. */
  stern_shoe: Vector | null; tensioner: Vector | null;
  water_depth: number;
  /** `shape`: null for a plane. */
  seabed: { normal: Vector; point: Vector; shape?: BedShape | null };
  current: { depth: number; velocity: Vector }[];
  waves: { amplitude: number; number: number; frequency: number; phase: number; direction: number }[];
  /** On the bed, to be kept clear of. */
  objects: { name: string; points: Vector[] }[];
  pipe: { outer_radius: number };
}

export interface Run {
  id: string; title: string; kind: 'static' | 'dynamic' | 'seeds' | 'comparison' | 'study'; state: 'queued' | 'running' | 'done' | 'failed' | 'cancelled';
  progress: number; started: number; message: string;
  /** Of a case: the study that it belongs to. */
  parent?: string;
  /** Of a comparison: tensioner, contact or impacts. */
  of?: string;
  /** The user's. */
  name: string; note: string;
  /** Keys with their values in which its model differs from that of the run before with the same title; empty where there is none. */
  changed: string;
  /** Of a whole run, or of what was computed before it was cancelled. */
  has_results: boolean;
  /** It can go on from its checkpoint. */
  resumable?: boolean;
  /** Asked for [s]; 0 that of the model. */
  duration?: number;
  /** Once there are results: the verdict, and the largest utilisation of the governing checks. */
  verdict?: { kind: VerdictKind; words: string };
  utilisation?: number;
  time?: number; end?: number; top_tension?: number; worst_stress?: number;
}

export type VerdictKind = Verdict['kind'];

/** What the cases of a study gave; values are SI, shown times `factor` in `unit`. */
export interface Study {
  kind: 'seeds' | 'comparison';
  cases: { id: string; name: string; words: string }[];
  quantities: StudyQuantity[];
  findings: (Finding & { cases: number })[];
}
export interface StudyQuantity {
  name: string; text: string; unit: string; factor: number; values: (number | null)[];
  mean?: number | null; std?: number | null; min?: number | null; max?: number | null;
  gumbel?: { estimate: number; low: number; high: number } | null;
  acer?: { estimate: number; low: number; high: number } | null;
}

/** A study of many cases: the keys that change, the results gathered, a row per case. Numbers are in the units shown. */
export interface Matrix {
  title: string; analysis: string;
  inputs: { key: string; unit: string; with: string; sampled: boolean; words: string[]; values: (number | null)[] }[];
  outputs: { name: string; unit: string }[];
  cases: MatrixCase[];
  operability: MatrixLimits | null;
  findings: Finding[];
}
export interface MatrixCase {
  number: number; at: number[]; words: string[]; inputs: (number | null)[]; seed: number | null; state: 'open' | 'done' | 'failed';
  values: (number | null)[]; passed: boolean; verdict: VerdictKind; obstacle: string; governing: string; utilisation: number | null; reason: string;
}
/** The largest value of one key with which every check is passed, for every combination of the others. */
export interface MatrixLimits {
  over: string; unit: string; alpha: number | null;
  axes: { key: string; unit: string; words: string[]; values: (number | null)[] }[];
  cells: { at: number[]; limit: number | null; beyond: boolean; decided: boolean; governing: string; reason: string }[];
  months: number[]; year: number | null;
}

export interface Column { name: string; unit: string; text: string }
export interface Series { t: number[]; min: number[]; max: number[] }

/** A quantity that slow drift and waves move together, with both parts. */
export interface MotionSpread extends Spread { slow: Spread; wave: Spread; most_probable_min: number | null; most_probable_max: number | null }

export type MotionName = 'surge' | 'sway' | 'heave' | 'roll' | 'pitch' | 'yaw';
export type VesselInTime = Record<MotionName, MotionSpread> & { confidence: string };

export interface MooringInTime {
  name: string; fairlead_tension: MotionSpread; anchor_tension: MotionSpread; utilisation: number | null; anchor_utilisation?: number | null; parted_at: number | null;
  events: { time: number; what: string }[];
}

/** A line by itself over time. */
export interface LineInTime { name: string; first_tension: Spread; second_tension: Spread; least_tension: number; largest_tension: number; utilisation: number | null }

/** What dynamic positioning gave; yaw is a moment. */
export interface ThrustInTime { name: string; given: Spread; thrust_limit: number | null; time_at_limit: number }

export interface FatigueSpot {
  name: string; curve: string; stress_factor: number; path_damage: number; worst_rate: number; worst_s: number; standby: number;
}

/** What is read of summary.json. */
export interface RunSummary {
  findings?: Finding[];
  verdict?: Verdict;
  checks?: { list: Check[] };
  dynamic?: DynamicSummary & { verdict?: Verdict; findings?: Finding[]; vessel?: VesselInTime; thrust?: ThrustInTime[]; moorings?: MooringInTime[]; lines?: LineInTime[]; fatigue?: { spots: FatigueSpot[] } };
}

export interface NewOffer {
  pipes: { name: string; outside_diameter: number; walls: number[] }[];
  grades: { name: string; yield: number }[];
  vessels: { name: string; title: string; length: number; beam: number; depth: number; draught: number }[];
  defaults: Record<string, string | number>;
}

export type LayTableVary = 'tension' | 'lay_back' | 'depth';

/** Curves of a lay table in shown units; `least` and `largest` bound what passes every check. */
export interface LayTableCurves {
  axis: string;
  panels: { title: string; series: { name: string; points: [number, number][] }[]; limit: number | null }[];
  least: number | null; largest: number | null;
}

export interface LayTable {
  status: 'ok';
  columns: { heading: string; digits: number }[];
  rows: { kind: 'step' | 'least' | 'largest'; verdict: 'passed' | 'reserved' | 'exceeded' | 'not judged' | 'no lay'; cells: (string | number | null)[] }[];
  curves: LayTableCurves;
  findings: Finding[];
  wall_time: number;
}
export type LayTableAnswer = LayTable | { status: 'invalid'; diagnostics: Diagnostic[] };

/** An input whose tolerance moves a result; `up` and `down` are effects over that of the foremost. */
export interface SensitivityInput { key: string; name: string; text: string; tolerance: string; usual: boolean; up: number; down: number; up_text: string; down_text: string; contact: string }
export type SensitivityAnswer =
  | { status: 'converged'; results: { name: string; text: string; value: string; inputs: SensitivityInput[] }[]; assumptions: string[]; elapsed_ms: number }
  | { status: 'failed'; what: string; where: string; why: string }
  | { status: 'invalid'; diagnostics: Diagnostic[] };

/** What an import did with the data of another program. */
export interface ImportAccount { translated: string[]; approximated: string[]; left_out: { text: string; matters: boolean }[] }
