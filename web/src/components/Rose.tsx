// Values by direction, clockwise from north at the top.
import { ticks } from './chart/scale';
import { fixed } from './units';
import { keyHeight, LineKey } from './LineKey';

export interface RosePoint { degrees: number; value: number; title: string }

export interface RoseLine { name: string; colour: string; dash?: string; points: RosePoint[] }

export interface RoseProps {
  label: string;
  /** Names of the directions and levels. */
  note: string;
  directions: number[];
  largest: number;
  lines: RoseLine[];
}

const kSize = 640, kRadius = 220, kCentre = [kSize / 2, 260] as const, kNote = 530;

function place(degrees: number, distance: number): [number, number] {
  const turn = degrees * Math.PI / 180;
  return [kCentre[0] + distance * Math.sin(turn), kCentre[1] - distance * Math.cos(turn)];
}

/** True if the directions cover the full circle, without a gap of 120 degrees. */
export function isClosed(directions: readonly number[]): boolean {
  const gaps = directions.map((from, i) => (directions[(i + 1) % directions.length]! - from + 360) % 360);
  return directions.length > 2 && Math.max(...gaps) < 120;
}

/** Levels are labelled midway between two neighbouring directions, at the largest distance from their lines. */
function emptiest(directions: readonly number[], levels: readonly number[], lines: readonly RoseLine[]): number {
  const near = (line: RoseLine, degrees: number): number => line.points.find((point) => point.degrees === degrees)?.value ?? 0;
  const places = directions.slice(1).map((to, i) => {
    const crossed = lines.map((line) => 0.5 * (near(line, directions[i]!) + near(line, to)));
    return { degrees: 0.5 * (directions[i]! + to), room: Math.min(...crossed.flatMap((value) => levels.map((level) => Math.abs(level - value)))) };
  });
  return places.reduce((best, place) => (place.room > best.room ? place : best), { degrees: 15, room: -1 }).degrees;
}

function Grid({ directions, levels, radius }: { directions: number[]; levels: number[]; radius: (value: number) => number }) {
  const every = Math.ceil(36 * directions.length / (2 * Math.PI * kRadius));
  return (
    <>
      {levels.map((level) => <circle key={level} cx={kCentre[0]} cy={kCentre[1]} r={radius(level)} fill="none" stroke="#d5dce3" />)}
      {directions.map((degrees, i) => {
        const [[x, y], [tx, ty]] = [place(degrees, kRadius), place(degrees, kRadius + 20)];
        return (
          <g key={degrees}>
            <line x1={kCentre[0]} y1={kCentre[1]} x2={x} y2={y} stroke="#e3e8ed" />
            {i % every ? null : <text class="soft" text-anchor="middle" x={tx} y={ty + 5}>{`${fixed(degrees, 0)}\u00b0`}</text>}
          </g>
        );
      })}
    </>
  );
}

function Curve({ line: { colour, dash, points }, radius }: { line: RoseLine; radius: (value: number) => number }) {
  const order = [...points].sort((a, b) => a.degrees - b.degrees);
  const places = order.map((point) => place(point.degrees, radius(point.value)));
  const path = places.map(([x, y], i) => `${i ? 'L' : 'M'}${x.toFixed(2)},${y.toFixed(2)}`).join('');
  const end = isClosed(order.map((point) => point.degrees)) ? 'Z' : '';
  return (
    <g>
      <path d={path + end} fill="none" stroke={colour} stroke-dasharray={dash} stroke-width="2.2" />
      {order.map((point, i) => (
        <circle key={i} cx={places[i]![0]} cy={places[i]![1]} r="3.4" fill={colour}><title>{point.title}</title></circle>
      ))}
    </g>
  );
}

export function Rose({ label, note, directions, largest, lines }: RoseProps) {
  const radius = (value: number): number => kRadius * value / (largest || 1);
  const levels = ticks(0, largest, 4).filter((level) => level > 0);
  const between = emptiest(directions, levels, lines);
  const room = { entries: lines, left: 70, right: kSize - 16 };
  return (
    <svg
      viewBox={`0 0 ${kSize} ${kNote + 26 + keyHeight(room) - 6}`} class="drawing" role="img" aria-label={label}
      style={{ minWidth: 0, maxWidth: '760px', margin: '0 auto' }}
    >
      <Grid directions={directions} levels={levels} radius={radius} />
      {lines.map((line, k) => <Curve key={k} line={line} radius={radius} />)}
      {levels.map((level) => {
        const [x, y] = place(between, radius(level));
        return <text key={level} class="halo" text-anchor="middle" x={x} y={y + 4} style={{ fontSize: '12px' }}>{level}</text>;
      })}
      <text class="soft" x={room.left} y={kNote}>{note}</text>
      <LineKey {...room} top={kNote + 26} />
    </svg>
  );
}
