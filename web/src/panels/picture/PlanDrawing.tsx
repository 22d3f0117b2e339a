// The plan: north up, vessel, pipe, lines and objects on the seabed; mooring lines coloured by tension.
import { useRef } from 'preact/hooks';
import type { Lay, MooringLine, Scene, Vector } from '../../api/types';
import { download } from '../../components/download';
import { pipePlaces } from '../../logic/elevation';
import { levelColours, lineLevel, poseAt, sceneAt } from '../../logic/moorings';
import { alongLine, flat, labelAt, outline } from '../../logic/plan';
import { planScreen, screenPath, type PlanScreen } from '../../logic/planScreen';
import { standalone } from '../../logic/pictureFile';
import { text } from '../../logic/show';
import { calmState, chooseLine, chosenLine, linesOfRun, stage } from '../../state/moorings';
import { offsetsInTime } from '../../state/offsets';
import { addRulerPoint, drawnMoment, ruler } from '../../state/picture';
import { chooseBox, chosenBox } from '../../state/chosenBox';
import { calmLay, shownDrawn, shownScene } from '../../state/shown';
import { MooringTable, StageChoice } from '../Moorings';
import { PlanOffsets, scaleBar } from './PlanOffsets';
import { pressed } from './pressed';
import { useSize } from './useSize';

const tableWidth = 540, roomForTable = 1080; // px
const head = 34; // px, for the buttons

type Place = [number, number];

const findShape = (line: MooringLine): Vector[] => (line.shape.length > 1 ? line.shape : [line.fairlead, line.anchor]);
const loadText = (line: MooringLine, inTime: boolean): string => `${inTime ? 'max ' : ''}${text(line.fairlead_tension, 'N')}`;

/** Position of the tension label on each line, as a fraction of its length, so that labels of neighbouring lines do not overlap if possible. */
function loadPlaces(lines: readonly MooringLine[], on: PlanScreen, inTime: boolean): number[] {
  const taken: Place[] = [];
  return lines.map((line) => {
    const wide = 7.4 * loadText(line, inTime).length;
    const seen = (share: number): Place => { const [x, y] = alongLine(findShape(line), share); return [on.x(x), on.y(y)]; };
    const free = (share: number): boolean => taken.every(([x, y]) => Math.abs(x - seen(share)[0]) > wide || Math.abs(y - seen(share)[1]) > 14);
    const share = [0.52, 0.72, 0.86, 0.38].find(free) ?? 0.52;
    taken.push(seen(share));
    return share;
  });
}

interface LineProps { line: MooringLine; on: PlanScreen; chosen: boolean; inTime: boolean; loadAt: number }

function Line({ line, on, chosen, inTime, loadAt }: LineProps) {
  const colour = levelColours[lineLevel(line, inTime)];
  const load = loadText(line, inTime), points = findShape(line);
  const [mx, my] = alongLine(points, loadAt);
  const touch = line.parted || line.on_bed <= 0 ? null : alongLine(points, line.touchdown_distance / (line.horizontal_distance || 1));
  const [ax, ay] = flat(line.anchor);
  const name = on.width < 900 ? line.name.replace('starboard', 'stbd').replace('forward', 'fwd') : line.name;
  const label = labelAt([on.x(ax), on.y(ay)], [line.anchor[0] - line.fairlead[0], line.fairlead[1] - line.anchor[1]], 6.8 * name.length, on.width);
  const said = line.parted ? 'parted' : `${load} at the fairlead${inTime ? ' in the run' : ''}, ${text(line.length, 'm', 6)}`;
  return (
    <g class={`planline${chosen ? ' chosen' : ''}`} onPointerDown={pressed(() => chooseLine(line.name))}>
      <title>{line.name}: {said}</title>
      <path class="hit" d={screenPath(points.map(flat), on)} />
      <path d={screenPath(points.map(flat), on)} stroke={colour} stroke-dasharray={line.parted ? '3 5' : undefined} />
      {touch ? <circle cx={on.x(touch[0])} cy={on.y(touch[1])} r="3" fill="var(--paper)" stroke={colour} /> : null}
      <path class="anchor" d={`M${on.x(ax) - 4} ${on.y(ay) + 4}h8l-4 -9z`} />
      <text class="name" x={label[0]} y={label[1]} text-anchor="middle">{name}</text>
      {line.parted ? null : <text class="load" x={on.x(mx)} y={on.y(my) - 5} text-anchor="middle">{load}</text>}
    </g>
  );
}

