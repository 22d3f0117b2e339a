// Lines other than moorings: shape and tension along each.
import type { VNode } from 'preact';
import { Chart } from '../../components/Chart';
import { extent, withRoom } from '../../components/chart/scale';
import type { Band, LegendEntry } from '../../components/chart/types';
import { colours } from '../../components/colours';
import { useUnits } from '../../components/units';
import type { LineData, LinesReport } from '../data';
import type { FigureProps } from '../figures';

/** Horizontal distance in the vertical plane through both ends, and height; lines with vertically aligned ends are viewed from the south. */
function pointsInPlane({ places }: LineData): [number, number][] {
  const [a, b] = [places[0]!, places.at(-1)!];
  const far = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const [east, north] = far > 1e-6 ? [(b[0] - a[0]) / far, (b[1] - a[1]) / far] : [1, 0];
  return places.map((p) => [(p[0] - a[0]) * east + (p[1] - a[1]) * north, p[2]]);
}

export function LineShape({ part, data }: FigureProps): VNode {
  const { lines, water_depth: depth } = data as LinesReport;
  const line = lines[Number(part)]!;
  const points = pointsInPlane(line);
  const [x, z] = [extent(points.map((p) => p[0])), extent(points.map((p) => p[1]))];
  const bed = depth > 0 && z[0] < -0.6 * depth ? -depth : null; // shown if the line comes near
  const low = Math.min(z[0], bed ?? z[0]);
  const high = z[1] > -0.4 * (z[1] - low) ? Math.max(z[1], 0) : z[1];
  const room = 0.08 * Math.max(x[1] - x[0], high - low, 1);
  const range = [low - room, high + room] as const;
  const bands: Band[] = [{ y: [range[0], 0], colour: '#f1f7fb' }];
  if (bed !== null) bands.push({ y: [range[0], bed], colour: '#e4dac6' });
  const [first, last] = [points[0]!, points.at(-1)!];
  return (
    <Chart
      title={`${line.name}, true to scale`}
      equal
      maxHeight={400}
      x={{ label: 'Horizontal distance from the first end', si: 'm', range: [x[0] - room, x[1] + room] }}
      y={{ label: 'Z, above the water', si: 'm', range }}
      bands={bands}
      levels={high >= 0 ? [{ value: 0, colour: '#6fa8cc', width: 1 }] : []}
      curves={[{ points, colour: colours.pipe, width: 2.4 }]}
      points={[
        { x: first[0], y: first[1], label: 'first end', colour: colours.pipe },
        { x: last[0], y: last[1], label: 'second end', colour: colours.pipe },
      ]}
    />
  );
}

const rangeLegend: LegendEntry[] = [
  { text: 'range over time', colour: colours.band, edge: colours.history, look: 'block' },
  { text: 'at rest', colour: colours.accent, dash: '7 4' },
];

export function LineTension({ part, data }: FigureProps): VNode {
  const units = useUnits();
  const { lines, moved } = data as LinesReport;
  const { name, s, tension, least, largest } = lines[Number(part)]!;
  const [lo, hi] = extent(moved ? [...tension, ...least, ...largest] : tension);
  const greatest = tension.indexOf(Math.max(...tension));
  return (
    <Chart
      title={`${name}, effective tension`}
      height={280}
      x={{ label: 'Unstressed length from the first end', si: 'm', range: [0, s.at(-1)!] }}
      y={{ label: 'Effective tension', si: 'N', digits: 2, range: hi > lo ? withRoom([lo, hi], 0.12) : [lo - 120, hi + 120] }}
      legend={moved ? rangeLegend : undefined}
      areas={moved ? [{ points: s.map((place, i) => [place, least[i]!, largest[i]!] as const), colour: colours.band, edge: colours.history }] : []}
      curves={[{
        points: s.map((place, i) => [place, tension[i]!] as const),
        colour: moved ? colours.accent : colours.pipe,
        dash: moved ? '7 4' : undefined,
      }]}
      points={[{ x: s[greatest]!, y: tension[greatest]!, label: units.shown(tension[greatest]!, 'N', 2), colour: colours.pipe }]}
    />
  );
}
