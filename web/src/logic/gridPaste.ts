// A pasted table as cells of a grid: by its heads if it has them, otherwise from a given column on.
import { readCell, shownValue, type ReadCell } from './gridCells';
import { parseTable, readHead } from './gridClipboard';
import { decimalMark, readNumber, type DecimalMark } from './gridNumbers';
import { listColumn, type ViewColumn } from './gridView';

export interface PastedCell { column: ViewColumn; text: string; read: ReadCell }
/** `list`: title of the list given in the row. */
export interface PastedRow { cells: PastedCell[]; list: string }
export interface Pasted { rows: PastedRow[]; ignored: string[]; hasHead: boolean; columns: ViewColumn[] }

/** Implausibly large number of rows. */
const mostRows = 1000;

function readPasted(text: string, column: ViewColumn, unit: string, decimal: DecimalMark): PastedCell {
  const number = column.column!.kind === 'quantity' && unit ? readNumber(text, decimal) : null;
  const bare = number !== null && number !== 'ambiguous' && number.rest === '';
  return { column, text, read: readCell(bare ? `${text} ${unit}` : text, column.column!, column.unit, decimal) };
}

/** Largest value of a pasted column in the unit of the grid, with a decimal mark. */
function largest(cells: string[], column: ViewColumn, unit: string, decimal: DecimalMark): number {
  const values = cells.map((text) => { const { read } = readPasted(text, column, unit, decimal); return 'value' in read && read.value !== null ? Math.abs(Number(shownValue(read.value, column.unit))) : 0; });
  return Math.max(0, ...values.filter(Number.isFinite));
}

const far = 30;

/** If all numbers have three digits after a comma: the interpretation closest in magnitude to the present values. */
function markBySize(columns: { cells: string[]; column: ViewColumn; unit: string }[], sizes: Map<string, number>): DecimalMark {
  const votes = columns.map(({ cells, column, unit }) => {
    const usual = sizes.get(column.id) ?? 0, asPoint = largest(cells, column, unit, '.'), asComma = largest(cells, column, unit, ',');
    if (usual === 0 || asPoint === asComma) return 0;
    return Number(asComma > usual / far && asComma < usual * far) - Number(asPoint > usual / far && asPoint < usual * far);
  });
  const sum = votes.reduce((a, b) => a + b, 0);
  return sum === 0 ? null : sum > 0 ? ',' : '.';
}

/** Largest value of each column of a grid. */
export function columnSizes(columns: ViewColumn[], rows: { cells: { text: string }[] }[]): Map<string, number> {
  return new Map(columns.map((column, i) => [column.id, Math.max(0, ...rows.map((row) => Math.abs(Number(row.cells[i]!.text))).filter(Number.isFinite))]));
}

/** `from`: first column for a table without heads; heads may also name `hidden` columns. `sizes`: largest present value of
 * each column. */
export function readPaste(text: string, columns: ViewColumn[], from: number, hidden: ViewColumn[] = [], sizes = new Map<string, number>()): Pasted {
  const table = parseTable(text);
  const inputs = [...columns, ...hidden].filter((c) => c.column !== null || c.id === listColumn);
  const head = readHead(table, inputs);
  const rows = (head?.rows ?? table).slice(0, mostRows);
  const targets = head ? head.columns.map((id) => inputs.find((c) => c.id === id)) : columns.slice(from, from + Math.max(0, ...rows.map((row) => row.length)));
  const numeric = targets.flatMap((column, i) => (column?.column?.kind === 'quantity' || column?.column?.kind === 'number' ? [{ column, cells: rows.map((row) => row[i] ?? ''), unit: head?.units[i] ?? '' }] : []));
  const decimal = decimalMark(numeric.flatMap((n) => n.cells)) ?? markBySize(numeric, sizes);
  return {
    hasHead: head !== null, ignored: head?.ignored ?? [], columns: targets.filter((c): c is ViewColumn => c?.column != null && c.editable),
    rows: rows.map((row) => ({
      list: row[targets.findIndex((c) => c?.id === listColumn)] ?? '',
      cells: row.flatMap((cell, i) => {
        const target = targets[i];
        return target?.column && target.editable ? [readPasted(cell, target, head?.units[i] ?? '', decimal)] : [];
      }),
    })),
  };
}
