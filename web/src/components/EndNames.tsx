// Names of curves at their right ends, in the margin, moved apart if they would overlap.
import type { VNode } from 'preact';
import type { Frame } from './chart/types';

/** A name in the colour of its curve, which ends at `y` [px]. */
export interface EndName { text: string; colour: string; y: number }

const apart = 15; // px

/** Heights of names from top to bottom: in the order of the curve ends, within `top` and `bottom` if they fit. */
export function spreadNames(ends: readonly EndName[], top: number, bottom: number): (EndName & { row: number })[] {
  const rows: (EndName & { row: number })[] = [];
  for (const end of [...ends].sort((a, b) => a.y - b.y)) {
    const last = rows.at(-1);
    rows.push({ ...end, row: Math.max(end.y, last ? last.row + apart : top + 4) });
  }
  let below = bottom;
  for (const row of rows.reverse()) {
    row.row = Math.min(row.row, below);
    below = row.row - apart;
  }
  return rows.reverse();
}

export function EndNames({ frame, ends }: { frame: Frame; ends: readonly EndName[] }): VNode {
  const x = frame.right;
  return (
    <g>
      {spreadNames(ends, frame.top, frame.bottom).map(({ text, colour, y, row }) => (
        <g>
          <path d={`M${x} ${y.toFixed(1)}L${x + 14} ${row.toFixed(1)}`} stroke={colour} fill="none" stroke-width="0.8" />
          <text x={x + 18} y={row + 5} style={{ fill: colour }}>{text}</text>
        </g>
      ))}
    </g>
  );
}
