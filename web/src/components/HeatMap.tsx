// Values over two keys as coloured cells, with the status of the code checks.
import { useId } from 'preact/hooks';
import { ticks, tickTexts } from './chart/scale';
import { textWidth } from './chart/text';
import { gradientStops, markColour, valueColour, type ValueScale } from './colourScale';
import { passEdges } from './passEdges';
import { shortened } from './units';

export type CellState = 'passed' | 'reserved' | 'exceeded' | 'not judged' | 'failed' | 'open';

export interface HeatCell { value: number | null; state: CellState; title: string; chosen?: boolean }

export interface HeatAxis { name: string; labels: string[] }

export interface HeatMapProps {
  label: string;
  title?: string;
  /** Values of the keys that are constant in this map. */
  note?: string;
  x: HeatAxis;
  y: HeatAxis;
  /** Rows along y, from below. */
  cells: (HeatCell | null)[][];
  scale: ValueScale;
  width?: number;
  /** Maximum row height, in the units of the width. */
  row?: number;
  choose?: (i: number, j: number) => void;
}

/** Label interval of an axis at which no label overlaps the next. */
export function wordStep(labels: readonly string[], each: number, letter: number): number {
  const widths = labels.map((word) => textWidth(word, letter));
  const fits = (step: number): boolean => widths.every((width, i) => i % step > 0 || i + step >= widths.length
    || (width + widths[i + step]!) / 2 + 0.9 * letter <= step * each);
  return labels.map((_, i) => i + 1).find(fits) ?? 1;
}

const kStateLabels: [CellState, string][] = [
  ['exceeded', 'struck through: a check is exceeded'], ['reserved', 'ringed: passes with reservations'],
  ['not judged', 'dotted: not judged'], ['failed', 'hatched: no result'], ['open', 'empty: not computed yet']];

/** Explains the marks of the states that occur. */
export function stateLabels(states: readonly CellState[]): string {
  const judged = states.some((state) => state === 'passed' || state === 'exceeded');
  return kStateLabels.filter(([state]) => states.includes(state) && (judged || state !== 'not judged')).map(([, label]) => label).join('; ');
}

interface Layout {
  width: number;
  height: number;
  /** Extent of the cells. */
  left: number;
  top: number;
  wide: number;
  tall: number;
  letter: number;
  /** Position next to the scale. */
  numbers: { value: number; text: string }[];
  x: (i: number) => number;
  y: (j: number) => number;
}

function layOut({ title, note, x, y, scale, width = 480, row = 26 }: HeatMapProps): Layout {
  const letter = 13;  // letter size of small drawings
  const values = ticks(scale.low, scale.high, 5);
  const numbers = tickTexts(values).map((text, k) => ({ value: values[k]!, text }));
  const longest = Math.max(...y.labels.map((word) => textWidth(shortened(word), letter)));
  const left = Math.ceil(2.3 * letter + longest);
  const top = Math.ceil((title ? 1.9 * letter : 0.6 * letter) + (note ? 1.35 * letter : 0));
  // At least as high as the name of its axis is long.
  const tall = Math.max(row * Math.min(y.labels.length, 12), Math.min(textWidth(y.name, letter), 15 * letter), 5 * row);
  const wide = width - left - Math.ceil(2.5 * letter + Math.max(...numbers.map(({ text }) => textWidth(text, letter))));
  return { width, height: top + tall + 3.4 * letter, left, top, wide, tall, letter, numbers,
    x: (i) => left + wide * i / x.labels.length, y: (j) => top + tall * (1 - j / y.labels.length) };
}

/** Mark of the check status, in a colour that contrasts with the cell. */
function StateMark({ cell, scale, x, y, wide, tall }: { cell: HeatCell; scale: ValueScale; x: number; y: number; wide: number; tall: number }) {
  if (cell.value === null || Math.min(wide, tall) < 6) return null;
  const colour = markColour(scale, cell.value);
  const radius = Math.min(4, 0.3 * Math.min(wide, tall));
  const [cx, cy] = [x + wide / 2, y + tall / 2];
  if (cell.state === 'exceeded') {
    return <path class="mark" d={`M${cx - radius} ${cy + radius}L${cx + radius} ${cy - radius}`} stroke={colour} stroke-width="1.4" />;
  }
  if (cell.state === 'reserved') return <circle class="mark" cx={cx} cy={cy} r={radius} fill="none" stroke={colour} stroke-width="1.4" />;
  if (cell.state === 'not judged') return <circle class="mark" cx={cx} cy={cy} r="1.4" fill={colour} />;
  return null;
}

function Cells({ map, layout, hatch }: { map: HeatMapProps; layout: Layout; hatch: string }) {
  const { cells, scale, choose } = map;
  const judged = cells.flat().some((cell) => cell?.state === 'passed' || cell?.state === 'exceeded');
  return <>{cells.map((row, j) => row.map((cell, i) => {
    if (!cell) return null;
    const [x, y] = [layout.x(i), layout.y(j + 1)];
    const [wide, tall] = [layout.x(i + 1) - x, layout.y(j) - y];
    const fill = cell.state === 'open' || cell.value === null ? 'var(--paper)' : valueColour(scale, cell.value);
    const button = choose && {
      role: 'button' as const, tabIndex: 0, 'aria-label': cell.title, onClick: () => choose(i, j),
      onKeyDown: (event: KeyboardEvent) => { if (event.key === 'Enter') choose(i, j); } };
    return (
      <g key={`${i} ${j}`} class={`cell ${cell.state.replace(' ', '-')}${cell.chosen ? ' chosen' : ''}`} {...button}>
        <title>{cell.title}</title>
        <rect x={x} y={y} width={wide} height={tall} style={{ fill, stroke: 'var(--paper)', strokeWidth: 0.6 }} />
        {cell.state === 'failed' ? <rect x={x} y={y} width={wide} height={tall} style={{ fill: `url(#${hatch})` }} /> : null}
        {cell.state === 'not judged' && !judged ? null : <StateMark cell={cell} scale={scale} x={x} y={y} wide={wide} tall={tall} />}
      </g>
    );
  }))}</>;
}

