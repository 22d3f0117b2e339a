// Plan of a moored vessel, true to scale: lines with tensions, hull, pipe, objects, directions of waves and current.
import type { VNode } from 'preact';
import { Chart } from './Chart';
import type { Pixel } from './chart/labels';
import { linePath, polygonPoints } from './chart/marks';
import { extent } from './chart/scale';
import type { Frame } from './chart/types';
import { colours } from './colours';
import {
  flat, suspendedAndLaid, hullOutline, lineColours, type MooredState, type MooringLineData, type MooringSpread, type Place,
} from './mooringSpread';
import type { Vector } from './painter';
import { fixed, useUnits, type Units } from './units';

const toPixels = (frame: Frame, points: readonly (Place | Vector)[]): Pixel[] => points.map((p) => [frame.x(p[0]), frame.y(p[1])]);

interface StrokeProps { frame: Frame; points: readonly (Place | Vector)[]; colour: string; width: number; dash?: string }

function Stroke({ frame, points, colour, width, dash }: StrokeProps): VNode {
  const d = linePath(toPixels(frame, points));
  return <path d={d} fill="none" stroke={colour} stroke-width={width} stroke-dasharray={dash} stroke-linejoin="round" />;
}

function Line({ frame, line }: { frame: Frame; line: MooringLineData }): VNode {
  if (line.parted) return <Stroke frame={frame} points={[line.fairlead, line.anchor]} colour={lineColours.parted} width={1.2} dash="3 5" />;
  const [suspended, laid] = suspendedAndLaid(line);
  const colour = line.slack ? lineColours.slack : lineColours.suspended;
  return (
    <g>
      {laid.length > 1 && <Stroke frame={frame} points={laid} colour={lineColours.laid} width={2} />}
      <Stroke frame={frame} points={suspended} colour={colour} width={2.2} dash={line.slack ? '6 4' : undefined} />
    </g>
  );
}

function Touchdown({ frame, line }: { frame: Frame; line: MooringLineData }): VNode | null {
  const [, laid] = suspendedAndLaid(line);
  if (line.parted || laid.length < 2) return null;
  return <circle cx={frame.x(laid[0]![0])} cy={frame.y(laid[0]![1])} r="2.6" fill="#fff" stroke={lineColours.suspended} stroke-width="1.3" />;
}

function Anchor({ frame, line }: { frame: Frame; line: MooringLineData }): VNode {
  const [x, y] = [frame.x(line.anchor[0]), frame.y(line.anchor[1])];
  frame.room.takePoint([x, y], 6);
  return <path d={`M${x - 5} ${y + 4}L${x + 5} ${y + 4}L${x} ${y - 5}Z`} fill="#3d4a56" />;
}

const tensionText = (line: MooringLineData, units: Units): string => (line.parted ? 'parted' : line.slack ? 'slack' : units.shown(line.tension, 'N', 1));

/** Candidate positions of a two-line name around an anchor: away from the line, then above or below, then back along it. */
function namePlaces([x, y]: Pixel, line: MooringLineData, width: number) {
  const [east, north] = [line.anchor[0] - line.fairlead[0], line.anchor[1] - line.fairlead[1]];
  const far = Math.hypot(east, north) || 1;
  const [ux, uy] = [east / far, -north / far];
  return [0, 20, 40].flatMap((out) => [[ux, uy], [ux, 0], [0, uy < 0 ? -1 : 1], [-ux, uy]].map(([cx, cy]) => {
    const size = Math.hypot(cx!, cy!) || 1;
    const [dx, dy] = [cx! / size, cy! / size];
    const left = x + dx * (12 + out) + (Math.abs(dx) > 0.35 ? (dx > 0 ? 0 : -width) : -width / 2);
    const base = y + dy * (16 + out) + (dy < -0.35 ? -18 : dy > 0.35 ? 10 : -3);
    return { x0: left, x1: left + width, y0: base - 12, y1: base + 20, left, base };
  }));
}

