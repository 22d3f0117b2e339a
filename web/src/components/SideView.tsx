// Elevation of the line: water, seabed, hull, ramp and stinger with their rollers, pipe.
import type { ComponentChildren, VNode } from 'preact';
import { Chart } from './Chart';
import { extent } from './chart/scale';
import { linePath, polygonPoints } from './chart/marks';
import { textWidth } from './chart/text';
import type { Frame, LegendEntry } from './chart/types';
import { colours } from './colours';
import {
  belowBox, hullCorner, hullHeights, seabedHeight, seabedPlaces, stationsUpTo, structures, wholeEnd,
  type LayData, type RollerData, type SupportData,
} from './lay';
import { useUnits } from './units';

export const rollerLooks = { contact: '#e08a3c', noContact: '#c4ccd4' };
const frameColour = '#3d4a56';

type Place = readonly [number, number];

const toPixels = (frame: Frame, points: readonly Place[]): Place[] => points.map(([x, z]) => [frame.x(x), frame.y(z)]);

/** Pixels per metre horizontally and vertically; the axes may run in either direction. */
export const pixelsPerMetre = (frame: Frame): Place => [Math.abs(frame.x(1) - frame.x(0)), Math.abs(frame.y(1) - frame.y(0))];

export const polygonIn = (frame: Frame, points: readonly Place[]): string => polygonPoints(toPixels(frame, points));

/** Pipe axis in the elevation. */
export const pipeElevation = ({ stations }: LayData, indices: readonly number[]): Place[] => indices.map((i) => [stations.x[i]!, stations.z[i]!]);

interface SeaProps { frame: Frame; bed: readonly Place[]; hull: readonly Place[] }

/** Water, seabed and hull; the seabed from edge to edge, the hull by its corners. */
export function Sea({ frame, bed, hull }: SeaProps): VNode {
  const [lowest, highest] = frame.y.domain;
  const surface = Math.min(0, highest);
  const [x0, x1] = frame.x.domain;
  return (
    <g>
      {lowest < 0 && <polygon points={polygonIn(frame, [[x0, surface], [x1, surface], [x1, lowest], [x0, lowest]])} fill="var(--sea, #eaf3f9)" opacity="0.75" />}
      {bed.length > 0 && <polygon points={polygonIn(frame, [...bed, [x1, lowest - 1], [x0, lowest - 1]])} fill="var(--bed, #e4dac6)" />}
      {highest > 0 && lowest < 0 && <line x1={frame.left} x2={frame.right} y1={frame.y(0)} y2={frame.y(0)} stroke="#6fa8cc" stroke-width="1.2" />}
      {hull.length > 0 && <polygon points={polygonIn(frame, hull)} fill="var(--hull, #c3ccd5)" fill-opacity="0.55" stroke={colours.steel} />}
    </g>
  );
}

/** Surroundings of a lay. */
export function Surroundings({ frame, lay }: { frame: Frame; lay: LayData }): VNode {
  const [x0, x1] = frame.x.domain;
  const bed = seabedPlaces(lay, x0, x1).map((x): Place => [x, seabedHeight(lay, x)]);
  const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([along, up]) => hullCorner(lay, along!, 0, up!, ...hullHeights(lay)));
  return <Sea frame={frame} bed={bed} hull={corners.map((p) => [p[0], p[2]] as const)} />;
}

/** Schematic structure: two chords below the boxes, posts at the boxes. */
export function Structure({ frame, boxes }: { frame: Frame; boxes: SupportData[] }): VNode {
  const chord = (down: number): Place[] =>
    boxes.flatMap((box) => [-0.5, 0.5].map((k) => belowBox(box, k * box.length, down))).map((p) => [p[0], p[2]] as const);
  const [upper, lower] = [chord(0.55), chord(boxes[0]!.stinger ? 1.9 : 0.9)];
  const posts = upper.flatMap((p, i) => [p, lower[i]!]);
  return (
    <g fill="none">
      <polyline points={polygonIn(frame, posts)} stroke="#b4bec7" stroke-width="1" />
      <polyline points={polygonIn(frame, upper)} stroke="#9aa6b1" stroke-width="1.6" />
      <polyline points={polygonIn(frame, lower)} stroke="#9aa6b1" stroke-width="1.6" />
    </g>
  );
}