/** Outline of the cells that pass, and frame of the selected cell. */
function Borders({ cells, layout: { x, y } }: { cells: HeatMapProps['cells']; layout: Layout }) {
  const edge = passEdges(cells).map(([i, j, right, up]) => `M${x(i)} ${y(j)}L${x(i + right)} ${y(j + up)}`).join('');
  const chosen = cells.flatMap((row, j) => row.flatMap((cell, i) => (cell?.chosen ? [`M${x(i)} ${y(j)}H${x(i + 1)}V${y(j + 1)}H${x(i)}Z`] : []))).join('');
  return (
    <g fill="none" stroke-linecap="square" pointer-events="none">
      <path d={edge} stroke="#fff" stroke-width="5" />
      <path d={edge} stroke="#1b2733" stroke-width="2.6" />
      {chosen ? <path d={chosen} stroke="#fff" stroke-width="4" /> : null}
      {chosen ? <path d={chosen} stroke="#c2185b" stroke-width="2" /> : null}
    </g>
  );
}

function AxisLabels({ map: { x, y }, layout: { letter, left, top, wide, tall, x: px, y: py } }: { map: HeatMapProps; layout: Layout }) {
  const [across, up] = [x.labels, y.labels].map((labels) => labels.map((word) => shortened(word))) as [string[], string[]];
  const every = wordStep(across, wide / across.length, letter);
  const everyRow = Math.ceil(1.2 * letter / (tall / up.length));
  return (
    <>
      {across.map((word, i) => (i % every ? null : (
        <text key={i} class="soft" text-anchor="middle" x={(px(i) + px(i + 1)) / 2} y={top + tall + 1.25 * letter}>{word}</text>
      )))}
      {up.map((word, j) => (j % everyRow ? null : (
        <text key={j} class="soft" text-anchor="end" x={left - 0.5 * letter} y={(py(j) + py(j + 1)) / 2 + 0.35 * letter}>{word}</text>
      )))}
      <text class="soft name-x" text-anchor="middle" x={left + wide / 2} y={top + tall + 2.8 * letter}>{x.name}</text>
      <text class="soft name-y" text-anchor="middle" transform={`translate(${letter},${top + tall / 2}) rotate(-90)`}>{y.name}</text>
    </>
  );
}

/** Colours and their values, with a line at the limit. */
function ScaleBar({ scale, layout: { letter, left, top, wide, tall, numbers } }: { scale: ValueScale; layout: Layout }) {
  const id = useId();
  const { low, top: limit, high } = scale;
  const [x, broad] = [left + wide + letter, 0.85 * letter];
  const y = (value: number): number => top + tall * (1 - (value - low) / (high - low));
  return (
    <g class="scale">
      <linearGradient id={id} x1="0" x2="0" y1="1" y2="0">
        {gradientStops(scale).map(({ offset, colour }) => <stop offset={offset} stop-color={colour} />)}
      </linearGradient>
      <rect x={x} y={top} width={broad} height={tall} style={{ fill: `url(#${id})` }} />
      {limit < high ? <line x1={x - 2} x2={x + broad + 3} y1={y(limit)} y2={y(limit)} stroke="#1b2733" stroke-width="2" /> : null}
      {numbers.map(({ value, text }) => (
        <g>
          <line x1={x + broad} x2={x + broad + 3} y1={y(value)} y2={y(value)} stroke="#8794a0" />
          <text class="soft" x={x + 1.4 * letter} y={y(value) + 0.35 * letter}>{text}</text>
        </g>
      ))}
    </g>
  );
}

export function HeatMap(map: HeatMapProps) {
  const hatch = useId();
  const layout = layOut(map);
  const { left, top, wide, tall, letter } = layout;
  return (
    <svg viewBox={`0 0 ${layout.width} ${layout.height}`} class="drawing small" role={map.choose ? 'group' : 'img'} aria-label={map.label}>
      <pattern id={hatch} width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
        <line y2="7" stroke="#7b8794" stroke-width="2.4" />
      </pattern>
      <Cells map={map} layout={layout} hatch={hatch} />
      <rect x={left} y={top} width={wide} height={tall} style={{ fill: 'none', stroke: '#8794a0', pointerEvents: 'none' }} />
      <Borders cells={map.cells} layout={layout} />
      <AxisLabels map={map} layout={layout} />
      {map.title ? <text class="title" x={left} y={1.25 * letter}>{map.title}</text> : null}
      {map.note ? <text class="soft" x={left} y={2.55 * letter}>{map.note}</text> : null}
      {map.cells.flat().some((cell) => cell && cell.value !== null) ? <ScaleBar scale={map.scale} layout={layout} /> : null}
    </svg>
  );
}
