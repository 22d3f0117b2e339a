// What a report is made of: the data that the program writes (src/overbend/report/page/blocks.h) and components draw.

/** A number in the unit of its column, words, a verdict, or nothing. */
export type Cell = number | string | { verdict: 'passed' | 'reserved' | 'exceeded' | 'not judged'; text: string } | null;

export interface Column {
  title: string;
  unit?: string;
  /** Decimals shown; numbers have two more. Not of words. */
  digits?: number;
  /** A column of words, set flush left. */
  words?: boolean;
  /** Name of the quantity, in tables for the page. */
  key?: string;
  /** What it is, in tables for the page. */
  description?: string;
}

/** How a row stands out; "reserved" and "limit" on the page alone. */
export type RowMark = '' | 'over' | 'soft' | 'total' | 'loaded' | 'reserved' | 'limit';

export interface TableData {
  title: string;
  /** How it is set: "plain", "dense", "checks", "dense summary". */
  look: string;
  columns: Column[];
  /** A head above the columns: title, number of columns. */
  groups?: [string, number][];
  rows: Cell[][];
  marks?: RowMark[];
}

export interface TileData { name: string; value: string; unit: string; note: string; over?: boolean }

/** A formula of a calculation sheet with what stands beside it. */
export interface SheetLine {
  symbol: string;
  meaning: string;
  /** As an equation, in the program's notation: "sigma_eq = sqrt(sigma_l^2 + 3 tau^2)"; empty for an input. */
  formula: string;
  numbers: string;
  value: string;
  origin: string;
  confirmed: string;
  soft?: boolean;
}

export type BlockData =
  | { kind: 'section'; id: string; heading: string; body: BlockData[] }
  | { kind: 'paragraph'; text: string; link?: { text: string; to: string } }
  | { kind: 'remark'; text: string }
  | { kind: 'subheading'; text: string }
  | { kind: 'list'; items: string[]; numbered?: boolean }
  | { kind: 'folded'; summary: string; printed: boolean; body: BlockData[] }
  | { kind: 'group'; look: string; body: BlockData[] }
  | { kind: 'tiles'; tiles: TileData[] }
  | { kind: 'entries'; entries: [string, string][] }
  | { kind: 'verbatim'; text: string }
  | { kind: 'figure'; id: string; caption: string; parts: string[]; small?: boolean; data?: unknown }
  | { kind: 'sheet'; lines: SheetLine[] }
  | ({ kind: 'table' } & TableData);

export interface Bar { title: string; utilisation: number; what: string }

export interface FindingData { severity: 'serious' | 'caution' | 'note'; text: string; code: string }

export interface VerdictData { kind: 'passed' | 'reserved' | 'exceeded' | 'not judged'; words: string; because: string }

/** The first page. */
export interface Front {
  kind: string;
  title: string;
  /** The box that a document carries; left out where the model fills none of it. */
  control?: [string, string][];
  /** Names with values below the title. */
  entries: [string, string][];
  verdict?: VerdictData;
  /** Bars of utilisation; without any only the note stands there. */
  utilisation?: { heading: string; bars: Bar[]; note: string };
  /** By severity. */
  findings: FindingData[];
}

export interface ReportDocument {
  title: string;
  /** What it is printed on: A4, or Letter where values are in US customary units. */
  paper: 'A4' | 'letter';
  front: Front;
  /** Sections, in their order. */
  body: BlockData[];
}

/** Units that people read, by the SI unit; "section": lengths of a cross-section and gaps. */
export type ShownUnits = Record<string, { name: string; factor: number; more: number }>;
