// The 3-D view in its element, kept up to date with the content shown.
import type { RefObject } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { effect } from '@preact/signals';
import { poseAt } from '../../logic/moorings';
import { nearest } from '../../logic/series';
import { tensionerState } from '../../logic/tensioner';
import { histories, largestReaction, peakAt, shown as frame, valueAt } from '../../state/animation';
import { approach } from '../../state/events';
import { dragging } from '../../state/live';
import { cursor, picked, theme } from '../../state/look';
import { byPath, opened } from '../../state/model';
import { chosenLine, mooredState, stage } from '../../state/moorings';
import { addRulerPoint, mode, reactionsAt, ruler } from '../../state/picture';
import { chooseBox, chosenBox } from '../../state/chosenBox';
import { ofRun, shownDrawn, shownFailure, shownLay, shownScene, shownStage } from '../../state/shown';
import type { Picked, View3D } from '../../view/view3d';
import { colourValues, pipeColours, inSi } from './colouring';
import { flashesAt, flashing } from './moment';

/** Cable diameter as a fraction of the pipe diameter. */
function cableThickness(): number {
  const cable = byPath.value.get('operation.cable.diameter')?.si, pipe = shownScene.value?.pipe.outer_radius;
  return cable && pipe ? cable / (2 * pipe) : 0.3;
}

function choose(p: Picked): void {
  if (p?.kind === 'roller') chooseBox(p.roller.support.name);
  picked.value = p;
  chosenLine.value = p?.kind === 'line' ? p.name : null;
  cursor.value = p?.kind === 'station' ? shownLay.value?.pipe.s[p.index] ?? null : null;
}

function listen(v: View3D): void {
  v.onPick = (p, x, y) => {
    if (!ruler.value) { choose(p); return; }
    const place = v.placeUnder(x, y);
    if (place) addRulerPoint({ place, flat: false });
  };
  // a clicked position on the pipe is kept until the next click
  v.onHover = (i) => { if (picked.value?.kind !== 'station') cursor.value = i === null ? null : shownLay.value?.pipe.s[i] ?? null; };
}

/** Models, marks and selection. */
function followStatics(v: View3D): (() => void)[] {
  return [
    effect(() => v.setDark(theme.value === 'dark')),
    effect(() => { void opened.value; v.reset(); }),
    effect(() => { if (shownScene.value) v.setScene(shownScene.value); }),
    effect(() => v.setDragging(dragging.value)),
    effect(() => v.setPaused(mode.value !== '3d')),
    effect(() => {
      const state = mooredState.value, lay = shownLay.value, drawn = shownDrawn.value;
      v.setStage(stage.value >= 0 && state && lay?.moorings && drawn ? { state, pose: poseAt(drawn, state.vessel) } : null);
    }),
    effect(() => v.choose(chosenLine.value)),
    effect(() => v.chooseBox(chosenBox.value)),
    effect(() => v.setRuler((ruler.value ?? []).map((p) => p.place))),
    effect(() => { const parts = ofRun.value ? null : shownStage.value?.parts ?? null; v.setParts(parts ? { parts, cable: cableThickness() } : null); }),
    effect(() => { if (shownLay.value) v.setSolution(shownLay.value); }),
  ];
}

/** An instant of a run, and the state that follows it. */
function followMoment(v: View3D): (() => void)[] {
  return [
    effect(() => {
      const f = frame.value, flashes = f ? flashesAt(f.time) : [];
      const h = histories.value, state = f ? tensionerState(peakAt(h['tensioner/state'], f.time)) : null;
      const tensioner = f && state ? { way: state.way, limit: state.limit, travel: valueAt(h['tensioner/travel'], f.time) ?? 0 } : null;
      v.setMoment(f ? { time: f.time, pose: f.pose, places: f.places, flashes, reactions: reactionsAt(f.time), largest: largestReaction.value, tensioner, lines: f.lines } : null);
      flashing.value = flashes.length;
    }),
    effect(() => {
      const s = shownLay.value;
      if (!s) return;
      const f = frame.value, colours = pipeColours(s, f !== null);
      v.setColouring({ values: shownFailure.value && !f ? null : colourValues(s, colours.key), scale: inSi(colours.scale, colours.shown) });
    }),
    effect(() => {
      const s = shownLay.value, place = cursor.value;
      void frame.value;
      v.setCursor(s && place !== null ? nearest(s.pipe.s, place) : null);
    }),
    effect(() => { const to = approach.value; if (to) v.approachBox(to.box); }),
  ];
}

export function useView3D(box: RefObject<HTMLElement>): { view: RefObject<View3D | null>; ready: boolean; problem: string } {
  const view = useRef<View3D | null>(null);
  const [problem, setProblem] = useState('');
  const [ready, setReady] = useState(false);
  useEffect(() => {
    let gone = false;
    let stops: (() => void)[] = [];
    void import('../../view/view3d').then((module) => {
      if (gone || !box.current) return;
      let v: View3D;
      try { v = new module.View3D(box.current); } catch { setProblem('The 3-D view is not available: WebGL is off in this browser. Drawings, results and diagrams are not affected.'); return; }
      view.current = v;
      (window as unknown as { __view: View3D }).__view = v;
      listen(v);
      stops = [...followStatics(v), ...followMoment(v)];
      setReady(true);
    });
    return () => { gone = true; stops.forEach((f) => f()); view.current?.dispose(); view.current = null; };
  }, []);
  return { view, ready, problem };
}
