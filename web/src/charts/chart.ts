// A uPlot diagram with marks, levels, a common cursor, zoom by dragging and export.
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { download } from '../components/download';
import { csvText } from '../components/tableText';
import { nearest } from '../logic/series';
import { axisNames } from '../logic/show';
import { tidy } from '../logic/units';
import { diagramRows, type ChartData } from './data';
import { drawing } from './drawing';
import { inkOnPage } from './ink';
import { drawLevel, nameLevels, nameMarks } from './marks';

export interface ChartHandlers {
  /** x position under the pointer and its index; null when the pointer left */
  hover: (x: number | null, index: number | null) => void;
  click: (x: number) => void;
  zoom: (low: number, high: number, whole: boolean) => void;
}

export interface Extra { shade?: [number, number] | null; position?: number | null }

/** Longest variant of an axis label that fits into a width in pixels. */
function fitting(name: string, room: number, font: string): string {
  const names = axisNames(name), pen = document.createElement('canvas').getContext('2d');
  if (!pen) return name;
  pen.font = font;
  return names.find((part) => pen.measureText(part).width <= room) ?? names.at(-1)!;
}

export class Chart {
  private plot: uPlot | null = null;
  private data: ChartData | null = null;
  private key = '';
  private named = '';
  private extra: Extra = {};
  private zoomed: [number, number] | null = null;
  private silent = false;

  constructor(private readonly box: HTMLElement, private readonly on: ChartHandlers) {
    // For tests: the ends of the x axis.
    (box as unknown as { shown: () => [number, number] }).shown = () => [this.plot?.scales.x!.min ?? Number.NaN, this.plot?.scales.x!.max ?? Number.NaN];
  }

  private colour(name: string): string { return getComputedStyle(this.box).getPropertyValue(name).trim(); }

  set(data: ChartData, extra: Extra = {}): void {
    const key = JSON.stringify([data.title, data.xName, data.yName, data.lines.map((l) => l.name), document.documentElement.dataset.theme]);
    const rebuilt = key !== this.key || !this.plot;
    this.data = data;
    this.extra = extra;
    if (rebuilt) {
      if (this.key.split('"')[1] !== data.title) this.zoomed = null;
      this.key = key;
      this.build();
    }
    this.fill();
  }

  private fill(): void {
    const data = this.data!;
    this.silent = true;
    this.plot!.setData([data.x, ...data.lines.map((l) => l.values)] as uPlot.AlignedData, true);
    if (this.zoomed) this.plot!.setScale('x', { min: this.zoomed[0], max: this.zoomed[1] });
    this.silent = false;
  }

  /** Axis labels, in the longest variant that fits. */
  private names(): { em: number; font: string; narrow: boolean; x: string; y: string } {
    const data = this.data!, r = this.box.getBoundingClientRect();
    const em = Number.parseFloat(getComputedStyle(document.body).fontSize), narrow = r.width < 260;
    const font = `${0.88 * em}px "Segoe UI", "Helvetica Neue", Arial, sans-serif`;
    const y = narrow ? '' : 0.46 * em * data.yName.length > r.height - 3.4 * em ? axisNames(data.yName).at(-1)! : data.yName;
    return { em, font, narrow, x: fitting(data.xName, r.width - (narrow ? 3.4 : 4.75) * em, font), y };
  }

