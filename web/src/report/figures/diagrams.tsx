// Diagrams along the pipe: tension, moment, stress, strain, and their envelopes over time.
import { interpolate } from '../../components/chart/scale';
import type { Point } from '../../components/chart/types';
import { colours } from '../../components/colours';
import { stationValue } from '../../components/lay';
import { fixed, useUnits } from '../../components/units';
import type { DynamicData, PipeData } from '../data';
import type { DrawFigure } from '../figures';
import { AlongChart, largest, partEnd, shownValue, upTo, type AlongKind } from './along';

interface Further { key: string; name: string; colour: string; dash: string; mark?: string }

interface Kind extends Omit<AlongKind, 'unit'> { key: string; legend?: string; more?: Further[] }

const kinds: Record<string, Kind> = {
  tension: {
    key: 'effective_tension', name: 'Effective tension', axis: 'Tension', legend: 'effective tension',
    more: [{ key: 'wall_tension', name: 'wall tension', colour: colours.second, dash: '6 4' }],
  },
  moment: {
    key: 'bending_moment', name: 'Bending moment', zero: true, legend: 'magnitude',
    more: [
      { key: 'vertical_moment', name: 'vertical part, sagging +', colour: colours.third, dash: '9 3' },
      { key: 'lateral_moment', name: 'lateral part, to port +', colour: colours.second, dash: '5 3', mark: 'lateral' },
    ],
  },
  bending: { key: 'bending_stress', name: 'Bending stress', zero: true, yield: true },
  mises: { key: 'von_mises', name: 'von Mises stress', zero: true, yield: true },
  strain: { key: 'strain', name: 'Strain', zero: true },
};

const regions = ['overbend', 'tower', 'sagbend'] as const;

/** Values times `factor` over distances along the pipe. */
const columnPoints = (s: readonly number[], column: readonly number[], indices: readonly number[], factor: number) =>
  indices.map((i) => [s[i]!, column[i]! * factor] as const);

function useExtremes(pipe: PipeData, kind: Kind, look: AlongKind): Point[] {
  const units = useUnits();
  const tension = kind.key === 'effective_tension';
  const points: Point[] = [];
  const add = (s: number, value: number, label: string) => points.push({ x: s, y: value * look.factor!, colour: colours.pipe, label });
  if (tension) {
    const value = stationValue(pipe, kind.key, pipe.touchdown.s);
    add(pipe.touchdown.s, value, `${units.shown(value, 'N', 1)} at touchdown`);
  }
  // The tension of the sagbend is largest at its upper end, which is trivial.
  for (const region of tension && pipe.overbend ? regions.slice(0, 1) : regions) {
    const extreme = pipe[region]?.[kind.key];
    if (extreme) add(extreme.s, extreme.value, `${shownValue(extreme.value * look.factor!, look)} at ${units.shown(extreme.s, 'm', 1)} (${extreme.place})`);
  }
  return points;
}

/** The maximum of further marked curves, if it is more than a tenth of the first. */
function useFurtherExtremes({ stations }: PipeData, kind: Kind, look: AlongKind, indices: readonly number[]): Point[] {
  const units = useUnits();
  return (kind.more ?? []).filter((curve) => curve.mark).flatMap((curve) => {
    const column = stations[curve.key]!;
    const i = largest(indices, (k) => Math.abs(column[k]!));
    if (Math.abs(column[i]!) < 0.1 * Math.max(...indices.map((k) => stations[kind.key]![k]!))) return [];
    const value = column[i]! * look.factor!;
    const label = `${curve.mark} ${shownValue(value, look)} at ${units.shown(stations.s[i]!, 'm', 1)}`;
    return [{ x: stations.s[i]!, y: value, colour: curve.colour, label }];
  });
}

