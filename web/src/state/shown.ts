// What picture, diagrams and results show: the run that is looked at, else the stage of the operation that is chosen, else
// the live statics of the open model.
import { computed } from '@preact/signals';
import type { Lay, Scene } from '../api/types';
import { settled } from '../logic/moorings';
import { calm, failure, scene, solution } from './live';
import { stageLay } from './operation';
import { runLay, runScene } from './runs';

export const ofRun = computed(() => runLay.value !== null && runScene.value !== null);
export const shownLay = computed<Lay | null>(() => (ofRun.value ? runLay.value : stageLay.value ?? solution.value));
/** The same, at the pace of panels and diagrams. */
export const calmLay = computed<Lay | null>(() => (ofRun.value ? runLay.value : stageLay.value ?? calm.value));
/** With the vessel as it lies in statics. */
export const shownScene = computed<Scene | null>(() => settled(ofRun.value ? runScene.value : scene.value, shownLay.value));
/** Where the vessel is drawn: offsets of statics count from there. */
export const shownDrawn = computed<number[] | null>(() => (ofRun.value ? runScene.value : scene.value)?.vessel?.pose ?? null);
export const shownFailure = computed(() => (ofRun.value || stageLay.value ? null : failure.value));