/** Lines other than moorings: davit cables, tug lines, jumpers. */
function FreeLine({ name, points, on }: { name: string; points: Place[]; on: PlanScreen }) {
  return (
    <g class={`planline${chosenLine.value === name ? ' chosen' : ''}`} onPointerDown={pressed(() => chooseLine(name))}>
      <title>{name}</title>
      <path class="hit" d={screenPath(points, on)} />
      <path d={screenPath(points, on)} stroke="var(--pipe)" />
    </g>
  );
}

function SeabedObject({ object: { name, points }, on }: { object: Scene['objects'][number]; on: PlanScreen }) {
  const [x, y] = [on.x(points[0]![0]), on.y(points[0]![1])];
  return (
    <g class="object">
      <title>{name}</title>
      {points.length > 1 ? <path d={screenPath(points.map(flat), on)} /> : <circle cx={x} cy={y} r="4" />}
      <text x={x + 6} y={y - 5}>{name}</text>
    </g>
  );
}

/** Boxes across the pipe, and touchdown. */
function LayMarks({ lay, on }: { lay: Lay; on: PlanScreen }) {
  const touch = lay.touchdown?.place;
  return (
    <g>
      {lay.supports.map((box) => {
        const chosen = chosenBox.value === box.name;
        return (
          <circle
            key={box.name}
            class={`planbox${chosen ? ' chosen' : ''}`}
            cx={on.x(box.place[0])}
            cy={on.y(box.place[1])}
            r={chosen ? 5 : 2.4}
            onPointerDown={pressed(() => chooseBox(box.name))}
          >
            <title>{box.name}</title>
          </circle>
        );
      })}
      {touch ? <g class="plantouch"><circle cx={on.x(touch[0])} cy={on.y(touch[1])} r="4" /><text x={on.x(touch[0]) + 8} y={on.y(touch[1]) - 8}>touchdown</text></g> : null}
    </g>
  );
}

function Ruler({ on }: { on: PlanScreen }) {
  const points = (ruler.value ?? []).map((p) => [on.x(p.place[0]), on.y(p.place[1])] as const);
  return (
    <g class="rulermark" pointer-events="none">
      {points.length === 2 ? <path d={`M${points[0]!.join(' ')}L${points[1]!.join(' ')}`} /> : null}
      {points.map(([x, y], k) => <circle key={k} cx={x} cy={y} r="3.5" />)}
    </g>
  );
}

function North({ width, height, on }: { width: number; height: number; on: PlanScreen }) {
  const bar = scaleBar(width / (on.scale || 1)), y = Math.max(70, height - 96);
  return (
    <g>
      <path class="north" d={`M${width - 34} ${y + 30}l7 -26l7 26l-7 -5z`} />
      <text class="north" x={width - 27} y={y} text-anchor="middle">N</text>
      <path class="bar" d={`M14 ${height - 14}v-6v6h${bar * on.scale}v-6`} />
      <text x={20 + bar * on.scale} y={height - 12}>{text(bar, 'm')}</text>
    </g>
  );
}

/** The pipe in plan, to slightly beyond touchdown. */
function pipeTrack(lay: Lay): Place[] {
  const end = (lay.touchdown?.s ?? Infinity) + 300, places = pipePlaces(lay, drawnMoment.value);
  return places.flatMap((p, i): Place[] => ((lay.pipe.s[i] ?? Infinity) <= end ? [flat(p)] : []));
}

