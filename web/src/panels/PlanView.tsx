// The moorings from above: north up, lines coloured by what they bear, with their tensions; in place of the 3-D view.
import { useEffect, useRef, useState } from 'preact/hooks';
import type { MooringLine, Scene } from '../api/types';
import { levelColours, lineLevel, poseAt, sceneAt } from '../logic/moorings';
import { alongLine, around, ellipse, flat, labelAt, outline, pipeTrack, scaleLength } from '../logic/plan';
import { shownUnit, text } from '../logic/show';
import { download } from '../components/download';
import { calmState, chosenLine, linesOfRun, stage } from '../state/moorings';
import { offsetsInTime, type OffsetsInTime } from '../state/offsets';
import { calmLay, shownDrawn, shownScene } from '../state/shown';
import { MooringTable, StageChoice } from './Moorings';

const tableWidth = 540, roomForTable = 1080; // px

interface Screen { width: number; height: number; scale: number; x: (east: number) => number; y: (north: number) => number }

/** `left`: of the width, for what stands beside the drawing. */
function screenFor(points: [number, number][], width: number, height: number, left: number): Screen {
  const box = around(points);
  const scale = Math.min((width - left) / (box.east - box.west), height / (box.north - box.south));
  const west = (box.west + box.east) / 2 - (width + left) / 2 / scale, north = (box.north + box.south) / 2 + height / 2 / scale;
  return { width, height, scale, x: (east) => (east - west) * scale, y: (at) => (north - at) * scale };
}

/** A round length in the unit shown [m]. */
const scaleBar = (reach: number): number => { const { factor } = shownUnit('m'); return scaleLength(reach * factor) / factor; };

const path = (points: readonly (readonly [number, number])[], on: Screen): string => points.map(([x, y], i) => `${i ? 'L' : 'M'}${on.x(x).toFixed(1)} ${on.y(y).toFixed(1)}`).join('');

function Line({ line, on, chosen, inTime }: { line: MooringLine; on: Screen; chosen: boolean; inTime: boolean }) {
  const colour = levelColours[lineLevel(line, inTime)];
  const load = `${inTime ? 'max ' : ''}${text(line.fairlead_tension, 'N')}`;
  const points = line.shape.length > 1 ? line.shape : [line.fairlead, line.anchor];
  const [mx, my] = alongLine(points, 0.52);
  const touch = line.parted || line.on_bed <= 0 ? null : alongLine(points, line.touchdown_distance / (line.horizontal_distance || 1));
  const [ax, ay] = flat(line.anchor);
  const name = on.width < 900 ? line.name.replace('starboard', 'stbd').replace('forward', 'fwd') : line.name;
  const label = labelAt([on.x(ax), on.y(ay)], [line.anchor[0] - line.fairlead[0], line.fairlead[1] - line.anchor[1]], 6.8 * name.length, on.width);
  return (
    <g class={`planline${chosen ? ' chosen' : ''}`} onClick={() => { chosenLine.value = chosen ? null : line.name; }}>
      <title>{line.parted ? `${line.name}: parted` : `${line.name}: ${load} at the fairlead${inTime ? ' in the run' : ''}, ${text(line.length, 'm', 6)}`}</title>
      <path class="hit" d={path(points.map(flat), on)} />
      <path d={path(points.map(flat), on)} stroke={colour} stroke-dasharray={line.parted ? '3 5' : undefined} />
      {touch ? <circle cx={on.x(touch[0])} cy={on.y(touch[1])} r="3" fill="var(--paper)" stroke={colour} /> : null}
      <path class="anchor" d={`M${on.x(ax) - 4} ${on.y(ay) + 4}h8l-4 -9z`} />
      <text class="name" x={label[0]} y={label[1]} text-anchor="middle">{name}</text>
      {line.parted ? null : <text class="load" x={on.x(mx)} y={on.y(my) - 5} text-anchor="middle">{load}</text>}
    </g>
  );
}

/** Offsets of midship, magnified: they are small beside the spread. */
function Offsets({ of, size }: { of: OffsetsInTime; size: number }) {
  const two = ellipse(of.scatter, 2), { x, y } = of.scatter;
  const reach = 1.15 * Math.max(1e-3, ...of.track.map(([a, b]) => Math.max(Math.abs(a), Math.abs(b))), Math.abs(x.mean) + two.a, Math.abs(y.mean) + two.a);
  const k = size / 2 / reach, at = (v: number): number => size / 2 + k * v, up = (v: number): number => size / 2 - k * v;
  const bar = scaleBar(2 * reach);
  return (
    <svg class="offsetplot" width={size} height={size} viewBox={`0 0 ${size} ${size}`} role="img" aria-label="Offsets of midship during the run">
      <title>Midship from where it is drawn, east to the right and north up: track, mean, and the ellipse of two standard deviations</title>
      <path class="axis" d={`M0 ${size / 2}H${size}M${size / 2} 0V${size}`} />
      <path class="track" d={of.track.map(([a, b], i) => `${i ? 'L' : 'M'}${at(a).toFixed(1)} ${up(b).toFixed(1)}`).join('')} />
      <ellipse cx={at(x.mean)} cy={up(y.mean)} rx={k * two.a} ry={k * two.b} transform={`rotate(${(-two.turn * 180) / Math.PI} ${at(x.mean)} ${up(y.mean)})`} />
      <circle cx={at(x.mean)} cy={up(y.mean)} r="3" />
      <path class="bar" d={`M8 ${size - 8}v-4v4h${k * bar}v-4`} />
      <text x={12 + k * bar} y={size - 8}>{text(bar, 'm')}</text>
      <text x="6" y="14">midship, 2 std</text>
    </svg>
  );
}

