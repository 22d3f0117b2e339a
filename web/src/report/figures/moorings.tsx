// Moorings: plan, profiles, offsets of the vessel.
import type { VNode } from 'preact';
import { Chart } from '../../components/Chart';
import { polygonPoints } from '../../components/chart/marks';
import { extent } from '../../components/chart/scale';
import type { Frame, Point } from '../../components/chart/types';
import { colours } from '../../components/colours';
import {
  distance, groupAlike, suspendedAndLaid, lineColours, offsetInWorld, type MooringLineData, type MooringSpread, type Place,
} from '../../components/mooringSpread';
import { Arrow, Name, PlanView } from '../../components/PlanView';
import type { MooringsReport, OffsetRange, VesselInTime } from '../data';
import type { FigureProps } from '../figures';

export const readSpread = (data: unknown): MooringSpread => (data as MooringsReport).moorings;

export function MooringPlan({ data }: FigureProps): VNode {
  const spread = readSpread(data);
  return <PlanView spread={spread} state={spread.states[0]!} />;
}

/** A list at the upper right, clear of the lines, with leaders to the touchdown points: the nearest on top, so that none cross. */
function TouchdownNames({ frame, lines }: { frame: Frame; lines: MooringLineData[] }): VNode {
  const groups = groupAlike(lines).sort(([a], [b]) => a!.touchdown - b!.touchdown);
  const rows = groups.filter((_, k) => frame.top + 26 + 19 * k < frame.bottom - 40);
  const texts = rows.map((group) => group.map((line) => line.name).join(', '));
  const left = frame.right - 14 - Math.max(...texts.map((text) => frame.textWidth(text)));
  const first = Math.max(frame.top, frame.y(0)) + 16;
  return (
    <g>
      {rows.map(([line], k) => {
        const [suspended, laid] = suspendedAndLaid(line!);
        const touch = laid[0] ?? suspended.at(-1)!;
        const [x, y] = [frame.x(distance(touch, line!.fairlead)), frame.y(touch[2])];
        const row = first + 19 * k;
        return (
          <g>
            <text class="soft halo" x={left + 6} y={row + 5}>{texts[k]}</text>
            <path d={`M${left} ${row}L${Math.min(left - 14, x + 60)} ${row}L${x} ${y - 4}`} fill="none" stroke="#9aa6b1" stroke-width="0.9" />
            <circle cx={x} cy={y} r="3.2" fill="#fff" stroke={lineColours.suspended} stroke-width="1.5" />
          </g>
        );
      })}
    </g>
  );
}

export function MooringProfile({ data }: FigureProps): VNode {
  const lines = readSpread(data).states[0]!.lines.filter((line) => !line.parted && line.shape.length > 1);
  const low = Math.min(...lines.flatMap((line) => line.shape.map((p) => p[2])));
  const high = Math.max(0, ...lines.map((line) => line.fairlead[2]));
  const far = Math.max(...lines.map((line) => distance(line.anchor, line.fairlead)));
  const bottom = low - 0.1 * (high - low);
  return (
    <Chart
      title="Lines in profile; open circle: touchdown"
      x={{ label: 'Horizontal distance from the fairlead', si: 'm', range: [0, 1.03 * far] }}
      y={{ label: 'Z, above the water', si: 'm', range: [bottom, high + 0.08 * (high - low)] }}
      bands={[{ y: [bottom, 0], colour: '#f1f7fb' }]}
      levels={[{ value: 0, colour: '#6fa8cc', width: 1 }]}
      curves={lines.map((line) => ({
        points: line.shape.map((p) => [distance(p, line.fairlead), p[2]] as const),
        colour: line.slack ? lineColours.slack : lineColours.suspended,
        width: 1.5,
      }))}
    >
      {(frame) => <TouchdownNames frame={frame} lines={lines} />}
    </Chart>
  );
}

/** Offset during a run, in hull axes from the initial position of midship, which is given in world axes. */
function makeOffset(spread: MooringSpread, run: VesselInTime): (along: number, port: number) => Place {
  return (along, port) => offsetInWorld(spread, run.start_surge + along, run.start_sway + port);
}

/** Semi-axes and angle of one standard deviation. */
function standardEllipse({ along, across, covariance }: VesselInTime) {
  const [a, c] = [along.std ** 2, across.std ** 2];
  const root = Math.hypot((a - c) / 2, covariance);
  const radii = [Math.sqrt((a + c) / 2 + root), Math.sqrt(Math.max((a + c) / 2 - root, 0))] as const;
  return { angle: 0.5 * Math.atan2(2 * covariance, a - c), radii };
}

