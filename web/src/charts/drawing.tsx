// A diagram as a vector drawing, made from its data and not from pixels, so that it prints sharp.
import { render } from 'preact';
import { Chart } from '../components/Chart';
import style from '../components/chart.css?inline';
import type { Range } from '../components/chart/scale';
import type { Bar, ChartProps } from '../components/chart/types';
import { colours } from '../components/colours';
import type { ChartData } from './data';
import { levelColour, shownLines } from './marks';

/** Parts of a diagram that are drawn. */
export interface Stretch { x: Range; y: Range; shade?: Range | null }

/** Some programs that read SVG do not support CSS variables. */
const paper: Record<string, string> = {
  ink: colours.ink, soft: colours.soft, axis: colours.soft, grid: '#e3e8ed', mark: colours.zero, paper: '#fff', deep: '#e9eef2',
};

const inPaper = (name: string): string => paper[name.replace(/^--/, '')] ?? colours.accent;

/** Each bar is narrower than those behind it, within the room that its neighbours leave. */
function bars({ x, lines, names }: ChartData): Bar[] {
  const apart = Math.min(...x.slice(1).map((place, i) => place - x[i]!));
  return lines.filter((line) => line.width === -1).flatMap(({ colour, values }, k) => {
    const half = (0.35 * (Number.isFinite(apart) ? apart : 1)) / (k + 1);
    return values.map((value, i): Bar => ({ x: [x[i]! - half, x[i]! + half], y: [0, value ?? 0], colour, title: names?.[i] }));
  });
}

function chartProps(data: ChartData, { x, y, shade }: Stretch): ChartProps {
  const [largest, least] = data.lines.filter((line) => line.band);
  const marks = data.marks.filter((mark) => mark.x >= x[0] && mark.x <= x[1]);
  return {
    title: data.title,
    width: 900,
    height: 420,
    x: { range: x, label: data.xName },
    y: { range: y, label: data.yName },
    bands: shade ? [{ y: shade, colour: '#cfe8cf' }] : [],
    areas: largest && least ? [{ points: data.x.map((place, i) => [place, least.values[i] ?? null, largest.values[i] ?? null]), colour: `${largest.colour}38` }] : [],
    bars: bars(data),
    curves: data.lines.filter((line) => line.width !== -1).map(({ values, colour, dash, band, width }) => (
      { points: data.x.map((place, i) => [place, values[i] ?? null]), colour, dash: dash ? '5 4' : undefined, width: band ? 1 : width })),
    levels: data.level.map((level) => ({ value: level.y, name: level.label, colour: levelColour(level, inPaper), dash: level.kind === 'limit' ? '7 4' : undefined })),
    points: marks.map((mark) => ({ x: mark.x, y: Number.isNaN(mark.y) ? y[0] : mark.y, colour: colours.steel, shape: 'triangle' })),
    lane: marks.map((mark) => ({ value: mark.x, text: mark.label })),
    legend: data.lines.length < 2 ? [] : shownLines(data).map(({ name, colour, dash, band, width }) => (
      { text: name, colour, dash: dash ? '5 4' : undefined, look: band || width === -1 ? 'block' : 'line' })),
  };
}

/** Text of an SVG file, with its size in pixels. */
export function drawing(data: ChartData, stretch: Stretch): { text: string; width: number; height: number } {
  const box = document.createElement('div');
  render(<Chart {...chartProps(data, stretch)} />, box);
  const svg = box.querySelector('svg')!;
  const { width, height } = svg.viewBox.baseVal;
  const embedded = document.createElementNS(svg.namespaceURI, 'style');
  const family = getComputedStyle(document.body).fontFamily;
  embedded.textContent = style.replace(/var\(--(\w+)\)/g, (_, name: string) => inPaper(name))
    + `svg.drawing{width:${width}px;height:${height}px;background:#fff;font-family:${family}}`;
  svg.prepend(embedded);
  svg.setAttribute('width', String(width));
  svg.setAttribute('height', String(height));
  const text = new XMLSerializer().serializeToString(svg);
  render(null, box);
  return { text, width, height };
}
