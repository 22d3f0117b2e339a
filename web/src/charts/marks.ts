// Marks of a diagram in addition to its curves: levels such as water or allowable values, and names of the boxes.
import type uPlot from 'uplot';
import { upright } from '../logic/labelRoom';
import { tidy } from '../logic/units';
import type { ChartData } from './data';

const letters = (): string => `${0.85 * Number.parseFloat(getComputedStyle(document.body).fontSize) * devicePixelRatio}px "Segoe UI", Arial, sans-serif`;

type Colour = (name: string) => string;

export const levelColour = (l: ChartData['level'][number], colour: Colour): string =>
  (l.kind === 'water' ? '#4d9cc9' : l.kind === 'limit' ? colour('--bad') : '#a8905a');

/** Legend entries of the lines; maximum and minimum of a band are one entry. */
export const shownLines = (data: ChartData): ChartData['lines'] =>
  data.lines.filter((l) => !l.band || l.name === 'largest').map((l) => (l.band ? { ...l, name: 'minimum to maximum' } : l));

/** Water, seabed, or an allowable value. */
export function drawLevel(u: uPlot, l: ChartData['level'][number], colour: Colour): void {
  const { ctx, bbox } = u;
  const d = devicePixelRatio;
  const y = u.valToPos(l.y, 'y', true);
  if (y < bbox.top || y > bbox.top + bbox.height) return;
  ctx.strokeStyle = levelColour(l, colour);
  ctx.lineWidth = d * 1.4;
  ctx.setLineDash(l.kind === 'limit' ? [7 * d, 4 * d] : []);
  ctx.beginPath(); ctx.moveTo(bbox.left, y); ctx.lineTo(bbox.left + bbox.width, y); ctx.stroke();
  ctx.setLineDash([]);
}

/** Names of levels above the curves; a limit outside the range is shown with its value at the edge. */
export function nameLevels(u: uPlot, levels: ChartData['level'], colour: Colour): void {
  const { ctx, bbox } = u;
  const d = devicePixelRatio;
  let previous = Infinity;
  ctx.font = letters();
  ctx.textAlign = 'right';
  ctx.textBaseline = 'alphabetic';
  for (const l of [...levels].sort((a, b) => a.y - b.y)) {
    const y = u.valToPos(l.y, 'y', true);
    const hidden = y < bbox.top || y > bbox.top + bbox.height;
    if (hidden && (l.kind !== 'limit' || y > bbox.top)) continue;
    // above its line, or below if there is no room
    let baseline = hidden || y - bbox.top < 14 * d ? Math.max(y, bbox.top) + 12 * d : y - 4 * d;
    if (Math.abs(baseline - previous) < 13 * d) baseline = previous - 13 * d;
    previous = baseline;
    const text = hidden ? `${l.label}: ${tidy(l.y, 4)} ↑` : l.label;
    ctx.fillStyle = levelColour(l, colour);
    ctx.strokeStyle = colour('--paper');
    ctx.lineWidth = 3 * d;
    ctx.strokeText(text, bbox.left + bbox.width - 4 * d, baseline);
    ctx.fillText(text, bbox.left + bbox.width - 4 * d, baseline);
  }
}

/** Highest and lowest point [px] of all curves between two positions. */
function curvesBetween(u: uPlot, left: number, right: number): [number, number] | null {
  const value = (px: number): number => u.posToVal((px - u.bbox.left) / devicePixelRatio, 'x');
  const from = Math.max(0, u.valToIdx(value(left)) - 1), to = u.valToIdx(value(right)) + 1;
  let band: [number, number] | null = null;
  for (const values of u.data.slice(1)) {
    for (const v of values.slice(from, to + 1)) {
      if (v === null || v === undefined) continue;
      const y = u.valToPos(v, 'y', true);
      band = band ? [Math.min(band[0], y), Math.max(band[1], y)] : [y, y];
    }
  }
  return band;
}

/** Upright names of the boxes at their marks, as many as fit next to each other and off the curves. */
export function nameMarks(u: uPlot, marks: ChartData['marks'], levels: ChartData['level'], colour: Colour): void {
  const { ctx, bbox } = u;
  const d = devicePixelRatio;
  ctx.fillStyle = colour('--soft');
  ctx.font = letters();
  ctx.textBaseline = 'alphabetic';
  const step = 1.1 * Number.parseFloat(ctx.font);
  // not across the line of a limit
  const lines = levels.map((level) => u.valToPos(level.y, 'y', true)).filter((y) => y < bbox.top + 0.4 * bbox.height);
  const top = Math.max(bbox.top, ...lines) + 4 * d;
  let last = -Infinity;
  for (const m of marks) {
    const x = u.valToPos(m.x, 'x', true);
    if (x < bbox.left + 2 * d || x > bbox.left + bbox.width || x - last < step) continue;
    const length = ctx.measureText(m.label).width;
    const room = { top, bottom: bbox.top + bbox.height - 9 * d };
    const free = Number.isNaN(m.y) && m.over === undefined ? upright(length + 3 * d, room, curvesBetween(u, x - 0.5 * step, x + 0.5 * step)) : 'low';
    if (!free) continue;
    last = x;
    // from the lower end upwards, but downwards below a curve that they mark
    const below = !Number.isNaN(m.y);
    ctx.textAlign = below ? 'right' : 'left';
    ctx.save();
    const bar = m.over === undefined ? Infinity : u.valToPos(m.over, 'y', true) - 5 * d;
    const foot = free === 'high' ? room.top + length : bar - length > bbox.top ? Math.min(bar, room.bottom) : room.bottom;
    ctx.translate(x + 0.32 * step, below ? u.valToPos(m.y, 'y', true) + 12 * d : foot);
    ctx.rotate(-Math.PI / 2);
    ctx.lineWidth = 3 * d;
    ctx.strokeStyle = colour('--paper');
    ctx.strokeText(m.label, 0, 0);
    ctx.fillText(m.label, 0, 0);
    ctx.restore();
  }
}
