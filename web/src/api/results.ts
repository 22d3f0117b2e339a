// Types of the results sent by the program, and the units they are shown in. Generated from the program's table of
// quantities: do not edit, run `overbend schema --types > web/src/api/results.ts`. SI units, frame W.

export type Vector = [number, number, number];

export interface Region {
  bending_moment: number;
  bending_stress: number;
  strain: number;
  von_mises: number;
  utilisation: number;
  s: number;
}

export interface KeyResults {
  top_tension: number;
  bottom_tension: number;
  lay_back: number;
  suspended_length: number;
  departure_angle: number;
  stinger_tip_clearance: number | null;
  ramp_fitted_radius: number | null;
  stinger_fitted_radius: number | null;
  largest_reaction: number;
  overbend: Region | null;
  tower: Region | null;
  sagbend: Region;
}

export interface PipeLists {
  s: number[];
  x: number[];
  y: number[];
  z: number[];
  effective_tension: number[];
  bending_moment: number[];
  bending_stress: number[];
  von_mises: number[];
  strain: number[];
  utilisation: number[];
  checks: number[];
}

export interface TouchdownPlace {
  place: Vector;
  s: number;
}

export interface FreeSpanState {
  x_from: number;
  x_to: number;
  s_from: number;
  s_to: number;
  length: number;
  largest_gap: number;
  gap_x: number;
  sagging_moment: number;
  moment_x: number;
  bending_stress: number;
}

export interface LaidPipeState {
  largest_penetration: number;
  penetration_x: number;
  hogging_moment: number;
  hogging_x: number;
  sagging_moment: number;
  sagging_x: number;
  bending_stress: number;
  tail_tension: number;
  free_spans: FreeSpanState[];
}

export interface RouteSummary {
  radius: number;
  least_radius: number;
  holds: boolean;
  largest_offset: number;
  offset_x: number;
  slid_length: number;
  laid_offset: number;
  side_load_bed: number;
  side_load_supports: number;
}

export interface FrictionCase {
  name: string;
  top_tension: number;
  bottom_tension: number;
  lay_back: number;
  tip_side: number;
  off_roller: number;
  overbend_stress: number;
  sagbend_stress: number;
  largest_reaction: number;
}

export interface Roller {
  position: 'bottom' | 'port' | 'starboard';
  reaction: number;
  separation: number;
  axis: Vector;
  radius: number;
  face: number;
  center: Vector;
}

export interface Support {
  name: string;
  place: Vector;
  s: number;
  reaction: number;
  separation: number;
  structure: 'ramp' | 'stinger';
  contact: boolean;
  rollers: Roller[];
}

export interface StingerTankState {
  name: string;
  weight: number;
  buoyancy: number;
  submerged: number;
  draught: number;
}

export interface StingerSectionState {
  name: string;
  angle: number;
  floats: boolean;
  hinge: Vector;
  roller_moment: number;
  hinge_longitudinal: number;
  hinge_vertical: number;
  hinge_force: number;
  stop_moment: number;
  at_stop: boolean;
  angle_up: number;
  angle_down: number;
  stiffness: number;
  natural_period: number;
  draught: number;
  tip: Vector;
  tanks: StingerTankState[];
}

export interface TensionerPlace {
  place: Vector;
  direction: Vector;
}

export interface VesselOffset {
  surge: number;
  sway: number;
  heave: number;
  roll: number;
  pitch: number;
  yaw: number;
  natural_periods: { mode: string; period: number; }[];
}

export interface MooringLine {
  name: string;
  length: number;
  first_segment_length: number;
  fairlead_tension: number;
  horizontal: number;
  declination: number;
  anchor_tension: number;
  anchor_uplift: number;
  uplift_angle: number;
  suspended_length: number;
  touchdown_distance: number;
  on_bed: number;
  horizontal_distance: number;
  azimuth: number;
  slack: boolean;
  parted: boolean;
  fairlead: Vector;
  anchor: Vector;
  utilisation: number | null;
  anchor_utilisation: number | null;
  clearance: number | null;
  nearest_object: string;
  shape: Vector[];
}

export interface MooredState {
  name: string;
  vessel: VesselOffset;
  moorings: MooringLine[];
}

export interface Moorings {
  rest: MooredState;
  operation: string;
  stages: MooredState[];
}

export interface LineEnd {
  force: Vector;
  tension: number;
  declination: number;
}

