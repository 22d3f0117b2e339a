// Cross-section through the selected box, row by row, or through the pipe at the cursor; view from astern, port on the left.
import { useRef } from 'preact/hooks';
import type { Lay, Scene, Support } from '../../api/types';
import { bedHeight } from '../../logic/bed';
import { boxSection, heaviestBox, pipeLayers, type PipeLayer, type SectionRoller, type SectionRow } from '../../logic/section';
import { loadShares } from '../../logic/colour';
import { nearest } from '../../logic/series';
import { text } from '../../logic/show';
import { cursor, picked } from '../../state/look';
import { byPath } from '../../state/model';
import { chooseBox, chosenBox } from '../../state/chosenBox';
import { ofRun, shownLay, shownScene } from '../../state/shown';
import { useSize } from './useSize';

const loadColour = (share: number): string => `rgb(${loadShares(share).map((v) => Math.round(255 * v)).join(' ')})`;

const place = (s: number): string => `${text(s, 'm', 5)} from the tensioner`;

function PipeRings({ layers, x, y, scale }: { layers: readonly PipeLayer[]; x: number; y: number; scale: number }) {
  return (
    <g>
      {[...layers].reverse().map((layer) => (
        <circle key={layer.name} cx={x} cy={y} r={layer.radius * scale} fill={layer.colour} stroke="var(--soft)" stroke-width="0.8">
          <title>{layer.name}, outside diameter {text(2 * layer.radius, 'mm', 5)}</title>
        </circle>
      ))}
      <path d={`M${x - 5} ${y}h10M${x} ${y - 5}v10`} stroke="var(--ink)" stroke-width="0.8" />
    </g>
  );
}

function RollerShape({ roller: r, scale, largest }: { roller: SectionRoller; scale: number; largest: number }) {
  const touches = r.reaction > 0;
  return (
    <rect
      x={-0.5 * r.face * scale}
      y={-r.radius * scale}
      width={r.face * scale}
      height={2 * r.radius * scale}
      rx="2"
      transform={`translate(${r.x * scale} ${-r.y * scale}) rotate(${(-r.turn * 180) / Math.PI})`}
      fill={touches ? loadColour(r.reaction / largest) : 'none'}
      stroke={touches ? 'var(--ink)' : 'var(--soft)'}
      stroke-dasharray={touches ? undefined : '4 3'}
    >
      <title>{r.position}: {touches ? `reaction ${text(r.reaction, 'N', 4)}` : `clear by ${text(r.separation, 'mm', 3)}`}</title>
    </rect>
  );
}

const said = (r: SectionRoller): string => `${r.position} ${r.reaction > 0 ? text(r.reaction, 'N', 4) : `gap ${text(r.separation, 'mm', 3)}`}`;

/** `foot`: position of the name, below the centre of the bottom roller [px]. */
interface RowProps { row: SectionRow; name: string; layers: readonly PipeLayer[]; x: number; y: number; foot: number; scale: number; largest: number; lines: boolean }

/** Arrow to a pipe that is too far away to be drawn. */
function AwayMark({ pipe: [x, y], outer, scale }: { pipe: readonly [number, number]; outer: number; scale: number }) {
  const size = Math.hypot(x, y), turn = (Math.atan2(x, y) * 180) / Math.PI;
  return (
    <g class="awaymark" transform={`translate(0 ${-2.4 * outer * scale})`}>
      <path d="M0 10V-8M-5 -2L0 -10L5 -2" transform={`rotate(${turn})`} />
      <text y="26" text-anchor="middle">pipe {text(size, 'm', 3)} away</text>
    </g>
  );
}

function Row({ row, name, layers, x, y, foot, scale, largest, lines }: RowProps) {
  const outer = layers.at(-1)!.radius, far = Math.hypot(...row.pipe) >= farAway * outer;
  return (
    <g transform={`translate(${x} ${y})`} class="sectionrow">
      {row.rollers.map((roller, i) => <RollerShape key={i} roller={roller} scale={scale} largest={largest} />)}
      {far ? <AwayMark pipe={row.pipe} outer={outer} scale={scale} /> : <PipeRings layers={layers} x={row.pipe[0] * scale} y={-row.pipe[1] * scale} scale={scale} />}
      <text class="sectionname" y={foot} text-anchor="middle">{name}</text>
      {lines ? row.rollers.map((r, i) => <text key={i} class={r.reaction > 0 ? 'touches' : ''} y={foot + 16 * (i + 1)} text-anchor="middle">{said(r)}</text>) : null}
    </g>
  );
}

/** Extent of all rows about the centre of the bottom roller [m]: half width, above and below. A distant pipe is left out. */
function findExtent(rows: readonly SectionRow[], outer: number): { across: number; above: number; below: number } {
  const rollers = rows.flatMap((row) => row.rollers), pipes = rows.map((row) => row.pipe).filter((p) => Math.hypot(...p) < farAway * outer);
  const half = (r: SectionRoller, along: number, round: number): number => 0.5 * r.face * Math.abs(along) + r.radius * Math.abs(round);
  return {
    across: Math.max(1.3 * outer, ...rollers.map((r) => Math.abs(r.x) + half(r, Math.cos(r.turn), Math.sin(r.turn))), ...pipes.map(([x]) => Math.abs(x) + 1.05 * outer)),
    above: Math.max(2 * outer, ...rollers.map((r) => r.y + half(r, Math.sin(r.turn), Math.cos(r.turn))), ...pipes.map(([, y]) => y + 1.05 * outer)),
    below: Math.max(outer, ...rollers.map((r) => -r.y + half(r, Math.sin(r.turn), Math.cos(r.turn))), ...pipes.map(([, y]) => -y + 1.05 * outer)),
  };
}