export const Diagram: DrawFigure = ({ id, part, data }) => {
  const pipe = data as PipeData;
  const kind = kinds[id]!;
  const look = { ...kind, ...pipe.shown[kind.key]! };
  const { stations } = pipe;
  const indices = upTo(stations.s, partEnd(pipe, part));
  const more = kind.more ?? [];
  const values = [kind, ...more].flatMap(({ key }) => indices.map((i) => stations[key]![i]! * look.factor));
  const points = (key: string) => columnPoints(stations.s, stations[key]!, indices, look.factor);
  const extremes = useExtremes(pipe, kind, look);
  const further = useFurtherExtremes(pipe, kind, look, indices);
  return (
    <AlongChart
      pipe={pipe}
      kind={look}
      part={part}
      range={[Math.min(...values), Math.max(...values)]}
      curves={[
        ...more.map(({ key, colour, dash }) => ({ points: points(key), colour, dash, width: 1.6 })),
        { points: points(kind.key), colour: colours.pipe, width: 2.2 },
      ]}
      points={[...extremes, ...further]}
      legend={kind.legend ? [{ text: kind.legend, colour: colours.pipe }, ...more.map(({ name, colour, dash }) => ({ text: name, colour, dash }))] : undefined}
      hover={(s) => shownValue(stationValue(pipe, kind.key, s) * look.factor, look)}
    />
  );
};

function useDynamicExtremes(dynamic: DynamicData, kind: Kind, look: AlongKind, indices: readonly number[]): Point[] {
  const units = useUnits();
  const { s } = dynamic.envelopes;
  const point = (place: number, value: number, more: string): Point => ({
    x: place, y: value * look.factor!, colour: colours.dynamic, label: `${shownValue(value * look.factor!, look)} at ${units.shown(place, 'm', 1)}${more}`,
  });
  const points = regions.flatMap((region) => {
    const extreme = dynamic[region]?.[kind.key];
    return extreme && extreme.value > 0 ? [point(extreme.s, extreme.value, ` (${extreme.place}), t = ${fixed(extreme.time, 1)} s`)] : [];
  });
  if (kind.key !== 'effective_tension') return points;
  const { max } = dynamic.envelopes[kind.key]!;
  const i = largest(indices, (k) => max[k]!);
  return [...points, point(s[i]!, max[i]!, '')];
}

/** Minimum, maximum and mean of a dynamic run, and the static value. */
export const Envelope: DrawFigure = ({ id, part, data }) => {
  const pipe = data as PipeData;
  const dynamic = pipe.dynamic!;
  const kind = kinds[id.replace('envelope_', '')]!;
  const look = { ...kind, ...pipe.shown[kind.key]! };
  const { s } = dynamic.envelopes;
  const envelope = dynamic.envelopes[kind.key]!;
  const indices = upTo(s, partEnd(pipe, part));
  const { factor } = look;
  const values = indices.flatMap((i) => [envelope.min[i]!, envelope.max[i]!, envelope.static[i]!]).map((value) => value * factor);
  const curve = (column: number[], colour: string, width: number, dash?: string) => (
    { points: columnPoints(s, column, indices, factor), colour, width, dash });
  const text = (column: number[], place: number) => fixed(interpolate(s, column, place) * factor, look.digits);
  const points = useDynamicExtremes(dynamic, kind, look, indices);
  return (
    <AlongChart
      pipe={pipe}
      kind={look}
      part={part}
      range={[Math.min(...values), Math.max(...values)]}
      aboveYield={2.2}
      areas={[{ points: indices.map((i) => [s[i]!, envelope.min[i]! * factor, envelope.max[i]! * factor]), colour: colours.band }]}
      curves={[
        curve(envelope.min, colours.dynamic, 0.9),
        curve(envelope.max, colours.dynamic, 1.4),
        curve(envelope.mean, colours.second, 1.5, '6 3'),
        curve(envelope.static, colours.pipe, 1.8),
      ]}
      points={points}
      legend={[
        { text: 'dynamic, min to max', colour: colours.band, look: 'block', edge: colours.dynamic },
        { text: 'mean', colour: colours.second, dash: '6 3' },
        { text: 'static', colour: colours.pipe },
      ]}
      hover={(place) => `${text(envelope.min, place)} to ${text(envelope.max, place)} ${look.unit}, static ${text(envelope.static, place)}`}
    />
  );
};