export interface LineAtRest {
  name: string;
  length: number;
  elements: number;
  weight: number;
  on_bed: number;
  largest_tension: number;
  least_tension: number;
  utilisation: number | null;
  residual: number;
  iterations: number;
  first: LineEnd;
  second: LineEnd;
  s: number[];
  shape: Vector[];
  tension: number[];
}

export interface SheetLine {
  symbol: string;
  meaning: string;
  formula: string;
  value: number;
  units: string;
  origin: string;
  confirmation: 'not needed' | 'two or more sources' | 'one source' | 'unconfirmed';
  sources: string;
}

export interface Check {
  id: string;
  name: string;
  code: string;
  clause: string;
  region: 'line' | 'overbend' | 'stinger tip' | 'sagbend' | 'seabed' | 'tower';
  status: 'passed' | 'exceeded' | 'outside validity' | 'not done';
  governing: boolean;
  remark: string;
  line: string;
  utilisation?: number;
  reserve?: number;
  quantity?: string;
  capacity?: number;
  units?: string;
  at?: { from_top: number; };
  time?: number | null;
  sheet: SheetLine[];
}

export interface Finding {
  code: string;
  severity: 'serious' | 'caution' | 'note';
  message: string;
  object?: string;
  from_top?: number;
  time?: number;
  accepted?: boolean;
}

export interface Verdict {
  kind: 'passed' | 'reserved' | 'exceeded' | 'not judged';
  words: string;
  because: string;
}

export interface Statics {
  key: KeyResults | null;
  pipe: PipeLists;
  touchdown: TouchdownPlace | null;
  seabed?: LaidPipeState;
  route?: RouteSummary;
  roller_friction?: FrictionCase[];
  supports: Support[];
  stinger?: StingerSectionState[];
  tensioner: TensionerPlace | null;
  moorings: Moorings | null;
  lines: LineAtRest[];
  checks: Check[];
  findings: Finding[];
  verdict: Verdict;
}

export interface StageValues {
  top_tension: number | null;
  bottom_tension: number | null;
  head_x: number | null;
  head_z: number | null;
  head_clearance: number | null;
  cable_tension: number | null;
  cable_utilisation: number | null;
  sagbend_von_mises: number | null;
  sagbend_strain: number | null;
  overbend_strain: number | null;
  stinger_tip_clearance: number | null;
  largest_reaction: number | null;
  largest_reaction_support: string;
  lay_back: number | null;
  end_height: number | null;
  largest_moment: number | null;
  largest_bending_stress: number | null;
  davit_tension: number | null;
  utilisation: number | null;
  check: string;
  verdict: string;
}

export interface LineParts {
  head_from: number;
  head_to: number;
  cable_at_far_end: boolean;
}

export interface StageFailure {
  what: string;
  where: string;
  why: string;
  least_tension: number | null;
}

export interface OperationStage {
  name: string;
  out: number | null;
  tension: number | null;
  barge_ahead: number;
  governing: string;
  values: StageValues | null;
  parts: LineParts | null;
  failure: StageFailure | null;
  findings: Finding[];
}

export interface HoldPoint {
  stage: number;
  what: string;
  out: number | null;
}

export interface Operation {
  title: string;
  out_name: string;
  stages: OperationStage[];
  hold_points: HoldPoint[];
  findings: Finding[];
}

export interface Band {
  static: number[];
  min?: number[];
  max?: number[];
  mean?: number[];
}

export interface Envelopes {
  s: number[];
  x: number[];
  z: number[];
  effective_tension: Band;
  bending_moment: Band;
  bending_stress: Band;
  von_mises: Band;
  strain: Band;
}

export interface Impact {
  support: string;
  row: number;
  position: 'bottom' | 'port' | 'starboard';
  time: number;
  approach_velocity: number;
  peak_force: number;
  duration: number;
  impulse: number;
  dent_depth: number;
  line_load: number;
}

export interface Spread {
  min: number;
  max: number;
  mean: number;
  std: number;
}

export interface ExtremeOverTime {
  min: number;
  max: number;
  mean: number;
  std: number;
  at: { s: number; x: number; y: number; z: number; };
  time: number;
}

export interface RegionSummary {
  max_bending_moment: ExtremeOverTime;
  max_bending_stress: ExtremeOverTime;
  max_strain: ExtremeOverTime;
  max_von_mises: ExtremeOverTime;
}

export interface SupportSummary {
  name: string;
  s: number;
  reaction: Spread;
  reaction_percentiles: { p50: number; p90: number; p99: number; };
  vertical: Spread;
  longitudinal: Spread;
  lateral: Spread;
  separation: Spread;
  contact_share: number;
  impacts: number;
  left_to_port: number | null;
  left_to_starboard: number | null;
  structure: 'ramp' | 'stinger';
  rows: unknown[];
}

