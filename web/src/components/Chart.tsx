// A chart in SVG, made from data: axes with units, curves, areas, bars, points with labels, legend and values under the
// pointer. Its props are described in chart/types.ts. Sizes are pixels of the drawing, which is scaled to the page.
//
//   <Chart title="Effective tension" x={{ range: [0, 200], label: 'Distance', si: 'm' }} y={{ range, si: 'N', digits: 1 }}
//     curves={[{ points, colour: colours.pipe }]} points={[{ x, y, colour: colours.pipe, label: '812 kN' }]}
//     hover={(x) => `${units.shown(value(x), 'N', 1)} at ${units.shown(x, 'm', 1)}`}>
//     {(frame) => <circle cx={frame.x(10)} cy={frame.y(0)} r="3" />}
//   </Chart>
import type { ComponentChildren, VNode } from 'preact';
import { useRef, useState } from 'preact/hooks';
import { axisLabel, kSlant, layoutChart, type Layout, type PlacedEntry } from './chart/frame';
import { visibleNames } from './chart/labels';
import { BandRectangle, BarRectangle, CurveLine, curvePixels, FilledArea, LevelLine, LevelName, PointLabel, PointMark, pointRadius, VerticalLine,
  VerticalName } from './chart/marks';
import { usePointer } from './chart/pointer';
import type { AxisName, ChartProps, Frame } from './chart/types';
import { colours } from './colours';
import { useUnits, type Units } from './units';

let charts = 0;

interface AslantProps { names: { x: number; text: string }[]; y: number; angle: number; anchor: 'start' | 'end'; size: number }

/** Names at one angle; a name that would cover the previous one is left out. */
export function AslantNames({ names, y, angle, anchor, size }: AslantProps): VNode {
  return (
    <g>
      {visibleNames(names, angle, size).map(({ x, text }) => (
        <text class="soft name" text-anchor={anchor} transform={`translate(${x},${y}) rotate(${angle})`} style={{ fontSize: `${size}px` }}>{text}</text>
      ))}
    </g>
  );
}

function Grid({ layout: { frame, xTicks, yTicks } }: { layout: Layout }) {
  return (
    <g class="grid">
      {xTicks.map(({ pixel }) => <line x1={pixel} x2={pixel} y1={frame.top} y2={frame.bottom} />)}
      {yTicks.map(({ pixel }) => <line x1={frame.left} x2={frame.right} y1={pixel} y2={pixel} />)}
    </g>
  );
}

function XNames({ names, layout: { frame, names: look } }: { names: readonly AxisName[]; layout: Layout }) {
  if (!look.level) {
    const list = names.map((name) => ({ x: frame.x(name.value) + 4, text: name.short ?? name.text }));
    return <AslantNames names={list} y={frame.bottom + 13} angle={-kSlant} anchor="end" size={look.size} />;
  }
  return (
    <g text-anchor="middle">
      {names.map((name) => <text class="soft name" x={frame.x(name.value)} y={frame.bottom + 18} style={{ fontSize: `${look.size}px` }}>{name.text}</text>)}
    </g>
  );
}

function LaneNames({ names, frame }: { names: readonly AxisName[]; frame: Frame }) {
  const list = names.map((name) => ({ x: frame.x(name.value) + 3, text: name.text }));
  return <AslantNames names={list} y={frame.top - 5} angle={-kSlant} anchor="start" size={12.5} />;
}