function drawnAt(scene: Scene | null): Scene | null {
  const state = calmState.value, drawn = shownDrawn.value, moment = drawnMoment.value;
  if (!scene?.vessel) return scene;
  if (moment) return sceneAt(scene, moment.pose);
  return state && drawn ? sceneAt(scene, poseAt(drawn, state.vessel)) : scene;
}

const freeLines = (lay: Lay | null): { name: string; points: Place[] }[] => (lay?.lines ?? []).map((l) => ({ name: l.name, points: l.shape.map((p: Vector) => flat(p)) }));

export function PlanDrawing() {
  const box = useRef<HTMLDivElement>(null), svg = useRef<SVGSVGElement>(null);
  const { width: whole, height } = useSize(box);
  const state = calmState.value, lay = calmLay.value, scene = drawnAt(shownScene.value);
  // next to the plan if there is room
  const tabled = state !== null && state.moorings.length > 0 && whole >= roomForTable;
  const width = tabled ? whole - tableWidth : whole;
  const offsets = stage.value < 0 && width > 420 ? offsetsInTime.value : null;
  const inset = offsets ? Math.min(170, Math.round(0.3 * height)) : 0;
  const hulls = [...(scene?.vessel ? [scene.vessel] : []), ...(scene?.bodies ?? [])];
  const pipe = lay ? pipeTrack(lay) : [], free = freeLines(lay);
  const inTime = linesOfRun.value !== null, lines = linesOfRun.value ?? state?.moorings ?? [];
  const seen = [...hulls.flatMap(outline), ...lines.flatMap((l) => [flat(l.anchor), flat(l.fairlead)]), ...pipe, ...free.flatMap((l) => l.points)];
  const on = planScreen(seen, width, Math.max(60, height - head - 6), inset);
  const loads = loadPlaces(lines, on, inTime);
  const save = (): void => { if (svg.current) download('plan.svg', new Blob([standalone(svg.current)], { type: 'image/svg+xml' })); };
  const measure = (e: PointerEvent): void => {
    if (!ruler.value) return;
    const r = svg.current!.getBoundingClientRect();
    addRulerPoint({ place: [on.east(e.clientX - r.left), on.north(e.clientY - r.top - head), 0], flat: true });
  };
  return (
    <div class="plan drawingview" ref={box} aria-label="Plan">
      {width > 0 && (lay || scene) ? (
        <svg
          ref={svg}
          class="pictured planview"
          width={width}
          height={height}
          viewBox={`0 0 ${width} ${height}`}
          role="img"
          aria-label={`Plan of ${lines.length ? `${lines.length} mooring lines` : pipe.length ? 'vessel and pipe' : hulls.length ? 'the vessel' : 'the lines'}, north up`}
          onPointerDown={measure}
        >
          <g transform={`translate(0 ${head})`}>
            {(scene?.objects ?? []).map((o) => <SeabedObject key={o.name} object={o} on={on} />)}
            {hulls.map((hull) => <path key={hull.name} class="planhull" d={`${screenPath(outline(hull), on)}Z`}><title>{hull.name}</title></path>)}
            {pipe.length > 1 ? <path class="planpipe" d={screenPath(pipe, on)}><title>pipe</title></path> : null}
            {lines.map((l, i) => <Line key={l.name} line={l} on={on} chosen={chosenLine.value === l.name} inTime={inTime} loadAt={loads[i]!} />)}
            {free.map((l) => <FreeLine key={l.name} name={l.name} points={l.points} on={on} />)}
            {lay && pipe.length > 1 ? <LayMarks lay={lay} on={on} /> : null}
            <Ruler on={on} />
          </g>
          <North width={width} height={height} on={on} />
        </svg>
      ) : null}
      {tabled ? <div class="plantable" style={{ width: `${tableWidth}px` }}><MooringTable lines={lines} wide inTime={inTime} /></div> : null}
      {offsets ? <PlanOffsets of={offsets} size={inset} /> : null}
      <div class="planacts" data-clear><StageChoice /><button type="button" class="tiny" title="Save the plan as SVG" onClick={save}>svg</button></div>
    </div>
  );
}
