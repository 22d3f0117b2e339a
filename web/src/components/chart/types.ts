// What a chart is made of. Values are in the units of the axes: in SI where the axis has `si`.
import type { ComponentChildren } from 'preact';
import type { LabelRoom } from './labels';
import type { Range, Scale } from './scale';

/** A name at a value of an axis; `short` where it stands aslant. */
export interface AxisName { value: number; text: string; short?: string }

export interface Axis {
  range: Range;
  label?: string;
  /** SI unit of the values; ticks and label are in the unit that they are shown in. Without it values are shown as they are. */
  si?: string;
  /** Decimals that values are shown with (metric ones where `si` is given): a y range is widened to what they can tell apart. */
  digits?: number;
  /** About how many ticks, or their values as shown; [] for none. */
  ticks?: number | readonly number[];
  format?: (shown: number) => string;
  /** Names instead of numbers. On the x axis they stand level where there is room, otherwise aslant. */
  names?: readonly AxisName[];
}

/** A point of a curve; null leaves a gap. */
export type CurvePoint = readonly [x: number, y: number | null];

export interface Curve {
  points: readonly CurvePoint[];
  colour: string;
  dash?: string;
  /** Of the line, 2 unless given; 0: no line. */
  width?: number;
  /** Radius of circles at the points. */
  marks?: number;
  /** Circles are filled white. */
  hollow?: boolean;
  /** Shown where the pointer rests on it. */
  title?: string;
  /** Labels may cover it. */
  covered?: boolean;
}

/** Filled between two curves; null leaves a gap. */
export interface Area {
  points: readonly (readonly [x: number, low: number | null, high: number | null])[];
  colour: string;
  edge?: string;
  edgeWidth?: number;
}

/** Behind everything, from edge to edge of the plot: a range of x or of y. Without a colour as a support. */
export interface Band { x?: Range; y?: Range; colour?: string }

export interface Bar { x: Range; y: Range; colour: string; edge?: string; title?: string }

/** A level from edge to edge, its name at the right end right above it. Width 0: only the name. */
export interface Level { value: number; colour: string; dash?: string; width?: number; name?: string }

/** A vertical line, its name upright beside it where no curve runs. */
export interface Vertical { x: number; name?: string; colour?: string; dash?: string }

export interface Point {
  x: number;
  y: number;
  colour: string;
  /** Placed clear of curves and other labels, in the order of the list. */
  label?: string;
  /** Labels are tried below the point first. */
  below?: boolean;
  /** 4.5 with a label, else 3.2; 0: only the label. */
  radius?: number;
  shape?: 'circle' | 'triangle' | 'cross';
  edge?: string;
  opacity?: number;
  title?: string;
}

export interface LegendEntry {
  text: string;
  colour: string;
  /** Of a line (default) */
  dash?: string;
  width?: number;
  look?: 'line' | 'block' | 'dot';
  edge?: string;
}

/** Scales and edges of the plot in pixels of the drawing, for what a chart draws of its own. */
export interface Frame {
  width: number;
  height: number;
  left: number;
  right: number;
  top: number;
  bottom: number;
  x: Scale;
  y: Scale;
  /** Where labels may stand; whoever draws a text of his own takes its place here. */
  room: LabelRoom;
  /** Width of a text in the size of this chart. */
  textWidth: (text: string, bold?: boolean) => number;
}

export type Drawing = (frame: Frame) => ComponentChildren;

export interface ChartProps {
  title?: string;
  /** 960, or 480 where small, in pixels of the drawing. */
  width?: number;
  /** 300, without the room for names and rows of the legend above the plot, or names below it. */
  height?: number;
  /** One of several in a row: half as wide, with smaller texts. */
  small?: boolean;
  x: Axis;
  y: Axis;
  /** A second scale on the right: its values are those of y times `factor`. */
  rightAxis?: { factor: number; label: string };
  /** The same scale both ways: the height follows from the ranges, up to `maxHeight` (520), then x is widened. */
  equal?: boolean;
  maxHeight?: number;
  /** Pixels left and right of the plot, where others than usual. */
  left?: number;
  right?: number;
  /** Pixels above the plot for a drawing of one's own. */
  headRoom?: number;
  /** Names aslant above the plot, where they do not cover each other. */
  lane?: readonly AxisName[];
  /** In the head, from right to left; below the title where there is no room beside it. */
  legend?: readonly LegendEntry[];
  /** A second row with a name of its own. */
  secondLegend?: { title: string; entries: readonly LegendEntry[] };

  bands?: readonly Band[];
  areas?: readonly Area[];
  bars?: readonly Bar[];
  curves?: readonly Curve[];
  levels?: readonly Level[];
  verticals?: readonly Vertical[];
  points?: readonly Point[];
  /** Words for what is at a value of x, shown with a line under the pointer; null: nothing there. */
  hover?: (x: number) => string | null;
  /** The pointer's place in pixels of the drawing, null when it leaves; `click`: pressed there. */
  onPointer?: (pixel: readonly [number, number] | null, frame: Frame, click: boolean) => void;

  /** Its drawing has buttons. */
  interactive?: boolean;

  /** Drawn behind the grid, not clipped. */
  behind?: Drawing;
  /** Drawn below the curves and clipped to the plot. */
  inside?: Drawing;
  /** Drawn above everything, not clipped. */
  children?: Drawing;
}
