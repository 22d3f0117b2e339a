// Edges, scales, ticks and head of a chart, from its props and the units shown.
import type { Units } from '../units';
import { LabelRoom } from './labels';
import { linearScale, ticks, tickTexts, widened } from './scale';
import { textWidth } from './text';
import type { Axis, AxisName, ChartProps, Frame, LegendEntry } from './types';

export const kSlant = 50;  // angle of slanted names [deg]
export const kLegendRow = 22;
const kSlope = Math.sin(kSlant * Math.PI / 180);

export interface Tick { pixel: number; text: string }

export interface PlacedEntry extends LegendEntry { right: number; y: number; textWidth: number }

/** Entries of a legend with the pixel at which each ends, and the title at the left of the row. */
export interface PlacedLegend { entries: PlacedEntry[]; title?: { text: string; y: number } }

/** Orientation and size of the names of the x axis. */
export interface NameLayout { level: boolean; size: number; depth: number }

export interface Layout { frame: Frame; xTicks: Tick[]; yTicks: Tick[]; rightTicks: Tick[]; legends: PlacedLegend[]; names: NameLayout }

type Measure = (text: string) => number;

/** Legend rows below y; the first row is next to the title if all entries fit there. */
function placeLegend(entries: readonly LegendEntry[], right: number, full: number, titleRoom: number, y: number, measure: Measure) {
  const widths = entries.map((entry) => measure(entry.text));
  const spaces = widths.map((width) => width + 48);
  const total = spaces.reduce((sum, space) => sum + space, 0);
  if (total > titleRoom && titleRoom < full) y += kLegendRow;
  const rows: number[][] = [[]];
  let used = 0;
  spaces.forEach((space, i) => {
    if (used > 0 && used + space > Math.max(full, titleRoom)) { rows.push([]); used = 0; }
    rows[rows.length - 1]!.push(i);
    used += space;
  });
  const placed: PlacedEntry[] = [];
  rows.forEach((row, k) => {
    let end = right;
    for (const i of row.reverse()) {
      placed.push({ ...entries[i]!, right: end, y: y + kLegendRow * k, textWidth: widths[i]! });
      end -= spaces[i]!;
    }
  });
  return { placed, last: y + kLegendRow * (rows.length - 1) };
}

/** Legends, and the base line of the last row in the head. */
function layoutLegends(props: ChartProps, left: number, right: number, measure: Measure, titleWidth: number) {
  const legends: PlacedLegend[] = [];
  const full = right - left;
  const first = placeLegend(props.legend ?? [], right, full, Math.max(full - titleWidth, 0), 20, measure);
  legends.push({ entries: first.placed });
  if (!props.secondLegend) return { legends, last: first.last };
  const { title, entries } = props.secondLegend;
  const second = placeLegend(entries, right, full, full - measure(title), first.last + kLegendRow, measure);
  legends.push({ entries: second.placed, title: { text: title, y: first.last + kLegendRow } });
  return { legends, last: second.last };
}

function layoutNames(names: readonly AxisName[], perUnit: number, label: boolean): NameLayout {
  const fits = (size: number) => names.every((name, i) => i === 0
    || (name.value - names[i - 1]!.value) * perUnit >= 0.5 * (textWidth(name.text, size) + textWidth(names[i - 1]!.text, size)) + 6);
  const base = label ? 50 : 28;
  for (const size of [13.5, 12]) if (fits(size)) return { level: true, size, depth: base };
  const widest = Math.max(...names.map((name) => textWidth(name.short ?? name.text, 12)));
  return { level: false, size: 12, depth: base - 14 + Math.ceil(kSlope * widest + 8) };
}