function Axes({ props, layout, units }: { props: ChartProps; layout: Layout; units: Units }) {
  const { frame, xTicks, yTicks, rightTicks } = layout;
  const { left, right, top, bottom } = frame;
  const middle = 0.5 * (top + bottom);
  return (
    <g>
      <g text-anchor="middle">
        <path class="domain" fill="none" d={`M${left},${bottom}H${right}`} />
        {xTicks.map(({ pixel, text }) => (
          <g class="tick" transform={`translate(${pixel},${bottom})`}>
            <line y2="6" />
            <text y="20">{text}</text>
          </g>
        ))}
      </g>
      {props.x.names && <XNames names={props.x.names} layout={layout} />}
      <g text-anchor="end">
        <path class="domain" fill="none" d={`M${left},${top}V${bottom}`} />
        {yTicks.map(({ pixel, text }) => (
          <g class="tick" transform={`translate(${left},${pixel})`}>
            <line x2="-6" />
            <text x="-9" dy="0.32em">{text}</text>
          </g>
        ))}
        {props.y.names?.map((name) => <text class="soft name" x={left - 9} y={frame.y(name.value)} dy="0.32em">{name.text}</text>)}
      </g>
      {props.rightAxis && (
        <g text-anchor="start">
          <path class="domain" fill="none" d={`M${right},${top}V${bottom}`} />
          {rightTicks.map(({ pixel, text }) => (
            <g class="tick" transform={`translate(${right},${pixel})`}>
              <line x2="6" />
              <text x="9" dy="0.32em">{text}</text>
            </g>
          ))}
          <text class="soft" text-anchor="middle" transform={`translate(${frame.width - 12},${middle}) rotate(-90)`}>{props.rightAxis.label}</text>
        </g>
      )}
      <text class="soft" text-anchor="middle" x={0.5 * (left + right)} y={frame.height - 10}>{axisLabel(props.x, units)}</text>
      <text class="soft" text-anchor="middle" transform={`translate(17,${middle}) rotate(-90)`}>{axisLabel(props.y, units)}</text>
    </g>
  );
}

function LegendKey({ entry }: { entry: PlacedEntry }) {
  const start = entry.right - entry.textWidth;
  if (entry.look === 'block') return <rect x={start - 22} y={entry.y - 11} width="14" height="12" fill={entry.colour} stroke={entry.edge} />;
  if (entry.look === 'dot') return <circle cx={start - 14} cy={entry.y - 5} r="4" fill={entry.colour} stroke={entry.edge} />;
  return <path d={`M${start - 34},${entry.y - 5}H${start - 8}`} stroke={entry.colour} stroke-width={entry.width ?? 2.2} stroke-dasharray={entry.dash} />;
}

function Head({ props, layout: { frame, legends } }: { props: ChartProps; layout: Layout }) {
  return (
    <g>
      {props.title && <text class="title" x={frame.left} y="20">{props.title}</text>}
      {legends.map(({ entries, title }) => (
        <g>
          {title && <text class="soft" x={frame.left} y={title.y}>{title.text}</text>}
          {entries.map((entry) => (
            <g>
              <text x={entry.right} y={entry.y} text-anchor="end">{entry.text}</text>
              <LegendKey entry={entry} />
            </g>
          ))}
        </g>
      ))}
    </g>
  );
}

/** A line under the pointer with the values at its position. */
function HoverLine({ frame, hover }: { frame: Frame; hover: (x: number) => string | null }) {
  const group = useRef<SVGGElement>(null);
  const [x, setX] = useState<number | null>(null);
  usePointer(group, (pixel) => setX(pixel ? frame.x.invert(pixel[0]) : null));
  const [lo, hi] = frame.x.domain;
  const text = x === null || x < lo || x > hi ? null : hover(x);
  if (x === null || text === null) return <g ref={group} />;
  const pixel = frame.x(x);
  const width = frame.textWidth(text);
  const start = pixel > 0.6 * frame.width ? pixel - 8 - width : pixel + 8;
  return (
    <g ref={group} pointer-events="none">
      <line x1={pixel} x2={pixel} y1={frame.top} y2={frame.bottom} stroke={colours.soft} />
      <text class="halo" x={Math.max(Math.min(start, frame.width - width - 4), 4)} y={frame.top + 14}>{text}</text>
    </g>
  );
}

