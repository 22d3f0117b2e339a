// Parts of the elevation that the report figures do not have: colours along the pipe, lines, axes, names, box handles.
import type { Frame } from '../../../components/chart/types';
import { linePath } from '../../../components/chart/marks';
import { tickTexts, ticks } from '../../../components/chart/scale';
import { valueColour, type ValueScale } from '../../../components/colourScale';
import { polygonIn } from '../../../components/SideView';
import { hullCorner, type LayData, type SupportData } from '../../../components/lay';
import { levelColours, lineLevel } from '../../../logic/moorings';
import type { MooringLine, Vessel } from '../../../api/types';
import type { SideLine } from '../../../logic/elevation';
import { placeNames, type Rect } from '../../../logic/labelPlaces';
import { shownUnit } from '../../../logic/show';
import { textWidth } from '../../../components/chart/text';
import { pressed } from '../pressed';

const shades = 32;

/** Stretches of the pipe of one colour each. */
export function ColouredPipe({ frame, lay, values, scale, grey }: { frame: Frame; lay: LayData; values: ArrayLike<number> | null; scale: ValueScale; grey: boolean }) {
  const { x, z } = lay.stations;
  const step = (scale.high - scale.low) / shades || 1;
  const stationColour = (i: number): string => (grey || !values ? 'var(--soft)' : valueColour(scale, scale.low + step * Math.round(((values[i] ?? 0) - scale.low) / step)));
  const runs: { colour: string; points: [number, number][] }[] = [];
  const [low, high] = frame.x.domain, room = 0.1 * (high - low);
  for (let i = 0; i < x.length; ++i) {
    if (x[i]! < low - room || x[i]! > high + room) continue;
    const colour = stationColour(i), point: [number, number] = [frame.x(x[i]!), frame.y(z[i]!)], last = runs.at(-1);
    last?.points.push(point);
    if (last?.colour !== colour) runs.push({ colour, points: [point] });
  }
  const wide = Math.max(3, 0.5 * lay.pipe_outer_diameter * Math.abs(frame.x(1) - frame.x(0)));
  return <g fill="none" stroke-linecap="round">{runs.map((run, i) => <path key={i} d={linePath(run.points)} stroke={run.colour} stroke-width={wide} />)}</g>;
}

/** Mooring lines, davit cables and other lines that are visible in elevation. */
export function SideLines({ frame, lines, moorings, chosen, choose }: { frame: Frame; lines: readonly SideLine[]; moorings: readonly MooringLine[]; chosen: string | null; choose: (name: string) => void }) {
  return (
    <g fill="none">
      {lines.map((line) => {
        const known = moorings.find((l) => l.name === line.name);
        const colour = line.name === chosen ? '#ff2d7a' : known ? levelColours[lineLevel(known)] : 'var(--pipe)';
        const d = linePath(line.points.map(([x, z]) => [frame.x(x), frame.y(z)] as const));
        return (
          <g key={line.name} class="sideline" onPointerDown={pressed(() => choose(line.name))}>
            <title>{line.name}{line.parted ? ', parted' : ''}</title>
            <path d={d} stroke="transparent" stroke-width="12" />
            <path d={d} stroke={colour} stroke-width={line.moored ? 1.3 : 2.2} stroke-dasharray={line.parted ? '3 5' : undefined} />
          </g>
        );
      })}
    </g>
  );
}

/** Hulls other than the vessel. */
export function OtherHull({ frame, lay, body }: { frame: Frame; lay: LayData; body: Vessel }) {
  const bodyLay = { ...lay, vessel: { ...lay.vessel, length: body.length } };
  const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([along, up]) => hullCorner(bodyLay, along!, 0, up!, -body.draught, body.height - body.draught));
  return <polygon points={polygonIn(frame, corners.map((p) => [p[0], p[2]] as const))} fill="var(--hull)" fill-opacity="0.55" stroke="var(--soft)"><title>{body.name}</title></polygon>;
}

/** Two tracks on the pipe. */
export function Tensioner({ frame, lay }: { frame: Frame; lay: LayData }) {
  const [x, y] = [frame.x(lay.tensioner[0]), frame.y(lay.tensioner[2])], [m, n] = [Math.abs(frame.x(1) - frame.x(0)), Math.abs(frame.y(1) - frame.y(0))];
  const [long, high, off] = [Math.max(14, 4.4 * m), Math.max(4, 0.9 * n), Math.max(4, 0.5 * lay.pipe_outer_diameter * n + 2)];
  return (
    <g fill="#c2452d">
      <rect x={x - long / 2} y={y - off - high} width={long} height={high} rx="2" />
      <rect x={x - long / 2} y={y + off} width={long} height={high} rx="2" />
    </g>
  );
}

