// The elevation: true to scale or with exaggerated heights. Boxes can be dragged in it.
import { useEffect, useRef } from 'preact/hooks';
import { linearScale } from '../../../components/chart/scale';
import { LabelRoom } from '../../../components/chart/labels';
import { textWidth } from '../../../components/chart/text';
import type { Frame } from '../../../components/chart/types';
import { Rollers, Sea, Structure, TruePipe } from '../../../components/SideView';
import { hullCorner, structures } from '../../../components/lay';
import { elevation, type Elevation } from '../../../logic/elevation';
import { exaggeration, fitWindow, plotEdges, plotSize, scaleText, type Size, type Window } from '../../../logic/sideFrame';
import { shown as moment } from '../../../state/animation';
import { boxDrag, movableBox } from '../../../state/boxDrag';
import { dragging } from '../../../state/live';
import { cursor } from '../../../state/look';
import { byPath } from '../../../state/model';
import { chooseLine, chosenLine, mooredState } from '../../../state/moorings';
import { drawnMoment, drawnScene, ruler } from '../../../state/picture';
import { chooseBox, chosenBox } from '../../../state/chosenBox';
import { shownFailure, shownLay } from '../../../state/shown';
import { nearest } from '../../../logic/series';
import { toShip } from '../../../logic/shipAxes';
import { colourValues, pipeColours, inSi } from '../colouring';
import { cards } from '../moment';
import { useSize } from '../useSize';
import { Axes, BoxHandle, ColouredPipe, SideLines, SideNames, Tensioner, type SideName } from './parts';
import { usePointer } from './pointer';
import { fit, availableFits, userWindow, fittedPart, trueScale, type Fit } from './window';

function frameFor(size: Size, shown: Window): Frame {
  const { left, right, top, bottom } = plotEdges(size);
  return {
    ...size, left, right, top, bottom,
    x: linearScale([shown.x0, shown.x1], [right, left]),
    y: linearScale([shown.z0, shown.z1], [bottom, top]),
    room: new LabelRoom({ x0: left, x1: right, y0: top, y1: bottom }),
    textWidth: (text, bold) => textWidth(text, 12, bold),
  };
}

function Background({ frame, side }: { frame: Frame; side: Elevation }) {
  const [x0, x1] = frame.x.domain, steps = 60;
  const bed = Array.from({ length: steps + 1 }, (_, k) => { const x = x0 + ((x1 - x0) * k) / steps; return [x, side.bed(x)] as const; });
  const { lay, hull } = side;
  const corners = hull ? [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([along, up]) => hullCorner(lay, along!, 0, up!, hull.lower, hull.upper)) : [];
  return <Sea frame={frame} bed={bed} hull={corners.map((p) => [p[0], p[2]] as const)} />;
}

function sideNames(side: Elevation): SideName[] {
  const { lay, hull } = side, laid = lay.stations.s.length > 0;
  const deck = hull ? hullCorner(lay, 0.4, 0, 1, hull.lower, hull.upper) : null;
  return [
    ...(deck ? [{ text: lay.vessel.name, x: deck[0], z: deck[2], weight: 7 }] : []),
    ...(laid && shownLay.value?.touchdown ? [{ text: 'touchdown', x: lay.touchdown.p[0], z: lay.touchdown.p[2], weight: 6 }] : []),
    ...(laid && shownLay.value?.tensioner ? [{ text: 'tensioner', x: lay.tensioner[0], z: lay.tensioner[2], weight: 5 }] : []),
    ...lay.supports.map((box): SideName => ({
      text: box.name, x: box.p[0], z: box.p[2] + 0.4, weight: box.name === chosenBox.value ? 100 : 1e-9 * box.rows.reduce((sum, row) => sum + row.reaction, 0),
      chosen: box.name === chosenBox.value, act: () => chooseBox(box.name),
    })),
    ...side.lines.filter((line) => !line.moored).map((line) => { const p = line.points[Math.floor(line.points.length / 2)]!; return { text: line.name, x: p[0], z: p[1], weight: 3 }; }),
  ];
}

function Marks({ frame, side }: { frame: Frame; side: Elevation }) {
  const s = cursor.value, { stations } = side.lay;
  const i = s === null || stations.s.length === 0 ? null : nearest(stations.s, s);
  const points = (ruler.value ?? []).map((p) => toShip(side.axes, p.place)).map((p) => [frame.x(p[0]), frame.y(p[2])] as const);
  return (
    <g pointer-events="none">
      {i === null ? null : <circle class="cursormark" cx={frame.x(stations.x[i]!)} cy={frame.y(stations.z[i]!)} r="5" />}
      <g class="rulermark">
        {points.length === 2 ? <path d={`M${points[0]!.join(' ')}L${points[1]!.join(' ')}`} /> : null}
        {points.map(([x, y], k) => <circle key={k} cx={x} cy={y} r="3.5" />)}
      </g>
    </g>
  );
}