function PointerWatch({ frame, onPointer }: { frame: Frame; onPointer: NonNullable<ChartProps['onPointer']> }) {
  const group = useRef<SVGGElement>(null);
  usePointer(group, (pixel, click) => onPointer(pixel, frame, click));
  return <g ref={group} />;
}

/** Reserves the space of everything that labels avoid. */
function takePlaces(props: ChartProps, frame: Frame) {
  for (const curve of props.curves ?? []) if (!curve.covered) curvePixels(frame, curve).forEach((run) => frame.room.takeCurve(run));
  for (const { points } of props.areas ?? []) {
    for (const side of [1, 2] as const) {
      curvePixels(frame, { colour: '', points: points.map((p) => [p[0], p[side]] as const) }).forEach((run) => frame.room.takeCurve(run));
    }
  }
  const { left, right, top, bottom, x, y, room } = frame;
  for (const { value, width } of props.levels ?? []) if (width !== 0) room.takeCurve([[left, y(value)], [right, y(value)]]);
  for (const vertical of props.verticals ?? []) room.takeCurve([[x(vertical.x), top], [x(vertical.x), bottom]]);
  for (const bar of props.bars ?? []) room.take({ x0: x(bar.x[0]), x1: x(bar.x[1]), y0: y(bar.y[1]), y1: y(bar.y[0]) });
  for (const point of props.points ?? []) room.takePoint([x(point.x), y(point.y)], pointRadius(point));
}

/** Labels are placed as they are drawn: names of levels first, then points, then verticals. */
function Labels({ props, frame }: { props: ChartProps; frame: Frame }) {
  const labels: ComponentChildren[] = [];
  for (const level of props.levels ?? []) labels.push(LevelName({ frame, level }));
  for (const point of props.points ?? []) labels.push(PointLabel({ frame, point }));
  for (const vertical of props.verticals ?? []) labels.push(VerticalName({ frame, vertical }));
  return <g>{labels}</g>;
}

export function Chart(props: ChartProps): VNode {
  const units = useUnits();
  const [clip] = useState(() => `clip-${++charts}`);
  const layout = layoutChart(props, units);
  const { frame } = layout;
  takePlaces(props, frame);
  const drawing = props.children?.(frame);
  return (
    <svg
      viewBox={`0 0 ${frame.width} ${frame.height.toFixed(1)}`}
      class={props.small ? 'drawing small' : 'drawing'}
      role={props.interactive ? 'group' : 'img'}
      aria-label={props.title ?? axisLabel(props.y, units)}
    >
      <clipPath id={clip}>
        <rect x={frame.left} y={frame.top} width={frame.right - frame.left} height={frame.bottom - frame.top} />
      </clipPath>
      <g>
        {props.bands?.map((band) => <BandRectangle frame={frame} band={band} />)}
        {props.behind?.(frame)}
      </g>
      <Grid layout={layout} />
      <g clip-path={`url(#${clip})`}>
        {props.inside?.(frame)}
        {props.areas?.map((area) => <FilledArea frame={frame} area={area} />)}
        {props.bars?.map((bar) => <BarRectangle frame={frame} bar={bar} />)}
        {props.levels?.filter((level) => level.width !== 0).map((level) => <LevelLine frame={frame} level={level} />)}
        {props.curves?.map((curve) => <CurveLine frame={frame} curve={curve} />)}
      </g>
      <Axes props={props} layout={layout} units={units} />
      <Head props={props} layout={layout} />
      <g>
        {props.verticals?.map((vertical) => <VerticalLine frame={frame} vertical={vertical} />)}
        {props.lane && <LaneNames names={props.lane} frame={frame} />}
        {props.points?.map((point) => <PointMark frame={frame} point={point} />)}
        {drawing}
        <Labels props={props} frame={frame} />
      </g>
      {props.hover && <HoverLine frame={frame} hover={props.hover} />}
      {props.onPointer && <PointerWatch frame={frame} onPointer={props.onPointer} />}
    </svg>
  );
}
