// Results shown in picture, diagrams and tables for each workspace: Lay and Study the live statics of the open model, Operation the
// selected stage, Storm and Runs the selected run. Results of a run are so never mixed with another model.
import { computed } from '@preact/signals';
import type { Lay, OperationStage, Scene } from '../api/types';
import { settled } from '../logic/moorings';
import { isStudy } from '../logic/runs';
import { calm, failure, scene, solution } from './live';
import { shownStage as chosenStage, stageLay as chosenLay } from './operation';
import { runLay, runScene, selected } from './runs';
import { workspace } from './workspace';

const ofStages = computed(() => workspace.value === 'operation');
const ofRuns = computed(() => workspace.value === 'storm' || workspace.value === 'runs');

export const shownRun = computed(() => (ofRuns.value && selected.value && !isStudy(selected.value) && selected.value.kind !== 'study' ? selected.value : null));
export const ofRun = computed(() => shownRun.value !== null && runLay.value !== null && runScene.value !== null);
export const shownStage = computed<OperationStage | null>(() => (ofStages.value ? chosenStage.value : null));
const stageLay = computed<Lay | null>(() => (ofStages.value ? chosenLay.value : null));

export const shownLay = computed<Lay | null>(() => (ofRun.value ? runLay.value : stageLay.value ?? solution.value));
/** The same, at the update rate of panels and diagrams. */
export const calmLay = computed<Lay | null>(() => (ofRun.value ? runLay.value : stageLay.value ?? calm.value));
/** With the vessel at its static position. */
export const shownScene = computed<Scene | null>(() => settled(ofRun.value ? runScene.value : scene.value, shownLay.value));
/** Nominal position of the vessel, the reference of its static offsets. */
export const shownDrawn = computed<number[] | null>(() => (ofRun.value ? runScene.value : scene.value)?.vessel?.pose ?? null);
export const shownFailure = computed(() => (ofRun.value || stageLay.value ? null : failure.value));
