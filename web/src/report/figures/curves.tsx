// A chart of a few named curves.
import { Chart } from '../../components/Chart';
import { extent, withRoom } from '../../components/chart/scale';
import type { Curve } from '../../components/chart/types';
import { curveLook } from '../../components/colours';
import { shortened } from '../../components/units';
import type { CurvesData, NamedCurve } from '../data';
import type { DrawFigure } from '../figures';

const looks = {
  line: { width: 2 },
  thin: { width: 1 },
  marks: { width: 0, marks: 3.5, hollow: true },
};
const ground = { colour: '#8c7a5b', width: 1.2, dash: '6 4' };
const water = { colour: '#4f9bd9', width: 1.2, dash: '10 3' };

export const Curves: DrawFigure = ({ data }) => {
  const chart = data as CurvesData;
  const [first, last] = extent(chart.curves.flatMap(({ points }) => points.map(([x]) => x)));
  const x: [number, number] = [first, last > first ? last : first + 1];
  const heights = [...chart.curves, ...chart.ground, ...chart.water].flatMap(({ points }) => points.map(([, y]) => y));
  // Lines of the surroundings may extend far beyond the curves.
  const surrounding = (look: Omit<Curve, 'points'>) => ({ name, points }: NamedCurve): Curve => (
    { ...look, title: name, points: points.map(([across, y]) => [Math.min(Math.max(across, x[0]), x[1]), y]) });
  const curves = chart.curves.map((curve, i) => ({ ...curve, ...looks[curve.look], ...curveLook(curve.colour ?? i), title: curve.name }));
  return (
    <Chart
      height={360}
      x={{ range: x, label: chart.across }}
      y={{ range: withRoom(extent(heights), 0.05), label: chart.up }}
      curves={[...chart.ground.map(surrounding(ground)), ...chart.water.map(surrounding(water)), ...curves]}
      legend={curves.filter((curve) => curve.in_legend).map(({ name, colour, dash }) => ({ text: shortened(name, 60), colour, dash }))}
    />
  );
};
