// Contents of a grid: rows of one or several lists of a kind, each cell with its text and its diagnostic.
import type { Diagnostic, Field } from '../api/types';
import { headUnit, shownValue, summary } from './gridCells';
import type { GridColumn } from './gridColumns';
import type { ResultColumn } from './gridResults';
import { unitsLike } from './units';

export interface ViewList {
  path: string;
  /** Shown in a separate column if there are several lists. */
  title: string;
  /** Names of items without a given name. */
  standardName?: (index: number) => string;
  /** Columns that are shown although no item has them. */
  usual?: string[];
  /** Group with the default values of the items: "supports.ramp". */
  above?: string;
  /** Values of rows that the program places itself, by column; they are not a list in the model. */
  placed?: Record<string, string>[];
}

export interface ViewColumn {
  id: string; title: string; unit: string; group: string; info: string; editable: boolean; isText: boolean;
  /** Units that can be selected. */
  units: string[];
  choices: string[];
  /** Null for results and the title of the list. */
  column: GridColumn | null;
}

/** "fixed": follows from other keys and cannot be edited. */
export type CellState = '' | 'fixed' | 'standard' | 'bad' | 'pending' | 'result';
export interface ViewCell { text: string; state: CellState; severity: '' | 'error' | 'warning'; message: string; link: string }
export interface ViewRow { id: string; list: string; index: number; name: string; mark: string; cells: ViewCell[] }

/** Text typed into a cell that the model does not have: pending, or unreadable. */
export interface Draft { text: string; message: string; base: string }

export interface ModelParts {
  byPath: Map<string, Field>;
  fields: Field[];
  diagnostics: Map<string, Diagnostic>;
  drafts: Map<string, Draft>;
}

export const listColumn = '#list';
export const cellPath = (row: { id: string }, key: string): string => (key ? `${row.id}.${key}` : row.id);
export const writtenText = (field: Field | undefined): string => (field?.given && field.value !== null ? String(field.value) : '');

/** The most severe diagnostic of each key. */
export function diagnosticsByKey(list: Diagnostic[]): Map<string, Diagnostic> {
  const byKey = new Map<string, Diagnostic>();
  for (const d of list) if (!byKey.has(d.key) || (d.severity === 'error' && byKey.get(d.key)!.severity !== 'error')) byKey.set(d.key, d);
  return byKey;
}

/** Number of items with fields; a long list has more of them in the text. */
export function itemCount({ byPath }: ModelParts, list: string): number {
  const field = byPath.get(list);
  if (field?.kind !== 'list' || !field.given) return 0;
  let count = Math.min(field.count ?? 0, 200);
  while (count > 0 && !byPath.get(`${list}[${count - 1}]`)?.given) --count;
  return count;
}

export function inputColumns(columns: GridColumn[], lists: ViewList[], model: ModelParts, chosenUnits: Record<string, string>): ViewColumn[] {
  return columns.map((column) => {
    const written = lists.flatMap((list) => Array.from({ length: itemCount(model, list.path) }, (_none, i) => model.byPath.get(cellPath({ id: `${list.path}[${i}]` }, column.key))?.value ?? null));
    const unit = column.kind === 'quantity' ? chosenUnits[column.key] ?? headUnit(written, column.unit) : '';
    return {
      id: column.key, title: column.title, unit, group: '', info: column.info, editable: column.kind !== 'nested', units: unit ? unitsLike(unit) : [],
      isText: column.kind === 'text' || column.kind === 'choice' || column.kind === 'nested', choices: column.choices, column,
    };
  });
}

export const resultView = ({ id, title, unit, group, info, isText }: ResultColumn): ViewColumn =>
  ({ id, title, unit, group, info, editable: false, isText: isText ?? false, units: [], choices: [], column: null });