export interface CheckInFull {
  id: string;
  name: string;
  code: string;
  clause: string;
  region: 'line' | 'overbend' | 'stinger tip' | 'sagbend' | 'seabed' | 'tower';
  status: 'passed' | 'exceeded' | 'outside validity' | 'not done';
  governing: boolean;
  utilisation?: number;
  reserve?: number;
  quantity?: string;
  demand?: number;
  capacity?: number;
  units?: string;
  at?: { s: number; from_top: number; x: number; y: number; z: number; };
  time?: number | null;
  remark: string;
  line: string;
  inputs: { symbol: string; meaning: string; value: number; units: string; }[];
  sheet: SheetLine[];
}

export interface DynamicSummary {
  duration: number;
  build_up: number;
  output_step: number;
  seed: number;
  assumption_ranks: string[];
  assumptions: string[];
  warnings: string[];
  findings: Finding[];
  non_stationary: string;
  impact_count: number;
  top_tension: Spread;
  bottom_tension: Spread;
  lay_back: Spread;
  departure_angle: Spread;
  stinger_tip_clearance: Spread | null;
  smallest_tension: ExtremeOverTime;
  overbend: RegionSummary | null;
  tower: RegionSummary | null;
  sagbend: RegionSummary;
  supports: SupportSummary[];
  impacts: { name: string; count: number; largest_impact_force: number; largest_approach_velocity: number; largest_impulse: number; dent_depth: number; line_load: number; }[];
  tensioner: { mode: string; wanted: number; range_low: number; range_high: number; travel_limit: number; min_tension: number; max_tension: number; mean_tension: number; std_tension: number; travel_min: number; travel_max: number; travel_mean: number; travel_std: number; time_out_of_range: number; time_holding: number; time_delayed: number; time_paying_out: number; time_hauling_in: number; time_at_limit: number; pay_out_count: number; haul_in_count: number; limit_count: number; };
  extremes: ({ name: string; units: string; smallest: boolean; peaks: number; observed: number; estimate: number | null; low: number | null; high: number | null; method: string; quality: string; remark: string; weibull: { estimate: number | null; low: number | null; high: number | null; }; gumbel: { estimate: number | null; low: number | null; high: number | null; }; pareto: { estimate: number | null; low: number | null; high: number | null; }; enough: boolean; })[];
  energy_drift: number;
  steps: number;
  rejected_steps: number;
  newton_iterations: number;
  factorisations: number;
  smallest_step: number;
  largest_step: number;
  wall_time: number;
  real_time_ratio: number;
  integrator: string;
  checks: { worst: CheckInFull | null; list: CheckInFull[]; };
}

/** Unit in which values are shown: value times `factor`, with `digits` decimals, `more` than for metric units. */
export interface ShownUnit { unit: string; factor: number; digits: number; more: number }

