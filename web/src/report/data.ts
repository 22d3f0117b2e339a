// Data of the figures, as written by the program into a report (src/overbend/report): in SI, along the pipe from the
// tensioner on, unless a name states otherwise. In alphabetical order of the blocks.
import type { LayData, Position } from '../components/lay';
import type { MooringSpread } from '../components/mooringSpread';
import type { OperabilityData } from '../components/Operability';
import type { Vector } from '../components/painter';

import type { LayTableCurves } from '../api/types';

// checks ----------------------------------------------------------------------------------------------------------------

/** Utilisation along the pipe; 0 if a check is not evaluated. */
export type ChecksData = Record<'s' | 'api' | 'stress' | 'load' | 'strain' | 'laying' | 'governing', number[]>;

// comparison ------------------------------------------------------------------------------------------------------------

export interface ComparedTensionerRun {
  name: 'off' | 'controlled' | 'constant';
  tension: Trace;
  travel: Trace;
  /** Beginning and end [s], and the index of the state. */
  states: [from: number, to: number, state: number][];
  /** Beginning of the detail at the end of the run [s]. */
  close: Record<'time' | 'tension' | 'travel', number[]>;
}

interface ComparisonData { duration: number; build_up: number; close_from: number }

/** Tensions and travels in their shown units. */
export interface ComparedTensioner extends ComparisonData {
  range: [number, number] | null;
  limit: number | null;
  runs: ComparedTensionerRun[];
}

export type ComparedQuantity = 'contact_share' | 'static_reaction' | 'mean_reaction' | 'peak_reaction' | 'peak_force' | 'dent_depth' | 'line_load';

export type ComparedBoxRun = Record<ComparedQuantity, number> & Record<'row_contact_share' | 'row_peak_force', number[]>;

/** Results for each box, in SI. */
export interface ComparedContact extends ComparisonData {
  runs: { name: string; words: string }[];
  boxes: { name: string; runs: ComparedBoxRun[] }[];
  shown: Record<ComparedQuantity, ShownColumn>;
}

// curves ----------------------------------------------------------------------------------------------------------------

export interface NamedCurve { name: string; points: [number, number][] }

/** Data of a figure "curves": values as shown, the units are in the labels of the axes. */
export interface CurvesData {
  across: string;
  up: string;
  /** `look`: circles at the points are "marks"; `colour`: index of its colour, by default the index of the curve. */
  curves: (NamedCurve & { look: 'line' | 'thin' | 'marks'; colour?: number; in_legend: boolean })[];
  /** Lines of the surroundings; only their heights extend the figure. */
  ground: NamedCurve[];
  water: NamedCurve[];
}

// dynamic ---------------------------------------------------------------------------------------------------------------

export type EnvelopeData = Record<'min' | 'max' | 'mean' | 'static', number[]>;

/** Location and time of the maximum of a region. */
export type DynamicRegionData = Record<string, { s: number; time: number; value: number; place: string } | undefined>;

interface OverTime { min: number; max: number; mean: number }

export interface DynamicRollerData { contact_share: number; impact_count: number; static_reaction: number; reaction: OverTime }

export interface ImpactData { box: string; row: number; position: Position; time: number; approach_velocity: number; peak_force: number }

/** Minimum and maximum of equal time intervals, as multiples of a quantum above the lowest. */
export interface Trace { lowest: number; quantum: number; low: (number | null)[]; high: (number | null)[] }

/** In the unit of the history. */
export interface HistoryData extends Trace {
  group: string;
  title: string;
  unit: string;
  digits: number;
  over_time: OverTime & { std: number };
  static: number | null;
  /** A range of values. */
  shade?: [number, number];
  /** Low-frequency part. */
  slow?: Trace;
}

export interface SpectrumData { title: string; unit: string; frequency: number[]; density: number[] }

export interface FatigueData {
  s: number[];
  /** `rate`: damage per hour. */
  spots: { name: string; curve: string; rate: number[] }[];
}

export interface DynamicData {
  duration: number;
  build_up: number;
  envelopes: { s: number[] } & Record<string, EnvelopeData>;
  overbend: DynamicRegionData | null;
  tower: DynamicRegionData | null;
  sagbend: DynamicRegionData;
  supports: { name: string; rows: Partial<Record<Position, DynamicRollerData>>[] }[];
  impacts: ImpactData[];
  fatigue: FatigueData | null;
  histories: HistoryData[];
  spectra: SpectrumData[];
}

// lay -------------------------------------------------------------------------------------------------------------------

/** Format of a column of the stations. */
export interface ShownColumn { unit: string; factor: number; digits: number }

export type RegionData = Record<string, { s: number; value: number; place: string } | undefined>;

/** Data of a model with a pipe. */
export interface PipeData extends LayData {
  shown: Record<string, ShownColumn>;
  overbend: RegionData | null;
  tower: RegionData | null;
  sagbend: RegionData;
  checks?: ChecksData | null;
  dynamic?: DynamicData;
}