/** The drawing with what it takes from the page's style. */
const alone = (text: string): string => text.replace('>', `><style>
text{font:12px "Segoe UI",Arial,sans-serif;fill:#1b2733}.load{font-weight:600}.planline path{fill:none;stroke-width:1.6}.planline .hit{stroke:none}.planline .anchor,.north{fill:#1b2733;stroke:none}
.planpipe{fill:none;stroke:#0b66c2;stroke-width:2}.planhull{fill:#2f4f6b}.object path,.object circle{fill:none;stroke:#a8905a;stroke-dasharray:6 3}.bar{fill:none;stroke:#1b2733}</style>`).replaceAll('var(--paper)', '#fff');

function drawnAt(scene: Scene | null): Scene | null {
  const state = calmState.value, drawn = shownDrawn.value;
  return scene?.vessel && state && drawn ? sceneAt(scene, poseAt(drawn, state.vessel)) : scene;
}

export function PlanView() {
  const box = useRef<HTMLDivElement>(null);
  const svg = useRef<SVGSVGElement>(null);
  const [[whole, height], setSize] = useState<[number, number]>([0, 0]);
  // beside the plan where there is room
  const tabled = calmState.value !== null && calmState.value.moorings.length > 0 && whole >= roomForTable;
  const width = tabled ? whole - tableWidth : whole;
  useEffect(() => {
    const observer = new ResizeObserver(() => { const r = box.current!.getBoundingClientRect(); setSize([Math.floor(r.width), Math.floor(r.height)]); });
    observer.observe(box.current!);
    return () => observer.disconnect();
  }, []);
  const state = calmState.value, lay = calmLay.value, scene = drawnAt(shownScene.value);
  const offsets = stage.value < 0 && width > 420 ? offsetsInTime.value : null;
  const inset = offsets ? Math.min(170, Math.round(0.3 * height)) : 0;
  const hull = scene?.vessel ? outline(scene.vessel) : [];
  const pipe = lay ? pipeTrack(lay) : [];
  const inTime = linesOfRun.value !== null, lines = linesOfRun.value ?? state?.moorings ?? [];
  const on = screenFor([...hull, ...lines.flatMap((l) => [flat(l.anchor), flat(l.fairlead)])], width, Math.max(60, height - 40), inset);
  const bar = scaleBar(width / (on.scale || 1));
  const save = (): void => { if (svg.current) download('plan-of-moorings.svg', new Blob([alone(new XMLSerializer().serializeToString(svg.current))], { type: 'image/svg+xml' })); };
  return (
    <div class="plan" ref={box} aria-label="Plan of the moorings">
      {width > 0 && state ? (
        <svg ref={svg} class="planview" width={width} height={height} viewBox={`0 0 ${width} ${height}`} role="img" aria-label={`Plan of ${lines.length ? `${lines.length} mooring lines` : 'the vessel'}, north up`}>
          <g transform="translate(0 34)">
            {(scene?.objects ?? []).map((o) => (
              <g key={o.name} class="object"><title>{o.name}</title>
                {o.points.length > 1 ? <path d={path(o.points.map(flat), on)} /> : <circle cx={on.x(o.points[0]![0])} cy={on.y(o.points[0]![1])} r="4" />}
                <text x={on.x(o.points[0]![0]) + 6} y={on.y(o.points[0]![1]) - 5}>{o.name}</text></g>
            ))}
            {pipe.length > 1 ? <path class="planpipe" d={path(pipe, on)}><title>pipe</title></path> : null}
            {lines.map((l) => <Line key={l.name} line={l} on={on} chosen={chosenLine.value === l.name} inTime={inTime} />)}
            {hull.length ? <path class="planhull" d={`${path(hull, on)}Z`}><title>{scene!.vessel!.name}</title></path> : null}
          </g>
          <path class="north" d={`M${width - 26} 122l7 -26l7 26l-7 -5z`} /><text class="north" x={width - 19} y="92" text-anchor="middle">N</text>
          <path class="bar" d={`M14 ${height - 14}v-6v6h${bar * on.scale}v-6`} /><text x={20 + bar * on.scale} y={height - 12}>{text(bar, 'm')}</text>
        </svg>
      ) : null}
      {tabled ? <div class="plantable" style={{ width: `${tableWidth}px` }}><MooringTable lines={lines} wide inTime={inTime} /></div> : null}
      {offsets ? <Offsets of={offsets} size={inset} /> : null}
      <div class="planacts"><StageChoice /><button type="button" class="tiny" title="Save the plan as SVG" onClick={save}>svg</button></div>
    </div>
  );
}