/** By system and SI unit. */
export const shownUnits: Record<'metric' | 'us', Record<string, ShownUnit>> = {
  metric: {
    'N': { unit: 'kN', factor: 0.001, digits: 1, more: 0 },
    'N m': { unit: 'kN m', factor: 0.001, digits: 1, more: 0 },
    'N/m': { unit: 'kN/m', factor: 0.001, digits: 1, more: 0 },
    'N s': { unit: 'kN s', factor: 0.001, digits: 3, more: 0 },
    'Pa': { unit: 'MPa', factor: 1e-06, digits: 1, more: 0 },
    'J': { unit: 'kJ', factor: 0.001, digits: 3, more: 0 },
    'rad': { unit: 'deg', factor: 57.29577951308232, digits: 2, more: 0 },
    'rad/s': { unit: 'deg/s', factor: 57.29577951308232, digits: 3, more: 0 },
    'm': { unit: 'm', factor: 1, digits: 3, more: 0 },
    's': { unit: 's', factor: 1, digits: 4, more: 0 },
    '1': { unit: '–', factor: 1, digits: 6, more: 0 },
    '-': { unit: '–', factor: 1, digits: 6, more: 0 },
    'm/s': { unit: 'm/s', factor: 1, digits: 3, more: 0 },
    'm/s2': { unit: 'm/s2', factor: 1, digits: 3, more: 0 },
    'm3': { unit: 'm3', factor: 1, digits: 3, more: 0 },
    '1/m': { unit: '1/m', factor: 1, digits: 3, more: 0 },
    'N m2': { unit: 'kN m2', factor: 0.001, digits: 1, more: 0 },
    'N m/rad': { unit: 'kN m/rad', factor: 0.001, digits: 1, more: 0 },
    'N/m2': { unit: 'kN/m2', factor: 0.001, digits: 1, more: 0 },
    'N/m3': { unit: 'kN/m3', factor: 0.001, digits: 2, more: 0 },
    'kg': { unit: 't', factor: 0.001, digits: 1, more: 0 },
    'kg/m': { unit: 'kg/m', factor: 1, digits: 2, more: 0 },
  },
  us: {
    'N': { unit: 'kip', factor: 0.0002248089430997105, digits: 2, more: 1 },
    'N m': { unit: 'kip ft', factor: 0.0007375621492772653, digits: 2, more: 1 },
    'N/m': { unit: 'lbf/ft', factor: 0.06852176585679176, digits: 0, more: -1 },
    'N s': { unit: 'kip s', factor: 0.0002248089430997105, digits: 4, more: 1 },
    'Pa': { unit: 'ksi', factor: 1.4503773773020921e-07, digits: 2, more: 1 },
    'J': { unit: 'kip ft', factor: 0.0007375621492772653, digits: 4, more: 1 },
    'rad': { unit: 'deg', factor: 57.29577951308232, digits: 2, more: 0 },
    'rad/s': { unit: 'deg/s', factor: 57.29577951308232, digits: 3, more: 0 },
    'm': { unit: 'ft', factor: 3.280839895013123, digits: 3, more: 0 },
    's': { unit: 's', factor: 1, digits: 4, more: 0 },
    '1': { unit: '–', factor: 1, digits: 6, more: 0 },
    '-': { unit: '–', factor: 1, digits: 6, more: 0 },
    'm/s': { unit: 'ft/s', factor: 3.280839895013123, digits: 3, more: 0 },
    'm/s2': { unit: 'ft/s2', factor: 3.280839895013123, digits: 3, more: 0 },
    'm3': { unit: 'ft3', factor: 35.314666721488585, digits: 2, more: -1 },
    '1/m': { unit: '1/ft', factor: 0.3048, digits: 4, more: 1 },
    'N m2': { unit: 'kip ft2', factor: 0.0024198233244004767, digits: 1, more: 0 },
    'N m/rad': { unit: 'kip ft/rad', factor: 0.0007375621492772653, digits: 2, more: 1 },
    'N/m2': { unit: 'lbf/ft2', factor: 0.02088543423315013, digits: 0, more: -1 },
    'N/m3': { unit: 'lbf/ft3', factor: 0.0063658803542641605, digits: 2, more: 0 },
    'kg': { unit: 'lb', factor: 2.2046226218487757, digits: 0, more: -3 },
    'kg/m': { unit: 'lb/ft', factor: 0.6719689751395068, digits: 3, more: 1 },
  },
};

/** Quantities along the pipe: key in the lists, name, and how SI values are shown. */
export const quantities = [
  { key: 'effective_tension', name: 'Effective tension', metric: { unit: 'kN', factor: 0.001, digits: 1, more: 0 }, us: { unit: 'kip', factor: 0.0002248089430997105, digits: 2, more: 1 } },
  { key: 'bending_moment', name: 'Bending moment', metric: { unit: 'kN m', factor: 0.001, digits: 1, more: 0 }, us: { unit: 'kip ft', factor: 0.0007375621492772653, digits: 2, more: 1 } },
  { key: 'bending_stress', name: 'Bending stress', metric: { unit: 'MPa', factor: 1e-06, digits: 1, more: 0 }, us: { unit: 'ksi', factor: 1.4503773773020921e-07, digits: 2, more: 1 } },
  { key: 'von_mises', name: 'von Mises stress', metric: { unit: 'MPa', factor: 1e-06, digits: 1, more: 0 }, us: { unit: 'ksi', factor: 1.4503773773020921e-07, digits: 2, more: 1 } },
  { key: 'strain', name: 'Strain', metric: { unit: '%', factor: 100, digits: 4, more: 0 }, us: { unit: '%', factor: 100, digits: 4, more: 0 } },
  { key: 'utilisation', name: 'von Mises stress / yield stress', metric: { unit: '–', factor: 1, digits: 6, more: 0 }, us: { unit: '–', factor: 1, digits: 6, more: 0 } },
  { key: 'checks', name: 'Utilisation of code checks', metric: { unit: '–', factor: 1, digits: 6, more: 0 }, us: { unit: '–', factor: 1, digits: 6, more: 0 } },
] as const;