  private build(): void {
    this.plot?.destroy();
    const data = this.data!;
    const axis = this.colour('--soft'), grid = this.colour('--grid');
    const r = this.box.getBoundingClientRect();
    const bars = data.lines[0]?.width === -1;
    const { em, font, narrow, x: xName, y: yName } = this.names();
    this.named = xName + yName;
    const options: uPlot.Options = {
      width: Math.max(80, Math.floor(r.width)), height: Math.max(60, Math.floor(r.height)),
      padding: [6, 12, 0, 0],
      legend: { show: false },
      scales: { x: { time: false, ...(bars ? { range: (_u: uPlot, low: number, high: number): [number, number] => { const pad = 0.04 * (high - low || 1); return [low - pad, high + pad]; } } : {}) }, y: { range: (_u, low, high) => this.range(low, high) } },
      cursor: { drag: { x: true, y: false, setScale: true }, points: { size: 7 }, focus: { prox: -1 } },
      series: [{}, ...data.lines.map((l, i): uPlot.Series => ({
        label: l.name, stroke: bars ? undefined : inkOnPage(l.colour), width: l.band ? 1 : l.width ?? 1.4, points: { show: false }, pxAlign: 0,
        ...(l.dash ? { dash: [5, 4] } : {}),
        ...(bars ? { fill: `${inkOnPage(l.colour)}cc`, width: 0, paths: uPlot.paths.bars!({ size: i === 0 ? [0.7, 40] : [0.35, 20] }) } : {}),
      }))],
      axes: [
        { stroke: axis, font, grid: { stroke: grid, width: 1 }, ticks: { show: false }, size: 1.7 * em, gap: 3, space: 4 * em, label: xName, labelFont: font, labelSize: 1.35 * em, labelGap: 0 },
        { stroke: axis, font, grid: { stroke: grid, width: 1 }, ticks: { show: false }, size: 3.4 * em, gap: 4, space: 2.6 * em, ...(narrow ? {} : { label: yName, labelFont: font, labelSize: 1.35 * em, labelGap: 0 }) },
      ],
      hooks: {
        drawClear: [(u) => this.under(u)],
        draw: [(u) => this.over(u)],
        setScale: [(u, name) => {
          if (name !== 'x' || this.silent || !this.data) return;
          const { min, max } = u.scales.x!;
          if (min === undefined || max === undefined || min === null || max === null) return;
          const whole = min <= this.data.x[0]! && max >= this.data.x[this.data.x.length - 1]!;
          const next: [number, number] | null = whole ? null : [min, max];
          if (String(next) === String(this.zoomed)) return;
          this.zoomed = next;
          this.on.zoom(min, max, whole);
        }],
      },
    };
    const band = data.lines.findIndex((l) => l.band);
    if (band >= 0) options.bands = [{ series: [band + 1, band + 2], fill: `${inkOnPage(data.lines[band]!.colour)}38` }];
    this.plot = new uPlot(options, [[], ...data.lines.map(() => [])] as uPlot.AlignedData, this.box);
    // Follows the pointer, not uPlot's cursor, which also reports a cursor set by the program, and later.
    this.plot.over.addEventListener('mousemove', (e) => this.hover(e));
    this.plot.over.addEventListener('mouseleave', () => this.on.hover(null, null));
    this.plot.over.addEventListener('click', (e) => {
      const rect = this.plot!.over.getBoundingClientRect();
      this.on.click(this.plot!.posToVal(e.clientX - rect.left, 'x'));
    });
    this.plot.over.addEventListener('dblclick', () => { this.zoomed = null; this.on.zoom(0, 0, true); });
  }

  private hover(e: MouseEvent): void {
    const left = e.clientX - this.plot!.over.getBoundingClientRect().left;
    this.on.hover(this.plot!.posToVal(left, 'x'), this.plot!.posToIdx(left));
  }

  private range(low: number, high: number): [number, number] {
    if (low === null || high === null || !Number.isFinite(low)) return [0, 1];
    const data = this.data;
    const most = Math.max(Math.abs(low), Math.abs(high));
    // a distant limit is shown at the edge, so that the curve keeps its height
    if (data && !this.zoomed) for (const l of data.level) if (l.kind !== 'limit' || Math.abs(l.y) < 2.2 * most) { low = Math.min(low, l.y); high = Math.max(high, l.y); }
    if (this.extra.shade) { low = Math.min(low, this.extra.shade[0]); high = Math.max(high, this.extra.shade[1]); }
    if (data?.lines[0]?.width === -1) low = 0;
    const least = 1e-3 * most; // smaller variations are noise and are drawn as a constant
    if (high - low < least) [low, high] = [0.5 * (low + high - least), 0.5 * (low + high + least)];
    const pad = 0.06 * (high - low || Math.abs(high) || 1);
    return [low >= 0 && low < 0.35 * high ? 0 : low - pad, high + pad];
  }

  private under(u: uPlot): void {
    const { ctx, bbox } = u;
    const shade = this.extra.shade;
    ctx.save();
    if (shade) {
      const a = u.valToPos(shade[1], 'y', true), b = u.valToPos(shade[0], 'y', true);
      ctx.fillStyle = this.colour('--range');
      ctx.fillRect(bbox.left, a, bbox.width, b - a);
    }
    for (const l of this.data?.level ?? []) drawLevel(u, l, (name) => this.colour(name));
    ctx.restore();
  }