function Pipe({ frame, side }: { frame: Frame; side: Elevation }) {
  const lay = shownLay.value!, colours = pipeColours(lay, moment.value !== null);
  return (
    <>
      <TruePipe frame={frame} lay={side.lay} />
      <ColouredPipe frame={frame} lay={side.lay} values={colourValues(lay, colours.key)} scale={inSi(colours.scale, colours.shown)} grey={shownFailure.value !== null && moment.value === null} />
    </>
  );
}

/** The dragged box at the pointer: statics follow with a delay. */
function Dragged({ frame, side, from }: { frame: Frame; side: Elevation; from: readonly [number, number] | null }) {
  const drag = boxDrag.value;
  const box = drag && side.lay.supports.find((b) => b.name === drag.name);
  if (!drag || !box || !from) return null;
  const [x, y] = [frame.x(from[0]), frame.y(from[1])];
  return (
    <g class="dragmark" pointer-events="none">
      <path d={`M${x - 12} ${y}h24M${x} ${y - 12}v24`} />
      <circle cx={x} cy={y} r="5" />
    </g>
  );
}

const fitNames: Record<Fit, string> = { whole: 'whole', boxes: 'boxes', touchdown: 'touchdown' };

function Choices({ side, factor }: { side: Elevation; factor: number }) {
  const show = (name: Fit): void => { fit.value = name; userWindow.value = null; };
  return (
    <div class="sidechoices" data-clear>
      {availableFits(side).map((name) => <button key={name} type="button" aria-pressed={userWindow.value === null && fit.value === name} onClick={() => show(name)}>{fitNames[name]}</button>)}
      <button type="button" aria-pressed={trueScale.value} title="Same scale horizontally and vertically" onClick={() => { trueScale.value = !trueScale.value; userWindow.value = null; }}>true scale</button>
      {trueScale.value && userWindow.value === null ? null : <span class="scalewords">{scaleText(factor)}</span>}
    </div>
  );
}

export function SideDrawing() {
  const box = useRef<HTMLDivElement>(null);
  const size = useSize(box);
  const last = useRef<Window | null>(null);
  const lay = shownLay.value, scene = drawnScene.value;
  const side = lay && scene ? elevation(lay, scene, mooredState.value, drawnMoment.value, byPath.value.get('pipe.steel.outside_diameter')?.si ?? null) : null;
  const plot = plotSize(size);
  // during a drag the frame does not move under the pointer
  const frozen = last.current !== null && (boxDrag.value !== null || dragging.value);
  const shown = side ? userWindow.value ?? (frozen ? last.current! : fitWindow(fittedPart(side, fit.value), plot, trueScale.value)) : null;
  last.current = shown;
  const frame = shown && size.width > 0 ? frameFor(size, shown) : null;
  const pointer = usePointer(side, frame, shown);
  useEffect(() => () => { last.current = null; }, []);
  return (
    <div class="drawingview" ref={box}>
      {side && frame && shown ? (
        <>
          <svg class="pictured sideview" width={size.width} height={size.height} viewBox={`0 0 ${size.width} ${size.height}`} role="group" aria-label="Side view" {...pointer.handlers}>
            <clipPath id="sideclip"><rect x={frame.left} y={frame.top} width={frame.right - frame.left} height={frame.bottom - frame.top} /></clipPath>
            <g clip-path="url(#sideclip)">
              <Background frame={frame} side={side} />
              <SideLines frame={frame} lines={side.lines} moorings={mooredState.value?.moorings ?? []} chosen={chosenLine.value} choose={chooseLine} />
              {structures(side.lay.supports).map((list, k) => <Structure key={k} frame={frame} boxes={list} />)}
              <Rollers frame={frame} boxes={side.lay.supports} position="starboard" />
              <Rollers frame={frame} boxes={side.lay.supports} position="bottom" />
              {side.lay.stations.s.length > 1 ? <Pipe frame={frame} side={side} /> : null}
              <Rollers frame={frame} boxes={side.lay.supports} position="port" />
              {lay!.tensioner ? <Tensioner frame={frame} lay={side.lay} /> : null}
              {side.lay.supports.map((b) => (
                <BoxHandle key={b.name} frame={frame} box={b} chosen={chosenBox.value === b.name} movable={movableBox(b.name) !== null} begin={(e) => pointer.takeBox(e, b.name)} choose={() => chooseBox(b.name)} />
              ))}
            </g>
            <Axes frame={frame} />
            <SideNames frame={frame} names={sideNames(side)} taken={cards.value} />
            <Marks frame={frame} side={side} />
            <Dragged frame={frame} side={side} from={pointer.held} />
          </svg>
          <Choices side={side} factor={exaggeration(shown, plot)} />
          {boxDrag.value ? <DragReading /> : null}
        </>
      ) : <p class="empty">No solution yet.</p>}
    </div>
  );
}

function DragReading() {
  const { name } = boxDrag.value!, box = movableBox(name);
  if (!box) return null;
  const { x, z } = boxDrag.value!;
  return <p class="dragreading" role="status"><b>{name}</b> x {(box.x + x).toFixed(3)} m, z {(box.z + z).toFixed(3)} m <small>Esc cancels</small></p>;
}
