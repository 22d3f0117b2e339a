// Label positions clear of curves, points and each other.

export interface Box { x0: number; x1: number; y0: number; y1: number }

export type Pixel = readonly [number, number];

const kTextHeight = 16;
const kSpacing = 8;  // size of the boxes that represent a curve

const overlap = (a: Box, b: Box) => a.x1 >= b.x0 && a.x0 <= b.x1 && a.y1 >= b.y0 && a.y0 <= b.y1;

/** Offsets of a label from its point, in the order in which they are tried; the text begins there on its base line. */
function offsets(width: number, below: boolean): Pixel[] {
  const left = -width - 8;
  const list: [number, number][] = below ? [[8, 20], [left, 20], [8, -10], [left, -10]] : [[8, -10], [left, -10], [8, 20], [left, 20]];
  for (let k = 0; k <= 5; ++k) {
    const [up, down] = [-10 - 16 * k, 20 + 16 * k];
    list.push([-width / 2, up], [8, up], [left, up], [-width / 2, down], [8, down], [left, down]);
  }
  return list;
}

/** Occupied space within a plot. */
export class LabelRoom {
  private readonly taken: Box[] = [];

  constructor(readonly inside: Box) {}

  take(box: Box): void {
    this.taken.push(box);
  }

  isFree(box: Box): boolean {
    return !this.taken.some((occupied) => overlap(box, occupied));
  }

  isInside(box: Box): boolean {
    const { x0, x1, y0, y1 } = this.inside;
    return box.x0 >= x0 && box.x1 <= x1 && box.y0 >= y0 && box.y1 <= y1;
  }

  takePoint([x, y]: Pixel, radius: number): void {
    this.take({ x0: x - radius, x1: x + radius, y0: y - radius, y1: y + radius });
  }

  /** Marks a curve through these pixels as occupied. */
  takeCurve(pixels: readonly Pixel[]): void {
    pixels.forEach(([x1, y1], i) => {
      const [x0, y0] = pixels[Math.max(i - 1, 0)]!;
      const steps = Math.min(40, Math.ceil(Math.max(Math.abs(x1 - x0), Math.abs(y1 - y0)) / kSpacing));
      for (let k = 0; k <= steps; ++k) {
        const share = k / Math.max(steps, 1);
        const [x, y] = [x0 + (x1 - x0) * share, y0 + (y1 - y0) * share];
        this.take({ x0: x - 1, x1: x + 1, y0: y - 2, y1: y + 2 });
      }
    });
  }

  /** Selects the first box that is inside and free, otherwise the first inside, otherwise the first, and marks it as occupied. */
  choose<B extends Box>(boxes: readonly B[]): B {
    const place = boxes.find((box) => this.isInside(box) && this.isFree(box)) ?? boxes.find((box) => this.isInside(box)) ?? boxes[0]!;
    this.take(place);
    return place;
  }

  /** Start of the base line of a text near a point. */
  place([x, y]: Pixel, width: number, below = false): Pixel {
    const boxes = offsets(width, below).map(([dx, dy]) => ({
      x0: x + dx, x1: x + dx + width, y0: y + dy - kTextHeight + 3, y1: y + dy + 3, start: [x + dx, y + dy] as const,
    }));
    return this.choose(boxes).start;
  }

  /** Start of an upright text on either side of a vertical line. */
  placeUpright(x: number, length: number): Pixel {
    const { y0, y1 } = this.inside;
    const boxes = [];
    for (let y = y0 + 6; y < y1 - length - 3; y += 12) {
      for (const dx of [-5, 16]) boxes.push({ x0: x + dx - 13, x1: x + dx + 3, y0: y, y1: y + length, start: [x + dx, y + length] as const });
    }
    if (boxes.length === 0) return [x - 5, y1 - 3];
    const place = boxes.find((box) => this.isFree(box)) ?? boxes[0]!;
    this.take(place);
    return place.start;
  }
}

/** Slanted names that do not cover the previous one. x in pixels, angle in degrees. */
export function visibleNames<N extends { x: number }>(names: readonly N[], angle: number, size: number): N[] {
  const apart = (size + 1) / Math.abs(Math.sin(angle * Math.PI / 180));
  const list: N[] = [];
  for (const name of names) {
    if (list.length === 0 || Math.abs(name.x - list[list.length - 1]!.x) >= apart) list.push(name);
  }
  return list;
}
