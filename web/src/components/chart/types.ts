// Data of a chart. Values are in the units of the axes: in SI if the axis has `si`.
import type { ComponentChildren } from 'preact';
import type { LabelRoom } from './labels';
import type { Range, Scale } from './scale';

/** A name at a value of an axis; `short` if it is slanted. */
export interface AxisName { value: number; text: string; short?: string }

export interface Axis {
  range: Range;
  label?: string;
  /** SI unit of the values; ticks and label are in the shown unit. Without it values are shown unconverted. */
  si?: string;
  /** Decimals of shown values (metric ones if `si` is given): a y range is widened to this resolution. */
  digits?: number;
  /** Approximate number of ticks, or their values as shown; [] for none. */
  ticks?: number | readonly number[];
  format?: (shown: number) => string;
  /** Names instead of numbers. On the x axis they are horizontal if they fit, otherwise slanted. */
  names?: readonly AxisName[];
}

/** A point of a curve; null leaves a gap. */
export type CurvePoint = readonly [x: number, y: number | null];

export interface Curve {
  points: readonly CurvePoint[];
  colour: string;
  dash?: string;
  /** Line width, 2 by default; 0: no line. */
  width?: number;
  /** Radius of circles at the points. */
  marks?: number;
  /** Circles are filled white. */
  hollow?: boolean;
  /** Tooltip. */
  title?: string;
  /** Labels may cover it. */
  covered?: boolean;
}

/** Area between two curves; null leaves a gap. */
export interface Area {
  points: readonly (readonly [x: number, low: number | null, high: number | null])[];
  colour: string;
  edge?: string;
  edgeWidth?: number;
}

/** Band behind everything, from edge to edge of the plot: a range of x or of y. Without a colour it marks a support. */
export interface Band { x?: Range; y?: Range; colour?: string }

export interface Bar { x: Range; y: Range; colour: string; edge?: string; title?: string }

/** A level from edge to edge, with its name above its right end. Width 0: only the name. */
export interface Level { value: number; colour: string; dash?: string; width?: number; name?: string }

/** A vertical line with an upright name next to it, clear of curves. */
export interface Vertical { x: number; name?: string; colour?: string; dash?: string }

export interface Point {
  x: number;
  y: number;
  colour: string;
  /** Labels, placed clear of curves and other labels, in the order of the list. */
  label?: string;
  /** Labels are tried below the point first. */
  below?: boolean;
  /** 4.5 with a label, otherwise 3.2; 0: only the label. */
  radius?: number;
  shape?: 'circle' | 'triangle' | 'cross';
  edge?: string;
  opacity?: number;
  title?: string;
}

export interface LegendEntry {
  text: string;
  colour: string;
  /** Sample of a line (default). */
  dash?: string;
  width?: number;
  look?: 'line' | 'block' | 'dot';
  edge?: string;
}

/** Scales and edges of the plot in pixels of the drawing, for additional content of a chart. */
export interface Frame {
  width: number;
  height: number;
  left: number;
  right: number;
  top: number;
  bottom: number;
  x: Scale;
  y: Scale;
  /** Free space for labels; any additional text must be reserved here. */
  room: LabelRoom;
  /** Width of a text at the letter size of this chart. */
  textWidth: (text: string, bold?: boolean) => number;
}

export type Drawing = (frame: Frame) => ComponentChildren;

export interface ChartProps {
  title?: string;
  /** 960, or 480 if small, in pixels of the drawing. */
  width?: number;
  /** 300, without the space for names and legend rows above the plot, or names below it. */
  height?: number;
  /** One of several in a row: half as wide, with smaller letters. */
  small?: boolean;
  x: Axis;
  y: Axis;
  /** A second scale on the right: its values are those of y times `factor`. */
  rightAxis?: { factor: number; label: string };
  /** The same scale in both directions: the height follows from the ranges, up to `maxHeight` (520), then x is widened. */
  equal?: boolean;
  maxHeight?: number;
  /** Pixels left and right of the plot, if not the default. */
  left?: number;
  right?: number;
  /** Pixels above the plot for an additional drawing. */
  headRoom?: number;
  /** Slanted names above the plot, without overlaps. */
  lane?: readonly AxisName[];
  /** In the head, from right to left; below the title if there is no room next to it. */
  legend?: readonly LegendEntry[];
  /** A second row with a separate name. */
  secondLegend?: { title: string; entries: readonly LegendEntry[] };

  bands?: readonly Band[];
  areas?: readonly Area[];
  bars?: readonly Bar[];
  curves?: readonly Curve[];
  levels?: readonly Level[];
  verticals?: readonly Vertical[];
  points?: readonly Point[];
  /** Text of the values at x, shown with a line under the pointer; null: none. */
  hover?: (x: number) => string | null;
  /** Pointer position in pixels of the drawing, null when it leaves; `click`: pressed there. */
  onPointer?: (pixel: readonly [number, number] | null, frame: Frame, click: boolean) => void;

  /** The drawing contains buttons. */
  interactive?: boolean;

  /** Drawn behind the grid, not clipped. */
  behind?: Drawing;
  /** Drawn below the curves and clipped to the plot. */
  inside?: Drawing;
  /** Drawn above everything, not clipped. */
  children?: Drawing;
}
