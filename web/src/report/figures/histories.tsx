// Time histories and their spectra.
import type { VNode } from 'preact';
import { Chart } from '../../components/Chart';
import { textWidth } from '../../components/chart/text';
import type { Frame, LegendEntry, Level } from '../../components/chart/types';
import { colours } from '../../components/colours';
import { fixed } from '../../components/units';
import type { HistoryData, PipeData, SpectrumData } from '../data';
import type { DrawFigure } from '../figures';
import { buildUpMarks, looksLikeLine, rangeBand, timeLabel, timeScale, traceArea, traceRange, type TimeScale } from './inTime';

const kSmallTitle = 410;  // pixels

const bracketed = (unit: string) => (unit ? `[${unit}]` : '');

/** With as many of the statistics as fit. */
function title(history: HistoryData, small: boolean): string {
  const text = (value: number) => fixed(value, history.digits);
  const { min, max, mean, std } = history.over_time;
  const all = `${text(min)} to ${text(max)}, mean ${text(mean)}, std ${text(std)}`;
  if (!small) return `${history.title}: ${all} ${history.unit}`.trimEnd();
  const head = `${history.title} ${bracketed(history.unit)}`.trimEnd();
  const texts = [`${head}: ${all}`, `${head}: ${text(min)} to ${text(max)}, std ${text(std)}`, `${head}: ${text(min)} to ${text(max)}`];
  return texts.find((text) => textWidth(text, 13, true) < kSmallTitle) ?? head;
}

function valueRange(history: HistoryData): [number, number] {
  const values = [...traceRange(history), ...(history.shade ?? []), ...(history.static === null ? [] : [history.static])];
  const [lo, hi] = [Math.min(...values), Math.max(...values)];
  const room = 0.08 * (hi - lo);
  return [lo - room, hi + room];
}

function HistoryChart({ history, small, scale }: { history: HistoryData; small: boolean; scale: TimeScale }): VNode {
  const range = valueRange(history);
  const { bands, verticals } = buildUpMarks(scale);
  const levels: Level[] = [];
  const onBand = !looksLikeLine(history);
  if (range[0] < 0 && range[1] > 0) levels.push({ value: 0, colour: colours.zero, width: 1 });
  if (history.static !== null) {
    if (onBand) levels.push({ value: history.static, colour: '#fff', width: 3.5 });
    levels.push({ value: history.static, colour: colours.accent, dash: '7 4', width: 1.5 });
  }
  const areas = [traceArea(history, scale, { line: colours.dynamic, area: colours.history })];
  if (history.slow) areas.push(traceArea(history.slow, scale, { line: colours.second, area: colours.second }));
  const legend: LegendEntry[] = [];
  if (!small && history.slow) legend.push({ text: 'low-frequency part', colour: colours.second });
  if (!small && history.static !== null) legend.push({ text: `static ${fixed(history.static, history.digits)}`, colour: colours.accent, dash: '7 4' });
  return (
    <Chart
      title={title(history, small)}
      small={small}
      height={small ? 190 : 250}
      left={small ? 62 : 78}
      x={{ range: scale.range, label: timeLabel(scale) }}
      y={{ range, digits: history.digits, label: small ? '' : bracketed(history.unit) }}
      bands={history.shade ? [...bands, rangeBand(history.shade)] : bands}
      verticals={verticals}
      areas={areas}
      levels={levels}
      legend={legend}
    />
  );
}

export const History: DrawFigure = ({ part, data, small }) => {
  const { histories, build_up: buildUp, duration } = (data as PipeData).dynamic!;
  const scale = timeScale(buildUp, duration);
  return <>{histories.filter(({ group }) => group === part).map((history) => <HistoryChart history={history} small={small} scale={scale} />)}</>;
};

const kPeriods = [2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 30, 60, 120];  // [s]

/** Periods above a frequency axis, as many as fit. */
function PeriodAxis({ frame }: { frame: Frame }): VNode {
  const shown: { period: number; x: number }[] = [];
  for (const period of kPeriods) {
    const x = frame.x(1 / period);
    if (x > frame.right || x - frame.left < 12 || (shown.length > 0 && shown.at(-1)!.x - x < 26)) continue;
    shown.push({ period, x });
  }
  return (
    <g>
      {shown.map(({ period, x }) => (
        <g>
          <line x1={x} x2={x} y1={frame.top - 4} y2={frame.top} stroke={colours.zero} />
          <text class="soft" x={x} y={frame.top - 7} text-anchor="middle">{period}</text>
        </g>
      ))}
      <text class="soft" x={frame.left - 8} y={frame.top - 7} text-anchor="end">T [s]</text>
    </g>
  );
}

function SpectrumChart({ spectrum, end }: { spectrum: SpectrumData; end: number }): VNode {
  const { frequency, density, unit } = spectrum;
  const max = Math.max(...density);
  const peak = frequency[density.indexOf(max)]!;
  const title = `${spectrum.title} [${unit ? `${unit}\u00b2` : '1'}/Hz]${peak > 0 ? `, peak at ${fixed(1 / peak, 1)} s` : ''}`;
  return (
    <Chart
      small
      title={title}
      height={210}
      left={68}
      headRoom={16}
      x={{ range: [0, end], label: 'Frequency [Hz]' }}
      y={{ range: [0, 1.12 * max] }}
      areas={[{ points: frequency.map((f, i) => [f, 0, density[i]!]), colour: colours.band }]}
      curves={[{ points: frequency.map((f, i) => [f, density[i]!]), colour: colours.dynamic, width: 1.4 }]}
    >
      {(frame) => <PeriodAxis frame={frame} />}
    </Chart>
  );
}

/** On a common frequency scale, for comparison. */
export const Spectra: DrawFigure = ({ data }) => {
  const { spectra } = (data as PipeData).dynamic!;
  const end = Math.max(...spectra.map(({ frequency }) => frequency.at(-1)!));
  return <>{spectra.map((spectrum) => <SpectrumChart spectrum={spectrum} end={end} />)}</>;
};
