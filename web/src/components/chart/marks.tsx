// Curves, areas, bars, levels and points of a chart.
import type { VNode } from 'preact';
import { colours } from '../colours';
import type { Pixel } from './labels';
import type { Area, Band, Bar, Curve, Frame, Level, Point, Vertical } from './types';

const rounded = (value: number) => String(Math.round(100 * value) / 100);

/** Path through pixels. */
export const linePath = (pixels: readonly Pixel[]): string => pixels.map(([x, y], i) => `${i === 0 ? 'M' : 'L'}${rounded(x)},${rounded(y)}`).join('');

/** `points` attribute of a polygon or polyline. */
export const polygonPoints = (pixels: readonly Pixel[]): string => pixels.map(([x, y]) => `${rounded(x)},${rounded(y)}`).join(' ');

/** Runs of items between gaps. */
export function runs<T>(items: readonly T[], isGap: (item: T) => boolean): T[][] {
  const list: T[][] = [[]];
  for (const item of items) {
    if (!isGap(item)) list[list.length - 1]!.push(item);
    else if (list[list.length - 1]!.length > 0) list.push([]);
  }
  return list.filter((run) => run.length > 0);
}

export function curvePixels(frame: Frame, curve: Curve): Pixel[][] {
  const isGap = ([x, y]: Curve['points'][number]) => y === null || !Number.isFinite(y) || !Number.isFinite(x);
  return runs(curve.points, isGap).map((run) => run.map(([x, y]) => [frame.x(x), frame.y(y!)] as const));
}

export function CurveLine({ frame, curve }: { frame: Frame; curve: Curve }): VNode {
  const { colour, dash, width = 2, marks, hollow, title } = curve;
  const pieces = curvePixels(frame, curve);
  return (
    <g>
      {title && <title>{title}</title>}
      {width > 0 && (
        <path
          d={pieces.map(linePath).join('')}
          fill="none"
          stroke={colour}
          stroke-width={width}
          stroke-dasharray={dash}
          stroke-linejoin="round"
        />
      )}
      {marks && pieces.flat().map(([x, y]) => (
        <circle cx={rounded(x)} cy={rounded(y)} r={marks} fill={hollow ? '#fff' : colour} stroke={hollow ? colour : undefined} stroke-width={1.5} />
      ))}
    </g>
  );
}

export function FilledArea({ frame, area }: { frame: Frame; area: Area }): VNode {
  const pieces = runs(area.points, ([, low, high]) => low === null || high === null);
  const outline = (run: Area['points']) => [
    ...run.map(([x, , high]) => [frame.x(x), frame.y(high!)] as const),
    ...[...run].reverse().map(([x, low]) => [frame.x(x), frame.y(low!)] as const),
  ];
  return (
    <path
      d={pieces.map((run) => `${linePath(outline(run))}Z`).join('')}
      fill={area.colour}
      stroke={area.edge}
      stroke-width={area.edgeWidth ?? 1}
      stroke-linejoin="round"
    />
  );
}

export function BandRectangle({ frame, band }: { frame: Frame; band: Band }): VNode {
  const clamp = (value: number, lo: number, hi: number) => Math.min(Math.max(value, lo), hi);
  const [x0, x1] = band.x ? band.x.map((value) => clamp(frame.x(value), frame.left, frame.right)) as [number, number] : [frame.left, frame.right];
  const [y1, y0] = band.y ? band.y.map((value) => clamp(frame.y(value), frame.top, frame.bottom)) as [number, number] : [frame.bottom, frame.top];
  return <rect class={band.colour ? undefined : 'support'} x={x0} y={y0} width={Math.max(x1 - x0, 0)} height={Math.max(y1 - y0, 0)} fill={band.colour} />;
}

