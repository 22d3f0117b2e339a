// The selected range of a grid, and its movement by keys.

export interface Spot { row: number; column: number }
export interface Range { anchor: Spot; focus: Spot }
export interface Rectangle { top: number; bottom: number; left: number; right: number }

export const spotRange = (spot: Spot): Range => ({ anchor: spot, focus: spot });

export function rectangle({ anchor, focus }: Range): Rectangle {
  return {
    top: Math.min(anchor.row, focus.row), bottom: Math.max(anchor.row, focus.row),
    left: Math.min(anchor.column, focus.column), right: Math.max(anchor.column, focus.column),
  };
}

export function contains(r: Rectangle, row: number, column: number): boolean {
  return row >= r.top && row <= r.bottom && column >= r.left && column <= r.right;
}

/** The range within a table that may have become smaller; null if it is empty. */
export function clamped(range: Range, rows: number, columns: number): Range | null {
  if (rows === 0 || columns === 0) return null;
  const within = (spot: Spot): Spot => ({ row: Math.max(0, Math.min(spot.row, rows - 1)), column: Math.max(0, Math.min(spot.column, columns - 1)) });
  return { anchor: within(range.anchor), focus: within(range.focus) };
}

const page = 10;

/** Target of a movement key; null for any other key. */
function target(spot: Spot, key: string, control: boolean, rows: number, columns: number): Spot | null {
  const { row, column } = spot;
  switch (key) {
    case 'ArrowUp': return { row: control ? 0 : row - 1, column };
    case 'ArrowDown': return { row: control ? rows - 1 : row + 1, column };
    case 'ArrowLeft': return { row, column: control ? 0 : column - 1 };
    case 'ArrowRight': return { row, column: control ? columns - 1 : column + 1 };
    case 'Home': return { row: control ? 0 : row, column: 0 };
    case 'End': return { row: control ? rows - 1 : row, column: columns - 1 };
    case 'PageUp': return { row: row - page, column };
    case 'PageDown': return { row: row + page, column };
    default: return null;
  }
}

export function moved(range: Range, key: string, { control = false, shift = false }, rows: number, columns: number): Range | null {
  const next = target(range.focus, key, control, rows, columns);
  return next && clamped({ anchor: shift ? range.anchor : next, focus: next }, rows, columns);
}

/** The next cell in reading order; null at the end of the table, where Tab leaves it. */
export function tabbed({ focus }: Range, back: boolean, rows: number, columns: number): Range | null {
  const i = focus.row * columns + focus.column + (back ? -1 : 1);
  return i < 0 || i >= rows * columns ? null : spotRange({ row: Math.floor(i / columns), column: i % columns });
}