function ellipsePoints(spread: MooringSpread, run: VesselInTime, deviations: number): Place[] {
  const { angle, radii } = standardEllipse(run);
  const toWorld = makeOffset(spread, run);
  return Array.from({ length: 120 }, (_, i) => {
    const turn = i * Math.PI / 60;
    const [u, v] = [deviations * radii[0] * Math.cos(turn), deviations * radii[1] * Math.sin(turn)];
    return toWorld(run.along.mean + u * Math.cos(angle) - v * Math.sin(angle), run.across.mean + u * Math.sin(angle) + v * Math.cos(angle));
  });
}

function rangeCorners(spread: MooringSpread, run: VesselInTime): Place[] {
  const pairs: [keyof OffsetRange, keyof OffsetRange][] = [['min', 'min'], ['max', 'min'], ['max', 'max'], ['min', 'max']];
  return pairs.map(([along, port]) => makeOffset(spread, run)(run.along[along], run.across[port]));
}

function ScatterOfRun({ frame, spread, run }: { frame: Frame; spread: MooringSpread; run: VesselInTime }): VNode {
  const polygon = (points: Place[]): string => polygonPoints(points.map(([x, y]) => [frame.x(x), frame.y(y)] as const));
  return (
    <g stroke={colours.dynamic}>
      {[3, 2, 1].map((deviations) => {
        const points = ellipsePoints(spread, run, deviations);
        frame.room.takeCurve(points.map(([x, y]) => [frame.x(x), frame.y(y)] as const));
        return <polygon points={polygon(points)} fill={colours.band} fill-opacity="0.3" />;
      })}
      <polygon points={polygon(rangeCorners(spread, run))} fill="none" stroke-dasharray="6 4" />
    </g>
  );
}

/** A cross at the nominal midship, and the direction of the bow. */
function NominalPose({ frame, spread }: { frame: Frame; spread: MooringSpread }): VNode {
  const [x, y] = [frame.x(0), frame.y(0)];
  const [bowX, bowY] = [frame.right - 76, frame.top + 28];
  frame.room.takePoint([x, y], 8);
  if (spread.length > 0) frame.room.take({ x0: bowX - 22, x1: bowX + 74, y0: bowY - 22, y1: bowY + 22 });
  return (
    <g>
      {spread.length > 0 && <Arrow x={bowX} y={bowY} azimuth={spread.heading} colour="#5d6a76" text="bow" />}
      <path d={`M${x - 7} ${y}H${x + 7}M${x} ${y - 7}V${y + 7}`} stroke={colours.ink} stroke-width="1.6" />
      <Name frame={frame} position={[0, 0]} text="nominal" css="soft" />
    </g>
  );
}

function offsetPoints(spread: MooringSpread, run: VesselInTime | null): Point[] {
  const states = run ? spread.states.slice(0, 1) : spread.states;
  const points: Point[] = states.map((state, i) => {
    const [x, y] = offsetInWorld(spread, state.surge, state.sway);
    const label = i > 0 ? state.name : run ? 'start of the run' : 'at rest';
    return { x, y, label, colour: i === 0 ? colours.pipe : colours.second };
  });
  if (!run) return points;
  const [x, y] = makeOffset(spread, run)(run.along.mean, run.across.mean);
  return [...points, { x, y, label: 'mean', colour: colours.dynamic }];
}

/** Offsets of midship: a point per state, and for a run its ellipses and its range. */
export function MooringOffsets({ part, data }: FigureProps): VNode {
  const spread = readSpread(data);
  const run = part === 'dynamic' ? (data as MooringsReport).dynamic!.vessel : null;
  const points = offsetPoints(spread, run);
  const seen: Place[] = [[0, 0], ...points.map((p): Place => [p.x, p.y])];
  if (run) seen.push(...rangeCorners(spread, run), ...ellipsePoints(spread, run, 3));
  const [x, y] = [extent(seen.map((p) => p[0])), extent(seen.map((p) => p[1]))];
  const size = Math.max(x[1] - x[0], y[1] - y[0], 1e-3);
  const room = 0.14 * size;
  const half = Math.max(y[1] - y[0], 0.4 * size) / 2 + room;
  const middle = (y[0] + y[1]) / 2;
  return (
    <Chart
      title={run ? 'Offset of midship: ellipses of 1, 2 and 3 standard deviations, dashed: range of the run' : 'Offset of midship'}
      equal
      maxHeight={420}
      x={{ label: 'East of nominal midship', si: 'm', range: [x[0] - room, x[1] + room] }}
      y={{ label: 'North', si: 'm', range: [middle - half, middle + half] }}
      points={points}
      inside={(frame) => run && <ScatterOfRun frame={frame} spread={spread} run={run} />}
    >
      {(frame) => <NominalPose frame={frame} spread={spread} />}
    </Chart>
  );
}