function axisTicks(axis: Axis, range: readonly [number, number], count: number, toPixel: (si: number) => number, units: Units): Tick[] {
  const factor = axis.si ? units.unit(axis.si).factor : 1;
  if (axis.names) return [];
  const values = Array.isArray(axis.ticks) ? axis.ticks as number[] : ticks(range[0] * factor, range[1] * factor, (axis.ticks as number) ?? count);
  const texts = axis.format ? values.map(axis.format) : tickTexts(values);
  return values.map((value, i) => ({ pixel: toPixel(value / factor), text: texts[i]! }));
}

/** Label of an axis with its unit. */
export function axisLabel(axis: Axis, units: Units): string {
  return axis.si && axis.label ? `${axis.label} [${units.unit(axis.si).name}]` : axis.label ?? '';
}

function yRange(props: ChartProps, units: Units): readonly [number, number] {
  const { range, digits, si } = props.y;
  if (props.equal) return range;
  const decimal = digits === undefined ? 0 : 10 ** -digits / (si ? units.unit(si).factor : 1);
  return widened(range, decimal);
}

/** Pixels left of the plot for numbers and label. */
function leftMargin(props: ChartProps, range: readonly [number, number], units: Units): number {
  const usual = props.left ?? (props.small ? 62 : 88);
  const texts = props.y.names?.map((name) => name.text) ?? axisTicks(props.y, range, 6, (value) => value, units).map((tick) => tick.text);
  return Math.max(usual, ...texts.map((text) => textWidth(text, props.small ? 13 : 14) + (props.y.label ? 38 : 14)));
}

export function layoutChart(props: ChartProps, units: Units): Layout {
  const size = props.small ? 13 : 14;
  const measure = (text: string, bold = false) => textWidth(text, size, bold);
  const width = props.width ?? (props.small ? 480 : 960);
  const [y0, y1] = yRange(props, units);
  const left = leftMargin(props, [y0, y1], units);
  const right = width - (props.right ?? (props.rightAxis ? 74 : 24));
  const titleWidth = props.title ? measure(props.title, true) + 16 : 0;
  const { legends, last } = layoutLegends(props, left, right, measure, titleWidth);
  let [x0, x1] = props.x.range;

  const widestName = Math.max(0, ...(props.lane ?? []).map((name) => textWidth(name.text, 12.5)));
  const head = (props.title || props.legend?.length ? last + 14 : 16);
  const top = head + (widestName > 0 ? Math.ceil(kSlope * widestName) + 8 : 0) + (props.headRoom ?? 0);
  const names = layoutNames(props.x.names ?? [], (right - left) / (x1 - x0 || 1), !!props.x.label);
  const below = props.x.names ? names.depth : props.x.label ? 50 : 30;
  let inner = (props.height ?? 300) - (props.title || props.legend?.length ? 34 : 16) - 50;
  if (props.equal) {
    inner = (right - left) * (y1 - y0) / (x1 - x0);
    const max = props.maxHeight ?? 520;
    if (inner > max) {
      const wanted = (right - left) * (y1 - y0) / max;
      x0 -= 0.5 * (wanted - (x1 - x0));
      x1 = x0 + wanted;
      inner = max;
    }
  }
  const bottom = top + inner;
  const x = linearScale([x0, x1], [left, right]);
  const y = linearScale([y0, y1], [bottom, top]);
  const room = new LabelRoom({ x0: left + 2, x1: props.rightAxis || (props.right ?? 0) > 40 ? right : width - 4, y0: top - 2, y1: bottom });
  const frame = { width, height: bottom + below, left, right, top, bottom, x, y, room, textWidth: measure };

  const yCount = Math.max(3, Math.round(inner / 48));
  const { rightAxis } = props;
  const rightTicks = rightAxis
    ? axisTicks({ range: [0, 0], ticks: 5 }, [y0 * rightAxis.factor, y1 * rightAxis.factor], 5, (value) => y(value / rightAxis.factor), units)
    : [];
  return {
    frame, legends, names,
    xTicks: axisTicks(props.x, [x0, x1], props.small ? 6 : 10, x, units),
    yTicks: axisTicks(props.y, [y0, y1], yCount, y, units),
    rightTicks,
  };
}
