// Positions of names over the 3-D view: none covers another or the cards over the picture; a moved name keeps its leader.

export interface Rect { x0: number; y0: number; x1: number; y1: number }

/** Target position and width of a name [px]. */
export interface Wanted { x: number; y: number; width: number; weight: number }

/** Middle and top of the name, and the length of its leader down to the target. */
export interface Placed { index: number; middle: number; top: number; leader: number }

export const labelHeight = 20;
const gap = 2, shortLeader = 16, rises = [0, 22, 44, 66] as const;

const covers = (a: Rect, b: Rect): boolean => a.x0 < b.x1 && a.x1 > b.x0 && a.y0 < b.y1 && a.y1 > b.y0;

/** Upright leaders: names move up, or sideways as long as the leader still begins below them. */
function candidates({ x, y, width }: Wanted, room: Rect): (Rect & { leader: number })[] {
  const half = width / 2;
  const inside = (middle: number): number => Math.min(Math.max(middle, room.x0 + half + gap), room.x1 - half - gap);
  return rises.flatMap((rise) => [0, 0.42, -0.42].map((aside) => {
    const middle = inside(x + aside * width), leader = shortLeader + rise, y1 = y - leader;
    return { x0: middle - half, x1: middle + half, y0: y1 - labelHeight, y1, leader };
  })).filter((box) => box.y0 >= room.y0 && x >= box.x0 && x <= box.x1);
}

/** Names of higher weight first; names that do not fit are left out. `taken`: cards over the picture. */
export function placeNames(wanted: readonly Wanted[], room: Rect, taken: readonly Rect[]): Placed[] {
  const full = [...taken];
  const placed: Placed[] = [];
  const order = wanted.map((_, index) => index).sort((a, b) => wanted[b]!.weight - wanted[a]!.weight || a - b);
  for (const index of order) {
    const box = candidates(wanted[index]!, room).find((c) => !full.some((occupied) => covers(c, occupied)));
    if (!box) continue;
    full.push({ x0: box.x0 - gap, x1: box.x1 + gap, y0: box.y0 - gap, y1: box.y1 + gap });
    placed.push({ index, middle: (box.x0 + box.x1) / 2, top: box.y0, leader: box.leader });
  }
  return placed;
}
