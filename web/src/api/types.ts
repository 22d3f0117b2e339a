// What the program answers; see docs/api.md. SI units, frame W.

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

export type Vector = [number, number, number];

export interface Region {
  bending_moment: number; bending_stress: number; von_mises: number; strain: number; utilisation: number; s: number;
}

export interface Roller { position: string; center: Vector; axis: Vector; radius: number; face: number; reaction: number; separation: number }

/** A code check at the place where it is used most; without utilisation where it is not done. */
export interface Check {
  id: string; name: string; code: string; clause: string; region: string;
  status: 'passed' | 'exceeded' | 'outside validity' | 'not done';
  governing: boolean; remark: string; quantity?: string; units?: string; capacity?: number; utilisation?: number; reserve?: number; at?: { from_top: number }; time?: number | null;
}

export interface Support {
  name: string; structure: 'ramp' | 'stinger'; place: Vector; s: number; reaction: number; separation: number; contact: boolean; rollers: Roller[];
}

export interface PipeLists {
  s: number[]; x: number[]; y: number[]; z: number[]; tension: number[]; moment: number[];
  bending_stress: number[]; von_mises: number[]; strain: number[]; utilisation: number[]; checks: number[];
}

/** A static state: of the open model with the values tried out, or of a run. */
export interface Lay {
  status: 'converged';
  key: {
    top_tension: number; bottom_tension: number; lay_back: number; departure_angle: number; tip_clearance: number | null;
    suspended_length: number; largest_reaction: number | { value: number; support: string } | null; overbend: Region | null; tower?: Region | null; sagbend: Region | null;
  };
  pipe: PipeLists;
  touchdown: { s: number; place: Vector } | null;
  supports: Support[];
  tensioner: { place: Vector; direction: Vector };
  checks: Check[];
  warnings: string[];
}

export interface Converged extends Lay { elapsed_ms: number; solve_ms: number; warm: boolean; revision: number }

export type StaticAnswer = Converged
  | { status: 'failed'; what: string; where: string; why: string }
  | { status: 'invalid'; diagnostics: Diagnostic[] };

export interface Structure { name: string; place: Vector; direction: Vector; length: number }

export interface Scene {
  status: 'ok';
  vessel: { name: string; length: number; beam: number; height: number; draught: number; pose: number[] };
  ramp: Structure[]; stinger: Structure[];
  stern_shoe: Vector; tensioner: Vector; water_depth: number;
  seabed: { normal: Vector; point: Vector };
  current: { depth: number; velocity: Vector }[];
  waves: { amplitude: number; number: number; frequency: number; phase: number; direction: number }[];
  pipe: { outer_radius: number };
}

export interface Run {
  id: string; title: string; kind: 'static' | 'dynamic' | 'seeds' | 'comparison'; state: 'queued' | 'running' | 'done' | 'failed' | 'cancelled';
  progress: number; started: number; message: string;
  /** Of a case: the study that it belongs to. */
  parent?: string;
  /** Of a comparison: tensioner or contact. */
  of?: string;
  /** The user's. */
  name: string; note: string;
  /** Of a whole run, or of what was computed before it was cancelled. */
  has_results: boolean;
  /** It can go on from its checkpoint. */
  resumable?: boolean;
  time?: number; end?: number; top_tension?: number; worst_stress?: number;
}

/** What the cases of a study gave; values are SI, shown times `factor` in `unit`. */
export interface Study {
  kind: 'seeds' | 'comparison';
  cases: { id: string; name: string; words: string }[];
  quantities: StudyQuantity[];
  warnings: { text: string; cases: number }[];
}
export interface StudyQuantity {
  name: string; text: string; unit: string; factor: number; values: (number | null)[];
  mean?: number | null; std?: number | null; min?: number | null; max?: number | null;
  gumbel?: { estimate: number; low: number; high: number } | null;
}

export interface Column { name: string; unit: string; text: string }
export interface Series { t: number[]; min: number[]; max: number[] }
export type Band = { static: number[]; min?: number[]; max?: number[]; mean?: number[] };
export interface Envelopes { s: number[]; x: number[]; z: number[]; tension: Band; moment: Band; bending_stress: Band; von_mises: Band; strain: Band }

export interface Spread { min: number; max: number; mean: number; std: number }
export interface RegionSummary { max_bending_moment: Spread; max_bending_stress: Spread; max_von_mises: Spread; max_strain: Spread }

/** What is read of summary.json. */
export interface RunSummary {
  warnings?: string[];
  checks?: { list: Check[] };
  dynamic?: {
    duration: number; seed: number; impact_count: number; warnings?: string[]; checks?: { list: Check[] };
    top_tension: Spread; bottom_tension: Spread; lay_back: Spread; departure_angle: Spread; stinger_tip_clearance: Spread | null;
    overbend: RegionSummary | null; tower?: RegionSummary | null; sagbend: RegionSummary | null;
    supports: { name: string; reaction: Spread; separation: Spread }[];
  };
}

export interface Impact { time: number; support: string; row: number; position: string; peak_force: number; approach_velocity: number }

export interface NewOffer {
  pipes: { name: string; outside_diameter: number; walls: number[] }[];
  grades: { name: string; yield: number }[];
  vessels: { name: string; title: string; length: number; beam: number; depth: number; draught: number }[];
  defaults: Record<string, string | number>;
}
