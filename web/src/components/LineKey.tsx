// Key of a figure with many curves, below it, with as many names in a row as fit.
import { textWidth } from './chart/text';

export interface KeyEntry { name: string; colour: string; dash?: string }

const kLine = 26, kRow = 22;

/** Positions of the entries' lines between `left` and `right`, with the first base line at `top`, and the last base line. */
function placeEntries(entries: readonly KeyEntry[], left: number, right: number, top: number) {
  let [x, y] = [left, top];
  const places = entries.map((entry) => {
    const wide = textWidth(entry.name) + 50;
    if (x + wide > right && x > left) [x, y] = [left, y + kRow];
    const place = { x, y };
    x += wide;
    return place;
  });
  return { places, bottom: y };
}

interface Room { entries: readonly KeyEntry[]; left: number; right: number; top: number }

/** Height of the rows below the first base line. */
export const keyHeight = ({ entries, left, right }: Omit<Room, 'top'>): number => placeEntries(entries, left, right, 0).bottom + 12;

export function LineKey({ entries, left, right, top }: Room) {
  const { places } = placeEntries(entries, left, right, top);
  return (
    <g class="key">
      {entries.map(({ name, colour, dash }, k) => {
        const { x, y } = places[k]!;
        return (
          <g key={k}>
            <line x1={x} x2={x + kLine} y1={y - 5} y2={y - 5} stroke={colour} stroke-dasharray={dash} stroke-width="2.2" />
            <text x={x + kLine + 6} y={y}>{name}</text>
          </g>
        );
      })}
    </g>
  );
}
