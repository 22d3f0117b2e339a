// Data of a report: written by the program (src/overbend/report/page/blocks.h), drawn by the components.

/** A number in the unit of its column, a text, a verdict, or nothing. */
export type Cell = number | string | { verdict: 'passed' | 'reserved' | 'exceeded' | 'not judged'; text: string } | null;

export interface Column {
  title: string;
  unit?: string;
  /** Decimals shown; exported numbers have two more. Not for texts. */
  digits?: number;
  /** A column of texts, set flush left. */
  words?: boolean;
  /** Name of the quantity, in tables for the page. */
  key?: string;
  /** Description of the quantity, in tables for the page. */
  description?: string;
}

/** Emphasis of a row; "reserved" and "limit" on the page only. */
export type RowMark = '' | 'over' | 'soft' | 'total' | 'loaded' | 'reserved' | 'limit';

export interface TableData {
  title: string;
  /** Style: "plain", "dense", "checks", "dense summary". */
  look: string;
  columns: Column[];
  /** A head above the columns: title, number of columns. */
  groups?: [string, number][];
  rows: Cell[][];
  marks?: RowMark[];
}

export interface TileData { name: string; value: string; unit: string; note: string; over?: boolean }

/** A line of a calculation sheet: formula, values and origin. */
export interface SheetLine {
  symbol: string;
  meaning: string;
  /** An equation in the program's notation: "sigma_eq = sqrt(sigma_l^2 + 3 tau^2)"; empty for an input. */
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
  /** Document control box; omitted if the model gives none of it. */
  control?: [string, string][];
  /** Names with values below the title. */
  entries: [string, string][];
  verdict?: VerdictData;
  /** Bars of utilisation; if there are none, only the note is shown. */
  utilisation?: { heading: string; bars: Bar[]; note: string };
  /** Findings by severity. */
  findings: FindingData[];
}

export interface ReportDocument {
  title: string;
  /** Paper size: A4, or Letter if values are in US customary units. */
  paper: 'A4' | 'letter';
  front: Front;
  /** Sections in order. */
  body: BlockData[];
}

/** Shown units by SI unit; "section": lengths of a cross-section and gaps. */
export type ShownUnits = Record<string, { name: string; factor: number; more: number }>;
