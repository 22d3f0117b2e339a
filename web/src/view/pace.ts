// Resolution of the picture: coarser pixels while frames are slow, full resolution at rest.

const lowest = 0.45;

export class Pace {
  /** Drawn pixels per screen pixel. */
  coarse = 1;
  private slow = 0;
  private last = -Infinity;

  /** Milliseconds since the last picture. */
  since(time: number): number { return time - this.last; }

  /** Records a frame; true if the pixel ratio has changed. */
  next(time: number): boolean {
    const gap = time - this.last;
    this.last = time;
    if (gap > 400) { this.slow = 0; return false; }
    this.slow = gap > 45 ? this.slow + 1 : Math.max(0, this.slow - 1);
    if (this.slow < 3 || this.coarse <= lowest) return false;
    this.coarse *= 0.75;
    this.slow = 0;
    return true;
  }

  /** Coarser during a drag. */
  lower(to: number): boolean {
    if (this.coarse <= to) return false;
    this.coarse = to;
    return true;
  }

  /** At rest for a while: true if the picture is to be drawn once more at full resolution. */
  rest(time: number): boolean {
    if (this.coarse === 1 || time - this.last < 350) return false;
    this.coarse = 1;
    this.last = -Infinity;
    return true;
  }
}