  private over(u: uPlot): void {
    const { ctx, bbox } = u;
    ctx.save();
    ctx.fillStyle = this.colour('--mark');
    const d = devicePixelRatio;
    for (const m of this.data?.marks ?? []) {
      const x = u.valToPos(m.x, 'x', true);
      if (x < bbox.left || x > bbox.left + bbox.width) continue;
      const y = Number.isNaN(m.y) ? bbox.top + bbox.height : u.valToPos(m.y, 'y', true) + 3 * d;
      ctx.beginPath(); ctx.moveTo(x, y - (Number.isNaN(m.y) ? 6 * d : 0)); ctx.lineTo(x - 3 * d, y + (Number.isNaN(m.y) ? 0 : 5 * d)); ctx.lineTo(x + 3 * d, y + (Number.isNaN(m.y) ? 0 : 5 * d)); ctx.fill();
    }
    nameLevels(u, this.data?.level ?? [], (name) => this.colour(name));
    nameMarks(u, this.data?.marks ?? [], this.data?.level ?? [], (name) => this.colour(name));
    if (this.extra.position !== null && this.extra.position !== undefined) {
      const x = u.valToPos(this.extra.position, 'x', true);
      if (x >= bbox.left && x <= bbox.left + bbox.width) {
        ctx.strokeStyle = '#ff2d7a'; ctx.lineWidth = 1.5 * d;
        ctx.beginPath(); ctx.moveTo(x, bbox.top); ctx.lineTo(x, bbox.top + bbox.height); ctx.stroke();
      }
    }
    ctx.restore();
  }

  /** Shows the full range, as for another model. */
  showWhole(): void {
    this.zoomed = null;
    if (this.plot && this.data) this.fill();
  }

  setPosition(position: number | null): void { if (this.extra.position !== position) { this.extra.position = position; this.plot?.redraw(false, false); } }

  /** Sets the cursor from another diagram or from the 3-D view. */
  setCursor(s: number | null): void {
    if (!this.plot || !this.data || this.box.matches(':hover')) return;
    if (s === null) this.plot.setCursor({ left: -10, top: -10 });
    else {
      const i = nearest(this.data.s, s);
      this.plot.setCursor({ left: this.plot.valToPos(this.data.x[i]!, 'x'), top: this.plot.over.clientHeight / 2 });
    }
  }

  /** Text of the values under the cursor. */
  readAt(index: number | null): string {
    if (index === null || !this.data) return '';
    const unit = /\[(.*)\]/.exec(this.data.yName)?.[1] ?? '';
    const values = this.data.lines.map((l) => (l.values[index] === null || l.values[index] === undefined ? '' : `${this.data!.lines.length > 1 ? `${l.name} ` : ''}${tidy(l.values[index]!, 4)}`)).filter(Boolean);
    const name = this.data.names?.[index] ?? this.data.marks.find((m) => Math.abs(m.x - this.data!.x[index]!) < 1e-3 * (this.data!.x.at(-1)! - this.data!.x[0]!))?.label;
    return `${name ? `${name}, ` : ''}${tidy(this.data.x[index]!, 4)} ${/\[(.*)\]/.exec(this.data.xName)?.[1] ?? ''}: ${values.join(', ')} ${unit}`;
  }

  resize(): void {
    const r = this.box.getBoundingClientRect();
    if (!this.plot || r.width <= 20 || r.height <= 20) return;
    const { x, y } = this.names();
    if (x + y === this.named) return this.plot.setSize({ width: Math.floor(r.width), height: Math.floor(r.height) });
    this.build();
    this.fill();
  }

  export(kind: 'png' | 'svg' | 'csv'): void {
    if (!this.data || !this.plot) return;
    const name = `${this.data.title.toLowerCase().replace(/[^a-z0-9]+/g, '-')}.${kind}`;
    if (kind === 'csv') return download(name, new Blob([csvText(diagramRows(this.data))], { type: 'text/csv' }));
    const { x, y } = this.plot.scales, shade = this.extra.shade;
    const { text, width, height } = drawing(this.data, { x: [x!.min ?? 0, x!.max ?? 1], y: [y!.min ?? 0, y!.max ?? 1], shade });
    if (kind === 'svg') return download(name, new Blob([text], { type: 'image/svg+xml' }));
    // The picture is made from the drawing, so that it has title, units and names as the SVG.
    const image = new Image();
    image.onload = () => {
      const canvas = document.createElement('canvas');
      [canvas.width, canvas.height] = [2 * width, 2 * height];
      canvas.getContext('2d')!.drawImage(image, 0, 0, canvas.width, canvas.height);
      canvas.toBlob((blob) => { if (blob) download(name, blob); });
    };
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
  }

  destroy(): void { this.plot?.destroy(); this.plot = null; }
}