/** Name and tension outside the anchor, clear of the line. */
function LineName({ frame, line }: { frame: Frame; line: MooringLineData }): VNode {
  const tension = tensionText(line, useUnits());
  const width = Math.max(frame.textWidth(line.name, true), frame.textWidth(tension));
  const anchor: Pixel = [frame.x(line.anchor[0]), frame.y(line.anchor[1])];
  const { left, base } = frame.room.choose(namePlaces(anchor, line, width));
  const flushRight = left + width < anchor[0];
  const x = flushRight ? left + width : left;
  return (
    <text class="halo" x={x} y={base} text-anchor={flushRight ? 'end' : 'start'}>
      <tspan class="mark">{line.name}</tspan>
      <tspan x={x} dy="17" style={{ fill: line.parted || line.slack ? lineColours.parted : '#41505e' }}>{tension}</tspan>
    </text>
  );
}

function Hull({ frame, spread, state }: { frame: Frame; spread: MooringSpread; state: MooredState }): VNode | null {
  if (!(spread.length > 0)) return null;
  return <polygon points={polygonPoints(toPixels(frame, hullOutline(spread, state)))} fill="#c3ccd5" stroke="#5d6a76" stroke-width="1.2" />;
}

/** Points along an azimuth, clockwise from north. */
export function Arrow({ x, y, azimuth, colour, text }: { x: number; y: number; azimuth: number; colour: string; text: string }): VNode {
  return (
    <g transform={`translate(${x},${y})`}>
      <g transform={`rotate(${(azimuth * 180) / Math.PI})`}>
        <line y1="17" y2="-6.8" stroke={colour} stroke-width="2.4" />
        <path d="M0 -17L7.65 -5.95L-7.65 -5.95Z" fill={colour} />
      </g>
      <text class="halo" x="26" y="5">{text}</text>
    </g>
  );
}

const degrees = (angle: number): string => `${fixed(((angle * 180 / Math.PI) % 360 + 360) % 360, 0)}\u00b0`;

function Directions({ frame, spread }: { frame: Frame; spread: MooringSpread }): VNode {
  const arrows = [{ azimuth: 0, colour: colours.ink as string, text: 'north' }];
  const { waves_from: waves, current_to: current } = spread;
  for (const from of waves) arrows.push({ azimuth: from + Math.PI, colour: '#2f7fb5', text: `waves from ${degrees(from)}` });
  if (current !== null) arrows.push({ azimuth: current, colour: colours.dynamic, text: `current to ${degrees(current)}` });
  const [x, y] = [frame.left + 32, frame.top + 30];
  frame.room.take({ x0: frame.left, x1: x + 150, y0: frame.top, y1: y + 46 * (arrows.length - 1) + 24 });
  return <g>{arrows.map((arrow, k) => <Arrow x={x} y={y + 46 * k} {...arrow} />)}</g>;
}

/** Scale bar of a round length, about a sixth of the width. */
function ScaleBar({ frame }: { frame: Frame }): VNode {
  const unit = useUnits().unit('m');
  const perUnit = Math.abs(frame.x(1) - frame.x(0)) / unit.factor;
  const wanted = (frame.right - frame.left) / 6 / perUnit;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const length = [5, 2, 1].map((k) => k * power).find((value) => value <= wanted) ?? power;
  const [x1, y] = [frame.right - 14, frame.bottom - 14];
  const x0 = x1 - length * perUnit;
  frame.room.take({ x0: x0 - 4, x1: x1 + 4, y0: y - 24, y1: y + 4 });
  return (
    <g>
      <path d={`M${x0} ${y - 5}V${y}H${x1}V${y - 5}`} fill="none" stroke={colours.ink} stroke-width="1.6" />
      <text class="halo" text-anchor="middle" x={(x0 + x1) / 2} y={y - 8}>{length} {unit.name}</text>
    </g>
  );
}

interface NameProps { frame: Frame; position: Place | Vector; text: string; colour?: string; css?: 'mark' | 'soft' }

