// Pointer in the elevation: it pans, zooms, drags boxes, measures, and selects.
import { useEffect, useRef, useState } from 'preact/hooks';
import type { Frame } from '../../../components/chart/types';
import type { Elevation } from '../../../logic/elevation';
import { nearest } from '../../../logic/series';
import { inBoxFrame, toWorld } from '../../../logic/shipAxes';
import { shiftWindow, zoomWindow, type Window } from '../../../logic/sideFrame';
import { beginDrag, boxDrag, cancelDrag, dragTo, endDrag, movableBox } from '../../../state/boxDrag';
import { cursor, picked } from '../../../state/look';
import { chosenLine } from '../../../state/moorings';
import { addRulerPoint, ruler } from '../../../state/picture';
import { chooseBox } from '../../../state/chosenBox';
import { shownScene } from '../../../state/shown';
import { userWindow } from './window';

const clickReach = 4, pipeReach = 14; // px

type Held = { kind: 'box'; name: string; place: readonly [number, number] } | { kind: 'window'; window: Window };
interface Press { x: number; y: number; held: Held; moved: boolean; frame: Frame }

/** Position in the drawing under the pointer. */
function pointerPlace(e: MouseEvent, svg: Element, frame: Frame): [number, number] {
  const r = svg.getBoundingClientRect();
  return [frame.x.invert(e.clientX - r.left), frame.y.invert(e.clientY - r.top)];
}

/** Index of the station under the pointer. */
function stationAt({ lay: { stations } }: Elevation, frame: Frame, [x, z]: readonly [number, number]): number | null {
  if (stations.s.length === 0) return null;
  const i = nearest(stations.x, x);
  let best: number | null = null, closest = pipeReach;
  for (let k = Math.max(0, i - 6); k <= Math.min(stations.s.length - 1, i + 6); ++k) {
    const away = Math.hypot(frame.x(stations.x[k]!) - frame.x(x), frame.y(stations.z[k]!) - frame.y(z));
    if (away < closest) { closest = away; best = k; }
  }
  return best;
}

export function usePointer(side: Elevation | null, frame: Frame | null, shown: Window | null) {
  const press = useRef<Press | null>(null);
  const [held, setHeld] = useState<readonly [number, number] | null>(null);
  const latest = useRef({ side, frame, shown });
  latest.current = { side, frame, shown };

  useEffect(() => {
    const key = (e: KeyboardEvent): void => {
      if (e.key !== 'Escape' || !boxDrag.value) return;
      e.preventDefault();
      e.stopPropagation();
      press.current = null;
      setHeld(null);
      cancelDrag();
    };
    addEventListener('keydown', key, true);
    return () => { removeEventListener('keydown', key, true); if (boxDrag.peek()) cancelDrag(); };
  }, []);

  const begin = (e: PointerEvent, what: Held): void => {
    if (e.button !== 0 || !latest.current.frame) return;
    (e.currentTarget as Element).closest('svg')!.setPointerCapture(e.pointerId);
    press.current = { x: e.clientX, y: e.clientY, held: what, moved: false, frame: latest.current.frame };
  };

  const takeBox = (e: PointerEvent, name: string): void => {
    if (ruler.value) return; // the click belongs to the ruler
    e.stopPropagation();
    const box = latest.current.side?.lay.supports.find((b) => b.name === name);
    if (box) begin(e, { kind: 'box', name, place: [box.p[0], box.p[2]] });
  };

  const dragBox = (e: PointerEvent, { frame: start, x, y, held: what }: Press): void => {
    if (what.kind !== 'box' || !latest.current.side) return;
    if (!boxDrag.value) { chooseBox(what.name); beginDrag(what.name); }
    const fine = e.altKey ? 0.1 : 1, [m, n] = [start.x(1) - start.x(0), start.y(1) - start.y(0)];
    const [astern, up] = [(fine * (e.clientX - x)) / m, (fine * (e.clientY - y)) / n];
    const pose = shownScene.value?.vessel?.pose;
    const move = pose ? inBoxFrame(pose, latest.current.side.axes, astern, up) : { x: astern, z: up };
    setHeld([what.place[0] + astern, what.place[1] + up]);
    dragTo(Math.round(move.x * 1e3) / 1e3, Math.round(move.z * 1e3) / 1e3);
  };

  const onPointerMove = (e: PointerEvent): void => {
    const p = press.current, { side: s, frame: f } = latest.current;
    if (!s || !f) return;
    if (!p) {
      const i = stationAt(s, f, pointerPlace(e, e.currentTarget as Element, f));
      if (picked.value?.kind !== 'station') cursor.value = i === null ? null : s.lay.stations.s[i]!;
      return;
    }
    if (!p.moved && Math.hypot(e.clientX - p.x, e.clientY - p.y) < clickReach) return;
    p.moved = true;
    if (p.held.kind === 'box') { if (movableBox(p.held.name)) dragBox(e, p); return; }
    userWindow.value = shiftWindow(p.held.window, -(e.clientX - p.x) / (p.frame.x(1) - p.frame.x(0)), -(e.clientY - p.y) / (p.frame.y(1) - p.frame.y(0)));
  };

  const click = (e: PointerEvent, what: Held): void => {
    const { side: s, frame: f } = latest.current;
    if (!s || !f) return;
    const place = pointerPlace(e, e.currentTarget as Element, f);
    if (ruler.value) { addRulerPoint({ place: toWorld(s.axes, [place[0], 0, place[1]]), flat: false }); return; }
    if (what.kind === 'box') { chooseBox(what.name); return; }
    const i = stationAt(s, f, place);
    picked.value = i === null ? null : { kind: 'station', index: i };
    cursor.value = i === null ? null : s.lay.stations.s[i]!;
    if (i !== null) chosenLine.value = null;
  };

  const onPointerUp = (e: PointerEvent): void => {
    const p = press.current;
    press.current = null;
    setHeld(null);
    if (boxDrag.value) void endDrag();
    else if (p && !p.moved) click(e, p.held);
  };

  const handlers = {
    onPointerDown: (e: PointerEvent) => { if (latest.current.shown) begin(e, { kind: 'window', window: latest.current.shown }); },
    onPointerMove, onPointerUp,
    onPointerCancel: () => { press.current = null; setHeld(null); if (boxDrag.value) cancelDrag(); },
    onPointerLeave: () => { if (!press.current && picked.value?.kind !== 'station') cursor.value = null; },
    onDblClick: () => { userWindow.value = null; },
    onWheel: (e: WheelEvent) => {
      const { frame: f, shown: w } = latest.current;
      if (!f || !w) return;
      e.preventDefault();
      const [x, z] = pointerPlace(e, e.currentTarget as Element, f);
      userWindow.value = zoomWindow(w, x, z, Math.exp(Math.max(-80, Math.min(80, e.deltaY)) * 0.0025));
    },
  };
  return { handlers, takeBox, held };
}
