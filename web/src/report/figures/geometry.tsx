// Elevations and plan of the line.
import type { VNode } from 'preact';
import { Chart } from '../../components/Chart';
import { extent } from '../../components/chart/scale';
import type { Frame } from '../../components/chart/types';
import { colours } from '../../components/colours';
import { hullCorner, hullHeights, overbendEnd, seabedHeight, seabedPlaces, stationsUpTo, wholeEnd, type LayData } from '../../components/lay';
import { NamesAt, Surroundings, elevationAxes, pipeElevation, polygonIn, rollerLooks } from '../../components/SideView';
import { useUnits } from '../../components/units';
import type { FigureProps } from '../figures';

function Rows({ frame, lay }: { frame: Frame; lay: LayData }): VNode {
  return (
    <g stroke="#3d4a56">
      {lay.supports.flatMap((box) => box.rows).map((row) => (
        <circle cx={frame.x(row.p[0])} cy={frame.y(row.p[2])} r="3" fill={row.reaction > 0 ? rollerLooks.contact : '#fff'} />
      ))}
    </g>
  );
}

function OverbendElevation({ lay }: { lay: LayData }): VNode {
  const points = pipeElevation(lay, stationsUpTo(lay, overbendEnd(lay)));
  const [lowest, highest] = extent(points.map((p) => p[1]));
  const [bow, last] = [points[0]![0] - 4, points.at(-1)![0]];
  const room = 0.07 * (highest - lowest);
  const [x, , z] = lay.tensioner;
  return (
    <Chart
      title="Elevation, overbend (heights enlarged)"
      height={330}
      x={{ ...elevationAxes.x, range: [bow, last + 0.02 * (last - bow)] }}
      y={{ ...elevationAxes.y, range: [lowest - room, highest + 1.6 * room] }}
      legend={[{ text: 'pipe axis', colour: colours.pipe }, { text: 'row in contact', colour: rollerLooks.contact, look: 'block' }]}
      curves={[{ points, colour: colours.pipe, width: 2.2 }]}
      points={[{ x, y: z, label: 'tensioner', colour: colours.pipe }]}
      inside={(frame) => <g><Surroundings frame={frame} lay={lay} /><Rows frame={frame} lay={lay} /></g>}
    >
      {(frame) => {
        const names = lay.supports.map((box) => ({ x: frame.x(box.p[0]) - 2, y: frame.y(box.p[2]) + 16, text: box.name }));
        return <NamesAt names={names} angle={-40} anchor="end" css="soft halo" size={12} />;
      }}
    </Chart>
  );
}

function WaterName({ frame, x }: { frame: Frame; x: number }): VNode {
  const text = 'mean water level';
  const [left, base] = frame.room.place([frame.x(x), frame.y(0)], frame.textWidth(text), true);
  return <text class="soft halo" x={left} y={base}>{text}</text>;
}

function WholeElevation({ lay }: { lay: LayData }): VNode {
  const units = useUnits();
  const points = pipeElevation(lay, stationsUpTo(lay, wholeEnd(lay)));
  const [first, last] = [points[0]![0], points.at(-1)![0]];
  const bow = Math.min(first, hullCorner(lay, 1, 0, 1, 0, 0)[0]) - 5;
  const bed = seabedPlaces(lay, bow, last).map((x) => seabedHeight(lay, x));
  const [lowest] = extent(points.map((p) => p[1]));
  const highest = Math.max(...points.map((p) => p[1]), hullHeights(lay)[1]);
  const room = 0.07 * (highest - lowest);
  const above = Math.max(1.6 * room, 0.036 * (last - bow)); // room for the name at the tensioner
  const touch = lay.touchdown.p;
  return (
    <Chart
      title="Elevation, whole line (true to scale)"
      equal
      x={{ ...elevationAxes.x, range: [bow, last + 0.02 * (last - bow)] }}
      y={{ ...elevationAxes.y, range: [Math.min(lowest, ...bed) - room, highest + above] }}
      curves={[{ points, colour: colours.pipe, width: 2.2 }]}
      points={[
        { x: lay.tensioner[0], y: lay.tensioner[2], label: 'tensioner', colour: colours.pipe },
        { x: touch[0], y: touch[2], label: `touchdown, X = ${units.shown(touch[0], 'm', 1)}`, colour: colours.accent },
      ]}
      inside={(frame) => (
        <g>
          <Surroundings frame={frame} lay={lay} />
          <polyline points={polygonIn(frame, lay.supports.map((box) => [box.p[0], box.p[2]] as const))} fill="none" stroke={colours.steel} stroke-width="3" />
        </g>
      )}
    >
      {(frame) => <WaterName frame={frame} x={0.6 * last} />}
    </Chart>
  );
}

function Plan({ lay }: { lay: LayData }): VNode {
  const units = useUnits();
  const { x, y } = lay.stations;
  const indices = stationsUpTo(lay, wholeEnd(lay));
  const [lowest, highest] = extent(indices.map((i) => y[i]!));
  const room = 0.12 * (highest - lowest);
  const farthest = indices.reduce((best, i) => (Math.abs(y[i]!) > Math.abs(y[best]!) ? i : best));
  const touch = lay.touchdown.p;
  return (
    <Chart
      title="Plan, whole line (drift enlarged)"
      height={280}
      x={{ ...elevationAxes.x, range: [x[0]! - 4, x[indices.at(-1)!]!] }}
      y={{ label: 'Y, to port', si: 'm', digits: 2, range: [lowest - room, highest + 1.5 * room] }}
      bands={lay.supports.map((box) => ({ x: [box.p[0] - box.length / 2, box.p[0] + box.length / 2] as const }))}
      levels={[{ value: 0, colour: colours.zero, dash: '10 4 2 4', width: 1 }]}
      curves={[{ points: indices.map((i) => [x[i]!, y[i]!] as const), colour: colours.pipe, width: 2.2 }]}
      points={[
        { x: x[farthest]!, y: y[farthest]!, label: `${units.shown(y[farthest]!, 'm', 2)} at X = ${units.shown(x[farthest]!, 'm', 1)}`, colour: colours.pipe },
        { x: touch[0], y: touch[1], label: `touchdown ${units.shown(touch[1], 'm', 2)}`, colour: colours.accent },
      ]}
    />
  );
}

export function Geometry({ part, data }: FigureProps): VNode {
  const lay = data as LayData;
  if (part === 'plan') return <Plan lay={lay} />;
  return part === 'overbend' ? <OverbendElevation lay={lay} /> : <WholeElevation lay={lay} />;
}
