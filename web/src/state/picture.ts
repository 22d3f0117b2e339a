// The picture: the view, the ruler, and the instant of a run for drawings.
import { computed, effect, signal, untracked } from '@preact/signals';
import type { Scene } from '../api/types';
import type { DrawnMoment } from '../logic/elevation';
import { poseAt, sceneAt } from '../logic/moorings';
import { measure, withPoint, type RulerPoint } from '../logic/ruler';
import { shipAxes } from '../logic/shipAxes';
import { availableDrawings, type DrawingName } from '../logic/views';
import { histories, peakAt, shown as frame } from './animation';
import { opened } from './model';
import { mooredState, stage } from './moorings';
import { calmLay, shownDrawn, shownScene } from './shown';

export const mode = signal<'3d' | DrawingName>('3d');

/** Points of the ruler; null while it is inactive. */
export const ruler = signal<readonly RulerPoint[] | null>(null);
export const measured = computed(() => {
  const points = ruler.value, scene = shownScene.value;
  return points?.length === 2 && scene ? measure(shipAxes(scene, calmLay.value), [points[0]!, points[1]!]) : null;
});
export function addRulerPoint(point: RulerPoint): void { if (ruler.value) ruler.value = withPoint(ruler.value, point); }

/** Reactions of the boxes at a time, as far as the run has their histories. */
export function reactionsAt(t: number): Map<string, number> {
  const out = new Map<string, number>();
  for (const [name, series] of Object.entries(histories.value)) {
    const box = /^support\/(.*)\/reaction$/.exec(name)?.[1], value = box ? peakAt(series, t) : null;
    if (box && value !== null) out.set(box, value);
  }
  return out;
}

/** An instant of the run shown; null for statics. */
export const drawnMoment = computed<DrawnMoment | null>(() => {
  const f = frame.value;
  return f && { pose: f.pose, places: f.places, lines: f.lines, reactions: reactionsAt(f.time) };
});

/** The scene with the vessel at its position in the stage shown. */
export const drawnScene = computed<Scene | null>(() => {
  const scene = shownScene.value, state = mooredState.value, drawn = shownDrawn.value;
  return scene?.vessel && state && drawn && stage.value >= 0 ? sceneAt(scene, poseAt(drawn, state.vessel)) : scene;
});

export function startPicture(): void {
  effect(() => { void opened.value; untracked(() => { ruler.value = null; }); });
  effect(() => { const lay = calmLay.value, current = mode.value; if (lay && current !== '3d' && !availableDrawings(lay).includes(current)) mode.value = '3d'; });
}