export function BarRectangle({ frame, bar }: { frame: Frame; bar: Bar }): VNode {
  const [x0, x1] = [frame.x(bar.x[0]), frame.x(bar.x[1])];
  const [y0, y1] = [frame.y(bar.y[1]), frame.y(bar.y[0])];
  return (
    <rect x={rounded(x0)} y={rounded(y0)} width={rounded(x1 - x0)} height={rounded(Math.max(y1 - y0, 0))} fill={bar.colour} stroke={bar.edge}>
      {bar.title && <title>{bar.title}</title>}
    </rect>
  );
}

export function LevelLine({ frame, level }: { frame: Frame; level: Level }): VNode {
  const y = frame.y(level.value);
  return (
    <path
      d={linePath([[frame.left, y], [frame.right, y]])}
      fill="none"
      stroke={level.colour}
      stroke-width={level.width ?? 1.3}
      stroke-dasharray={level.dash}
    />
  );
}

/** Name of a level at its right end; null if the level is outside the plot. */
export function LevelName({ frame, level }: { frame: Frame; level: Level }): VNode | null {
  const [lo, hi] = frame.y.domain;
  if (!level.name || level.value < lo || level.value > hi) return null;
  const [x, y] = [frame.right - 5, frame.y(level.value) - 5];
  frame.room.take({ x0: x - frame.textWidth(level.name) - 4, x1: x + 4, y0: y - 14, y1: y + 4 });
  return <text class="soft halo level" text-anchor="end" x={x} y={rounded(y)} style={{ fill: level.colour }}>{level.name}</text>;
}

export function VerticalLine({ frame, vertical }: { frame: Frame; vertical: Vertical }): VNode {
  const x = rounded(frame.x(vertical.x));
  return <line x1={x} x2={x} y1={frame.top} y2={frame.bottom} stroke={vertical.colour ?? colours.soft} stroke-dasharray={vertical.dash ?? '2 3'} />;
}

export function VerticalName({ frame, vertical }: { frame: Frame; vertical: Vertical }): VNode | null {
  if (!vertical.name) return null;
  const [x, y] = frame.room.placeUpright(frame.x(vertical.x), frame.textWidth(vertical.name));
  return <text class="soft" transform={`translate(${rounded(x)},${rounded(y)}) rotate(-90)`} style={{ fontSize: '12.5px' }}>{vertical.name}</text>;
}

const kShapes = { triangle: 'M-5,2L5,2L0,-7Z', cross: 'M-4,-4L4,4M4,-4L-4,4' };

export const pointRadius = (point: Point): number => point.radius ?? (point.label ? 4.5 : 3.2);

export function PointMark({ frame, point }: { frame: Frame; point: Point }): VNode | null {
  const radius = pointRadius(point);
  const [x, y] = [rounded(frame.x(point.x)), rounded(frame.y(point.y))];
  const title = point.title && <title>{point.title}</title>;
  if (radius <= 0) return null;
  if (point.shape === 'triangle') return <path d={kShapes.triangle} transform={`translate(${x},${y})`} fill={point.colour}>{title}</path>;
  if (point.shape === 'cross') {
    return <path d={kShapes.cross} transform={`translate(${x},${y})`} stroke={point.colour} stroke-width={1.6} fill="none">{title}</path>;
  }
  return (
    <circle
      cx={x}
      cy={y}
      r={radius}
      fill={point.colour}
      fill-opacity={point.opacity}
      stroke={point.edge ?? (point.label ? '#fff' : undefined)}
      stroke-width={1.3}
    >
      {title}
    </circle>
  );
}

/** A label near a point, clear of occupied space. */
export function PointLabel({ frame, point }: { frame: Frame; point: Point }): VNode | null {
  if (!point.label) return null;
  const [x, y] = frame.room.place([frame.x(point.x), frame.y(point.y)], frame.textWidth(point.label, true), point.below);
  return <text class="mark halo" x={rounded(x)} y={rounded(y)} style={{ fill: point.edge ?? point.colour }}>{point.label}</text>;
}
