// Curves of a lay table over the varied quantity, shaded where every check passes.
import type { LayTableCurves } from '../api/types';
import { Chart } from './Chart';
import type { Range } from './chart/scale';
import { colours } from './colours';
import { roomAround, wholeRange } from './keyAxis';

export interface LayTableLook { curves: string[]; limit: string; passing: string }

const kPaper: LayTableLook = { curves: [colours.pipe, colours.second], limit: colours.accent, passing: '#e6f2ea' };

/** Range in which every check passes, within the chart. */
function passingRange({ least, largest }: LayTableCurves, [low, high]: Range): Range | null {
  if (least === null && largest === null) return null;
  const inside = (value: number): number => Math.min(Math.max(value, low), high);
  return [inside(least ?? low), inside(largest ?? high)];
}

/** Range that includes the curves and the limit. */
export function valueRange({ series, limit }: LayTableCurves['panels'][number]): Range {
  const values = series.flatMap(({ points }) => points.map(([, value]) => value));
  return roomAround(limit === null ? values : [...values, limit], 0.08);
}

export function LayTableCharts({ table, look = kPaper, width }: { table: LayTableCurves; look?: LayTableLook; width?: number }) {
  const x = wholeRange(table.panels.flatMap((panel) => panel.series.flatMap(({ points }) => points.map(([place]) => place))));
  const passing = passingRange(table, x);
  return (
    <>
      {table.panels.map((panel) => (
        <Chart
          small title={panel.title} width={width} height={230} x={{ range: x, label: table.axis }} y={{ range: valueRange(panel) }}
          bands={passing ? [{ x: passing, colour: look.passing }] : []}
          levels={panel.limit === null ? [] : [{ value: panel.limit, colour: look.limit, dash: '6 4', width: 1.4 }]}
          curves={panel.series.map(({ name, points }, k) => ({ points, colour: look.curves[k]!, marks: 2.2, title: name }))}
          legend={panel.series.length > 1 ? panel.series.map(({ name }, k) => ({ text: name, colour: look.curves[k]! })) : []}
        />
      ))}
    </>
  );
}
