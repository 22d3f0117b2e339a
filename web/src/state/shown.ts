// What picture, diagrams and results show: the run that is looked at, else the live statics of the open model.
import { computed } from '@preact/signals';
import type { Lay, Scene } from '../api/types';
import { calm, failure, scene, solution } from './live';
import { runLay, runScene } from './runs';

export const ofRun = computed(() => runLay.value !== null && runScene.value !== null);
export const shownLay = computed<Lay | null>(() => (ofRun.value ? runLay.value : solution.value));
/** The same, at the pace of panels and diagrams. */
export const calmLay = computed<Lay | null>(() => (ofRun.value ? runLay.value : calm.value));
export const shownScene = computed<Scene | null>(() => (ofRun.value ? runScene.value : scene.value));
export const shownFailure = computed(() => (ofRun.value ? null : failure.value));