/** A text near a point, clear of other marks. */
export function Name({ frame, position, text, colour, css = 'mark' }: NameProps): VNode {
  const [x, y] = frame.room.place([frame.x(position[0]), frame.y(position[1])], frame.textWidth(text, css === 'mark'));
  return <text class={`halo ${css}`} x={x} y={y} style={{ fill: colour }}>{text}</text>;
}

type SeabedObject = MooringSpread['objects'][number];

function ObjectShape({ frame, object: { points } }: { frame: Frame; object: SeabedObject }): VNode {
  if (points.length < 2) return <circle cx={frame.x(points[0]![0])} cy={frame.y(points[0]![1])} r="5" fill="#8a5a2b" />;
  return <Stroke frame={frame} points={points} colour="#8a5a2b" width={2.4} dash="9 4" />;
}

function PipeTouchdown({ frame, position }: { frame: Frame; position: Vector }): VNode {
  return <circle cx={frame.x(position[0])} cy={frame.y(position[1])} r="4" fill="#fff" stroke={colours.pipe} stroke-width="2" />;
}

/** Content of the plot. */
function Picture({ frame, spread, state }: { frame: Frame; spread: MooringSpread; state: MooredState }): VNode {
  return (
    <g>
      {spread.objects.map((object) => <ObjectShape frame={frame} object={object} />)}
      {state.lines.map((line) => <Line frame={frame} line={line} />)}
      <Hull frame={frame} spread={spread} state={state} />
      {spread.pipe.length > 0 && <Stroke frame={frame} points={spread.pipe} colour={colours.pipe} width={3} />}
    </g>
  );
}

/** Marks and names above the plot; each reserves its space in this order. */
function Names({ frame, spread, state }: { frame: Frame; spread: MooringSpread; state: MooredState }): VNode {
  for (const line of state.lines) frame.room.takeCurve(toPixels(frame, [line.fairlead, line.anchor]));
  frame.room.takeCurve(toPixels(frame, spread.pipe));
  const touch = spread.pipe.length > 0 ? spread.touchdown : null;
  return (
    <g>
      {state.lines.map((line) => <Touchdown frame={frame} line={line} />)}
      {touch && <PipeTouchdown frame={frame} position={touch} />}
      <Directions frame={frame} spread={spread} />
      <ScaleBar frame={frame} />
      {state.lines.map((line) => <Anchor frame={frame} line={line} />)}
      {spread.objects.map((object) => (
        <Name frame={frame} position={object.points[Math.floor(object.points.length / 2)]!} text={object.name} colour="#6d4620" />
      ))}
      {touch && <Name frame={frame} position={touch} text="pipe, touchdown" colour={colours.pipe} />}
      {state.lines.map((line) => <LineName frame={frame} line={line} />)}
    </g>
  );
}

export function PlanView({ spread, state }: { spread: MooringSpread; state: MooredState }): VNode {
  const seen = [...state.lines.flatMap((line) => [line.anchor, line.fairlead].map(flat)), ...hullOutline(spread, state), ...spread.pipe.map(flat)];
  const [x0, x1] = extent(seen.map((p) => p[0]));
  const [y0, y1] = extent(seen.map((p) => p[1]));
  const room = 0.1 * Math.max(x1 - x0, y1 - y0, 10);
  const legend = [{ text: 'hanging', colour: lineColours.suspended }, { text: 'on the seabed', colour: lineColours.laid }];
  return (
    <Chart
      title="Moorings in plan, true to scale"
      equal
      maxHeight={640}
      x={{ label: 'East', si: 'm', ticks: 8, range: [x0 - room, x1 + room] }}
      y={{ label: 'North', si: 'm', range: [y0 - room, y1 + room] }}
      legend={spread.pipe.length > 0 ? [...legend, { text: 'pipe', colour: colours.pipe, width: 3 }] : legend}
      inside={(frame) => <Picture frame={frame} spread={spread} state={state} />}
    >
      {(frame) => <Names frame={frame} spread={spread} state={state} />}
    </Chart>
  );
}