function BottomRoller({ frame, roller }: { frame: Frame; roller: RollerData }): VNode {
  const [across, upwards] = pixelsPerMetre(frame);
  return (
    <ellipse
      cx={frame.x(roller.p[0] - roller.radius * roller.normal[0])}
      cy={frame.y(roller.p[2] - roller.radius * roller.normal[2])}
      rx={roller.radius * across}
      ry={roller.radius * upwards}
      fill={roller.reaction > 0 ? rollerLooks.contact : rollerLooks.noContact}
      stroke={frameColour}
      stroke-width="0.8"
    />
  );
}

/** A side roller, seen across its axis: an outline in front of the pipe, filled behind it. */
function SideRoller({ frame, roller, front }: { frame: Frame; roller: RollerData; front: boolean }): VNode {
  const [x, z] = [roller.p[0] - roller.radius * roller.normal[0], roller.p[2] - roller.radius * roller.normal[2]];
  const [ax, az] = [roller.axis[0], roller.axis[2]];
  const length = Math.hypot(ax, az) || 1;
  const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([k, m]): Place => [
    x + k! * ax * roller.face / 2 - m! * az / length * roller.radius,
    z + k! * az * roller.face / 2 + m! * ax / length * roller.radius,
  ]);
  return (
    <polygon
      points={polygonIn(frame, corners)}
      fill={roller.reaction > 0 ? rollerLooks.contact : front ? 'none' : '#e2e7ec'}
      fill-opacity={front ? 0.5 : 1}
      stroke="#6b7986"
      stroke-width="0.7"
      stroke-dasharray={front ? '3 2' : undefined}
    />
  );
}

export function Rollers({ frame, boxes, position }: { frame: Frame; boxes: SupportData[]; position: RollerData['position'] }): VNode {
  const rollers = boxes.flatMap((box) => box.rows.flatMap((row) => row.rollers)).filter((roller) => roller.position === position);
  return (
    <g>
      {rollers.map((roller) => (position === 'bottom'
        ? <BottomRoller frame={frame} roller={roller} />
        : <SideRoller frame={frame} roller={roller} front={position === 'port'} />))}
    </g>
  );
}

/** The pipe with its true diameters, at the horizontal scale. */
export function TruePipe({ frame, lay }: { frame: Frame; lay: LayData }): VNode {
  const [across] = pixelsPerMetre(frame);
  const [diameter, steel] = [lay.pipe_outer_diameter * across, lay.steel_outer_diameter * across];
  const d = linePath(toPixels(frame, pipeElevation(lay, stationsUpTo(lay, wholeEnd(lay)))));
  return (
    <g fill="none" stroke-linejoin="round">
      <path d={d} stroke="var(--outline, #3d4a56)" stroke-width={Math.max(diameter + 1.2, 2.6)} />
      <path d={d} stroke="var(--coating, #dfe5ea)" stroke-width={Math.max(diameter - 0.6, 0.8)} />
      <path d={d} stroke={colours.pipe} stroke-width={steel} stroke-opacity="0.5" />
      {diameter > 14 && <path d={d} stroke="#fff" stroke-width="1" stroke-dasharray="14 4 3 4" />}
    </g>
  );
}

/** Height of the pipe axis above the centre of a box; the pipe may be clear of it. */
export function pipeAbove({ stations: { x, z } }: LayData, box: SupportData): number {
  const i = x.findIndex((_, k) => k > 0 && (x[k - 1]! - box.p[0]) * (x[k]! - box.p[0]) <= 0);
  if (i < 0) return box.p[2];
  const t = (box.p[0] - x[i - 1]!) / (x[i]! - x[i - 1]! || 1);
  return Math.max(box.p[2], z[i - 1]! + t * (z[i]! - z[i - 1]!));
}

export interface PlacedName { x: number; y: number; text: string }

interface NamesProps { names: PlacedName[]; angle: number; anchor: 'start' | 'end'; css: string; size: number }

/** Slanted names at separate points, without those that would cover the previous one. */
export function NamesAt({ names, angle, anchor, css, size }: NamesProps): VNode {
  const turn = angle * Math.PI / 180;
  const shown: PlacedName[] = [];
  for (const name of names) {
    const last = shown.at(-1);
    if (last && Math.abs((name.x - last.x) * Math.sin(turn) - (name.y - last.y) * Math.cos(turn)) < size + 1) continue;
    shown.push(name);
  }
  return (
    <g text-anchor={anchor}>
      {shown.map((name) => (
        <text class={`${css} name`} text-anchor={anchor} transform={`translate(${name.x},${name.y}) rotate(${angle})`} style={{ fontSize: size }}>
          {name.text}
        </text>
      ))}
    </g>
  );
}

