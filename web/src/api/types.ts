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
}

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
  governing: boolean; remark: string; utilisation?: number; reserve?: number; at?: { from_top: number }; time?: number | null;
}

export interface Support {
  name: string; structure: 'ramp' | 'stinger'; place: Vector; s: number; reaction: number; separation: number; contact: boolean; rollers: Roller[];
}

export interface PipeLists {
  s: number[]; x: number[]; y: number[]; z: number[]; tension: number[]; moment: number[];
  bending_stress: number[]; von_mises: number[]; strain: number[]; utilisation: number[]; checks: number[];
}

export interface Converged {
  status: 'converged';
  elapsed_ms: number; solve_ms: number; warm: boolean; revision: number;
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
  id: string; title: string; kind: 'static' | 'dynamic'; state: 'queued' | 'running' | 'done' | 'failed' | 'cancelled';
  progress: number; started: number; message: string;
  time?: number; end?: number; top_tension?: number; worst_stress?: number;
}

export interface Column { name: string; unit: string; text: string }
export interface Series { t: number[]; min: number[]; max: number[] }
export type Band = { static: number[]; min?: number[]; max?: number[]; mean?: number[] };
export interface Envelopes { s: number[]; x: number[]; z: number[]; tension: Band; moment: Band; bending_stress: Band; von_mises: Band; strain: Band }

export interface Impact { time: number; support: string; row: number; position: string; peak_force: number; approach_velocity: number }

export interface NewOffer {
  pipes: { name: string; outside_diameter: number; walls: number[] }[];
  grades: { name: string; yield: number }[];
  vessels: { name: string; title: string; length: number; beam: number; depth: number; draught: number }[];
  defaults: Record<string, string | number>;
}