function nestedCell(model: ModelParts, path: string): ViewCell {
  const field = model.byPath.get(path);
  const members = model.fields.filter((f) => f.path.startsWith(`${path}.`));
  const said = [...model.diagnostics.values()].find((d) => d.key === path || d.key.startsWith(`${path}.`) || d.key.startsWith(`${path}[`));
  return { text: summary(field, members), state: '', severity: said?.severity ?? '', message: said?.message ?? '', link: path };
}

function inputCell(model: ModelParts, path: string, view: ViewColumn, standard: string): ViewCell {
  if (view.column!.kind === 'nested') return nestedCell(model, path);
  const field = model.byPath.get(path), written = writtenText(field), draft = model.drafts.get(path), said = model.diagnostics.get(path);
  const cell: ViewCell = { text: shownValue(written || null, view.unit), state: '', severity: said?.severity ?? '', message: said?.message ?? '', link: '' };
  if (draft && (draft.message === '' || draft.base === written)) return { ...cell, text: draft.text, state: draft.message ? 'bad' : 'pending', severity: draft.message ? 'error' : '', message: draft.message };
  if (written) return cell;
  const usual = field?.default ?? view.column!.standard;
  return { ...cell, state: 'standard', text: usual !== null && usual !== '' ? shownValue(usual, view.unit) : standard };
}

/** Values of the group for items that give none. */
function aboveText(model: ModelParts, list: ViewList, view: ViewColumn): string {
  const field = list.above ? model.byPath.get(`${list.above}.${view.id}`) : undefined;
  const value = field && (field.value ?? field.default);
  return value === undefined || value === null ? '' : shownValue(value, view.unit);
}

function resultCell(column: ResultColumn, row: { name: string; index: number; list: string }): ViewCell {
  const { text, warning } = column.cell(row);
  return { text, state: 'result', severity: warning ? 'warning' : '', message: warning ?? '', link: '' };
}

function placedCell(model: ModelParts, list: ViewList, index: number, view: ViewColumn, name: string): ViewCell {
  const value = list.placed![index]![view.id];
  return { text: value ? shownValue(value, view.unit) : view.id === 'name' ? name : aboveText(model, list, view), state: 'fixed', severity: '', message: '', link: '' };
}

export const isPlaced = (row: ViewRow): boolean => row.cells.some((cell) => cell.state === 'fixed');

export function viewRows(lists: ViewList[], inputs: ViewColumn[], results: ResultColumn[], model: ModelParts): ViewRow[] {
  return lists.flatMap((list) => Array.from({ length: list.placed?.length ?? itemCount(model, list.path) }, (_none, index) => {
    const id = `${list.path}[${index}]`, usual = list.standardName?.(index) ?? '';
    const name = writtenText(model.byPath.get(`${id}.name`)) || usual;
    const cells = inputs.map((view): ViewCell => view.id === listColumn
      ? { text: list.title, state: '', severity: '', message: '', link: '' }
      : list.placed ? placedCell(model, list, index, view, usual) : inputCell(model, cellPath({ id }, view.id), view, view.id === 'name' ? usual : aboveText(model, list, view)));
    return { id, list: list.path, index, name, mark: inputs[0]?.id === '' ? '' : model.diagnostics.get(id)?.message ?? '', cells: [...cells, ...results.map((column) => resultCell(column, { name, index, list: list.path }))] };
  }));
}

const asNumber = (text: string): number => (text === '' ? Number.NaN : Number(text));

/** Rows by the texts of a column: numbers before texts, empty ones last. */
export function sortedRows(rows: ViewRow[], column: number, descending: boolean): ViewRow[] {
  const direction = descending ? -1 : 1;
  return [...rows].sort((a, b) => {
    const left = a.cells[column]?.text ?? '', right = b.cells[column]?.text ?? '';
    if (left === '' || right === '') return Number(left === '') - Number(right === '');
    const difference = asNumber(left) - asNumber(right);
    return direction * (Number.isNaN(difference) ? left.localeCompare(right, 'en', { numeric: true }) : difference);
  });
}