const nameSize = 13;

function BoxNames({ frame, lay }: { frame: Frame; lay: LayData }): VNode {
  const [x0, x1] = frame.x.domain;
  const clear = 0.5 * lay.pipe_outer_diameter * (frame.x(1) - frame.x(0)) + 10;
  const names = lay.supports.filter((box) => box.p[0] >= x0 && box.p[0] <= x1)
    .map((box) => ({ x: frame.x(box.p[0]) + 5, y: frame.y(pipeAbove(lay, box)) - clear, text: box.name }))
    .filter((name) => {
      const long = textWidth(name.text, nameSize);
      return name.y - 0.82 * long > frame.top + 2 && name.x + 0.57 * long < frame.width - 2;
    });
  return <NamesAt names={names} angle={-55} anchor="start" css="halo" size={nameSize} />;
}

function WaterName({ frame }: { frame: Frame }): VNode | null {
  const [lowest, highest] = frame.y.domain;
  if (lowest > 0 || highest < 0 || frame.y(0) < frame.top + 16) return null;
  return <text class="soft" text-anchor="end" x={frame.right - 6} y={frame.y(0) - 5} style={{ fontSize: '13px' }}>mean water level</text>;
}

/** Reaction, or the separation if there is no contact, below each bottom roller of a box. */
function Separations({ frame, box }: { frame: Frame; box: SupportData }): VNode {
  const units = useUnits();
  const rollers = box.rows.flatMap((row) => row.rollers.find((roller) => roller.position === 'bottom') ?? []);
  return (
    <g text-anchor="middle">
      {rollers.map((roller) => (
        <text
          class="halo"
          x={frame.x(roller.p[0])}
          y={frame.y(roller.p[2]) + 2 * roller.radius * (frame.x(1) - frame.x(0)) + 18}
          style={{ fontSize: '13px', fill: roller.reaction > 0 ? '#a85200' : undefined }}
        >
          {roller.reaction > 0 ? units.shown(roller.reaction, 'N', 1) : units.shown(roller.separation, 'section', 1)}
        </text>
      ))}
    </g>
  );
}

export const elevationAxes = { x: { label: 'X, astern of the stern shoe', si: 'm' }, y: { label: 'Z, above the water', si: 'm' } };

interface SideViewProps {
  lay: LayData;
  title: string;
  /** Extent that must be visible. */
  boxes: SupportData[];
  /** Margins beyond the boxes, and below and above the pipe [m]. */
  room: { before: number; after: number; below: number; above: number };
  maxHeight: number;
  legend?: LegendEntry[];
  /** Box for which reactions and separations are written. */
  detail?: SupportData;
}

/** Boxes with the pipe, true to scale. */
export function SideView({ lay, title, boxes, room, maxHeight, legend, detail }: SideViewProps): VNode {
  const { stations } = lay;
  const [first, last] = extent(boxes.flatMap((box) => [box.p[0] - box.length / 2, box.p[0] + box.length / 2]));
  const x = [first - room.before, last + room.after] as const;
  const inside = stationsUpTo(lay, wholeEnd(lay)).filter((i) => stations.x[i]! >= x[0] && stations.x[i]! <= x[1]);
  const [lowest, highest] = extent(inside.map((i) => stations.z[i]!));
  const picture = (frame: Frame): ComponentChildren => (
    <g>
      <Surroundings frame={frame} lay={lay} />
      {structures(lay.supports).map((list) => <Structure frame={frame} boxes={list} />)}
      <Rollers frame={frame} boxes={lay.supports} position="starboard" />
      <Rollers frame={frame} boxes={lay.supports} position="bottom" />
      <TruePipe frame={frame} lay={lay} />
      <Rollers frame={frame} boxes={lay.supports} position="port" />
    </g>
  );
  return (
    <Chart
      title={title}
      equal
      maxHeight={maxHeight}
      x={{ ...elevationAxes.x, range: x }}
      y={{ ...elevationAxes.y, range: [lowest - room.below, highest + room.above] }}
      legend={legend}
      inside={picture}
    >
      {(frame) => (
        <g>
          <BoxNames frame={frame} lay={lay} />
          <WaterName frame={frame} />
          {detail && <Separations frame={frame} box={detail} />}
        </g>
      )}
    </Chart>
  );
}
