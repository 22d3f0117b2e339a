// Sharpness of the picture: coarser pixels while pictures follow each other too slowly, full sharpness when it stands still.

const lowest = 0.45;

export class Pace {
  /** Pixels drawn over those of the screen. */
  coarse = 1;
  private slow = 0;
  private last = -Infinity;

  /** Milliseconds since the last picture. */
  since(now: number): number { return now - this.last; }

  /** A picture is drawn; true where its pixels have changed. */
  next(now: number): boolean {
    const gap = now - this.last;
    this.last = now;
    if (gap > 400) { this.slow = 0; return false; }
    this.slow = gap > 45 ? this.slow + 1 : Math.max(0, this.slow - 1);
    if (this.slow < 3 || this.coarse <= lowest) return false;
    this.coarse *= 0.75;
    this.slow = 0;
    return true;
  }

  /** Coarser for as long as a value is dragged. */
  lower(to: number): boolean {
    if (this.coarse <= to) return false;
    this.coarse = to;
    return true;
  }

  /** Nothing has moved for a while: true where the picture is to be drawn sharply once more. */
  rest(now: number): boolean {
    if (this.coarse === 1 || now - this.last < 350) return false;
    this.coarse = 1;
    this.last = -Infinity;
    return true;
  }
}