const farAway = 7; // multiple of the pipe radius

interface Size { width: number; height: number }

function BoxSection({ lay, scene, box, size, layers }: { lay: Lay; scene: Scene; box: Support; size: Size; layers: readonly PipeLayer[] }) {
  const rows = boxSection(lay, scene, box), outer = layers.at(-1)!.radius;
  const largest = Math.max(1, ...lay.supports.flatMap((s) => s.rollers.map((r) => r.reaction)));
  const head = size.height > 260 ? 70 : 62, lines = size.height > 260;
  const below = lines ? 26 + 16 * Math.max(...rows.map((row) => row.rollers.length)) : 32;
  const room = findExtent(rows, outer), cell = size.width / Math.max(1, rows.length);
  const scale = Math.max(30, Math.min((cell - 16) / (2 * room.across), Math.max(40, size.height - head - below) / (room.above + room.below)));
  const top = head + Math.max(0, 0.4 * (size.height - head - below - scale * (room.above + room.below)));
  return (
    <>
      {rows.map((row, i) => (
        <Row key={i} row={row} name={`row ${i + 1} of ${rows.length}, ${text(row.s, 'm', 5)}`} layers={layers} x={cell * (i + 0.5)} y={top + scale * room.above} foot={scale * room.below + 22} scale={scale} largest={largest} lines={lines && cell > 110} />
      ))}
    </>
  );
}

function NodeSection({ lay, scene, index, size, layers }: { lay: Lay; scene: Scene; index: number; size: Size; layers: readonly PipeLayer[] }) {
  const outer = layers.at(-1)!.radius, { pipe } = lay;
  const gap = pipe.z[index]! - outer - bedHeight(scene.seabed, pipe.x[index]!, pipe.y[index]!);
  const room = Math.max(40, Math.min(size.width - 40, size.height - 120)), scale = room / (3.4 * outer);
  const [x, y] = [size.width / 2, 64 + room / 2], bed = y + (outer + gap) * scale, near = gap < 1.2 * outer;
  return (
    <g>
      {near ? <rect x="0" y={bed} width={size.width} height={Math.max(0, size.height - bed)} fill="var(--bed)" /> : null}
      <PipeRings layers={layers} x={x} y={y} scale={scale} />
      <text x={x} y={Math.min(size.height - 30, y + outer * scale + 22)} text-anchor="middle">
        {gap > 0 ? `${text(gap, 'm', 4)} above the seabed` : `${text(-gap, 'mm', 3)} in the seabed`}
      </text>
    </g>
  );
}

function LayerKey({ layers }: { layers: readonly PipeLayer[] }) {
  if (layers.length < 2) return null;
  return (
    <ul class="layerkey" data-clear>
      {layers.slice(1).map((layer, i) => <li key={layer.name}><i style={{ background: layer.colour }} />{layer.name} {text(layer.radius - layers[i]!.radius, 'mm', 4)}</li>)}
    </ul>
  );
}

function Steps({ lay, box }: { lay: Lay; box: Support }) {
  const i = lay.supports.indexOf(box);
  const step = (by: number) => {
    const next = lay.supports[i + by];
    const label = by < 0 ? 'Previous box' : 'Next box';
    return <button type="button" aria-label={label} title={label} disabled={!next} onClick={() => next && chooseBox(next.name)}>{by < 0 ? '‹' : '›'}</button>;
  };
  return <>{step(-1)}{step(1)}</>;
}

export function SectionDrawing() {
  const frame = useRef<HTMLDivElement>(null), size = useSize(frame);
  const lay = shownLay.value, scene = shownScene.value;
  if (!lay || !scene || lay.pipe.s.length === 0) return <div class="drawingview" ref={frame}><p class="empty">No solution yet.</p></div>;
  const chosen = lay.supports.find((s) => s.name === chosenBox.value);
  const pinned = picked.value?.kind === 'station' ? picked.value.index : null;
  const node = pinned ?? (chosen || cursor.value === null ? null : nearest(lay.pipe.s, cursor.value));
  const box = node === null ? chosen ?? heaviestBox(lay) : null;
  const layers = pipeLayers((path) => (ofRun.value ? undefined : byPath.value.get(path)), scene.pipe.outer_radius);
  const index = node ?? 0, drawn = box || lay.pipe.s.length > index;
  return (
    <div class="drawingview" ref={frame}>
      {size.width > 0 && drawn ? (
        <svg class="pictured sectionview" width={size.width} height={size.height} viewBox={`0 0 ${size.width} ${size.height}`} role="img" aria-label={box ? `Section through ${box.name}` : 'Section through the pipe'}>
          {box ? <BoxSection lay={lay} scene={scene} box={box} size={size} layers={layers} /> : <NodeSection lay={lay} scene={scene} index={index} size={size} layers={layers} />}
        </svg>
      ) : null}
      <p class="sectiontitle" data-clear>
        {box ? <Steps lay={lay} box={box} /> : null}
        <b>{box ? box.name : `pipe, ${place(lay.pipe.s[index]!)}`}</b>
        {box ? ` ${box.contact ? `reaction ${text(box.reaction, 'N', 4)}` : `clear by ${text(box.separation, 'mm', 3)}`}` : ''}
        <small> view from astern, port on the left</small>
      </p>
      <LayerKey layers={layers} />
    </div>
  );
}