/** Numbers at the left and lower edge, in the shown unit. */
export function Axes({ frame }: { frame: Frame }) {
  const { unit, factor } = shownUnit('m');
  const marks = (domain: readonly [number, number], count: number) => {
    const values = ticks(domain[0] * factor, domain[1] * factor, count), texts = tickTexts(values);
    return values.map((value, i) => ({ value: value / factor, text: texts[i]! }));
  };
  const across = marks(frame.x.domain, Math.max(2, (frame.right - frame.left) / 90)), upwards = marks(frame.y.domain, Math.max(2, (frame.bottom - frame.top) / 46));
  return (
    <g class="sideaxes">
      {across.map(({ value, text }) => (
        <g key={`x${text}`}><path d={`M${frame.x(value)} ${frame.bottom}v4`} /><text x={frame.x(value)} y={frame.bottom + 15} text-anchor="middle">{text}</text></g>
      ))}
      {upwards.map(({ value, text }) => (
        <g key={`z${text}`}><path d={`M${frame.left} ${frame.y(value)}h-4`} /><text x={frame.left - 7} y={frame.y(value) + 4} text-anchor="end">{text}</text></g>
      ))}
      <path d={`M${frame.left} ${frame.top}V${frame.bottom}H${frame.right}`} />
      <text x={frame.left + 4} y={frame.top + 10}>{unit}</text>
    </g>
  );
}

export interface SideName { text: string; x: number; z: number; weight: number; chosen?: boolean; act?: () => void }

/** Names with upright leaders; names of lower weight are left out if there is no room. */
export function SideNames({ frame, names, taken }: { frame: Frame; names: readonly SideName[]; taken: readonly Rect[] }) {
  const seen = names.filter((n) => n.x >= frame.x.domain[0] && n.x <= frame.x.domain[1] && n.z >= frame.y.domain[0] && n.z <= frame.y.domain[1]);
  const wanted = seen.map((n) => ({ x: frame.x(n.x), y: frame.y(n.z), width: textWidth(n.text, 12) + 12, weight: n.weight }));
  const room: Rect = { x0: frame.left, y0: frame.top - 8, x1: frame.right, y1: frame.bottom };
  return (
    <g class="sidenames">
      {placeNames(wanted, room, taken).map(({ index, middle, top, leader }) => {
        const { text, chosen, act } = seen[index]!, { x, width } = wanted[index]!;
        return (
          <g key={text} class={`${chosen ? 'chosen' : ''}${act ? ' act' : ''}`} onPointerDown={act && pressed(act)}>
            <path d={`M${x} ${top + 18}v${leader - 2}`} />
            <rect x={middle - width / 2} y={top} width={width} height="18" rx="3" />
            <text x={middle} y={top + 13} text-anchor="middle">{text}</text>
          </g>
        );
      })}
    </g>
  );
}

interface HandleProps { frame: Frame; box: SupportData; chosen: boolean; movable: boolean; begin: (e: PointerEvent) => void; choose: () => void }

/** Handle of a box; outlined if selected. */
export function BoxHandle({ frame, box, chosen, movable, begin, choose }: HandleProps) {
  const [m, n] = [Math.abs(frame.x(1) - frame.x(0)), Math.abs(frame.y(1) - frame.y(0))];
  const half = Math.max(7, 0.5 * box.length * m), high = Math.max(9, 0.9 * n);
  const slope = (Math.atan2(n * Math.sin(box.inclination), m * Math.cos(box.inclination)) * 180) / Math.PI;
  return (
    <rect
      class={`boxhandle${chosen ? ' chosen' : ''}${movable ? ' movable' : ''}`}
      data-box={box.name}
      role="button"
      tabIndex={0}
      aria-label={box.name}
      aria-pressed={chosen}
      x={frame.x(box.p[0]) - half}
      y={frame.y(box.p[2]) - high}
      width={2 * half}
      height={2 * high}
      rx="3"
      transform={`rotate(${-slope} ${frame.x(box.p[0])} ${frame.y(box.p[2])})`}
      onPointerDown={begin}
      onKeyDown={(e) => { if (e.key === 'Enter' || e.key === ' ') { e.preventDefault(); choose(); } }}
    >
      <title>{box.name}{movable ? ': drag to move, Esc cancels' : ''}</title>
    </rect>
  );
}