// lines -----------------------------------------------------------------------------------------------------------------

/** A line other than the pipe, from its first end: positions in world axes, static tensions and those of a run. */
export interface LineData { name: string; s: number[]; places: Vector[]; tension: number[]; least: number[]; largest: number[] }

export interface LinesReport { lines: LineData[]; water_depth: number; moved: boolean }

// moorings --------------------------------------------------------------------------------------------------------------

export interface OffsetRange { min: number; max: number; mean: number; std: number }

/** Offsets of the vessel during a run, from its start, in nominal axes of the hull. */
export interface VesselInTime { along: OffsetRange; across: OffsetRange; covariance: number; start_surge: number; start_sway: number }

export interface MooringsReport { moorings: MooringSpread; dynamic?: { vessel: VesselInTime } }

// stages ----------------------------------------------------------------------------------------------------------------

/** A part of the line of one kind. */
export interface StageLine { of: 'pipe' | 'head' | 'cable'; points: [number, number][] }

/** A stage of an operation; without a solution it has no line, and `why` gives the reason. */
export interface StageData {
  name: string;
  /** Progress of the operation [m]. */
  out: number | null;
  /** Advance of the vessel since the first stage [m]. */
  ahead: number;
  line: StageLine[] | null;
  use: number | null;
  governing: string;
  why: string;
}

/** A result over the stages, in its unit. */
export interface StageCurve { key: string; name: string; unit: string; digits: number; values: (number | null)[]; limit: number | null }

export interface StagesData {
  list: StageData[];
  curves: StageCurve[];
  /** Name of the progress. */
  out: string;
  hull: [number, number][];
  supports: { name: string; stinger: boolean; rows: [number, number][] }[];
  bed: [number, number][];
}

export interface StagesReport { stages: StagesData }
// lay_table -------------------------------------------------------------------------------------------------------------

export type LayTableData = LayTableCurves;

// overlay ---------------------------------------------------------------------------------------------------------------

/** Curves of several result folders, in shown units. */
export interface OverlayData {
  names: string[];
  figures: {
    title: string;
    x_label: string;
    y_label: string;
    /** `folder`: index in `names`. */
    curves: { folder: number; points: [number, number][] }[];
  }[];
}

// seek ------------------------------------------------------------------------------------------------------------------

/** A key or a result of a goal seek; its values are in SI, `factor` converts them to `unit`. */
interface SoughtData { name: string; unit: string; factor: number }

export interface SeekGoalData extends SoughtData { wanted: number | null; reached: number | null }

export interface SeekData {
  keys: (SoughtData & { answer: number })[];
  goals: SeekGoalData[];
  /** Solved models: a value of every key, a result of every goal. */
  path: { values: number[]; results: number[] }[];
}

// study -----------------------------------------------------------------------------------------------------------------

/**
 * A varied key of a study. `words`: its values as in the model file; `values`: as numbers, if they are numeric, in the
 * units shown.
 */
export interface StudyAxisData { name: string; words: string[]; values: (number | null)[]; sampled: boolean }

/** Cases that differ only by their seed. */
export interface StudyGroupData {
  /** Index in the words of every input. */
  at: number[];
  x: (number | null)[];
  words: string[];
  /** Statistics of every output, over the seeds. */
  mean: (number | null)[];
  low: (number | null)[];
  high: (number | null)[];
  state: 'passed' | 'reserved' | 'exceeded' | 'not judged' | 'failed' | 'open';
  governing: string;
  utilisation: number | null;
  case: number;
}

export interface SwingData { output: string; base: number; bars: { name: string; low: number; high: number; low_word: string; high_word: string }[] }

export interface CorrelationData { output: string; bars: { name: string; value: number }[] }

export interface StudyData {
  shape: 'single' | 'curves' | 'maps' | 'one_at_a_time' | 'sample';
  inputs: StudyAxisData[];
  /** `at`: index in the lists of a group. */
  outputs: { name: string; at: number }[];
  groups: StudyGroupData[];
  /** Crossed inputs. */
  axes: number[];
  /** Ranges for one key at a time, correlations of a sample. */
  tornado?: SwingData[] | CorrelationData[];
  operability?: OperabilityData;
}

// tornado ---------------------------------------------------------------------------------------------------------------

/** Effects of the tolerances of inputs on a result, in `unit`. */
export interface TornadoData {
  /** The result with its value. */
  title: string;
  unit: string;
  bars: {
    /** The input with its tolerance. */
    name: string;
    /** Effect of a decrease and an increase of the input. */
    low: number;
    high: number;
    /** The effects as texts, with sign and unit. */
    low_label: string;
    /** Text at the right; with a star if the derivative is one-sided. */
    high_label: string;
  }[];
  /** Explanation of the stars. */
  notes: string[];
}
