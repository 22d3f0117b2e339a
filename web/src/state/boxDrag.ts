// A roller box dragged in the elevation: statics follow, and its final position is one undo step.
import { batch, signal } from '@preact/signals';
import { liveChanges, type LiveBox, type LiveValues } from '../logic/live';
import { convertLike } from '../logic/units';
import { boxHeight, stingerRadius } from '../logic/variables';
import { applyLive, base, changes, setLive, values } from './live';
import { byPath, setKeys } from './model';
import { sayError } from './notices';
import { ofRun, shownStage } from './shown';

/** Displacement of the box since the beginning of the drag [m]. */
export interface BoxDrag { name: string; x: number; z: number }

export const boxDrag = signal<BoxDrag | null>(null);

/** Null if the box cannot be moved: generated in a row, or from a run or stage. */
export const movableBox = (name: string): LiveBox | null =>
  (ofRun.value || shownStage.value ? null : base.value.boxes.find((box) => box.name === name) ?? null);

const keys = (box: LiveBox): [x: string, z: string] => [`${box.path}.x`, `${box.path}.z`];

/** Position of the box with the trial values [m]. */
function place(box: LiveBox): { x: number; z: number } {
  const [x, z] = keys(box).map((key, i) => { const change = changes.value.find((c) => c.path === key); return change ? Number.parseFloat(String(change.value)) : i === 0 ? box.x : box.z; });
  return { x: x!, z: z! };
}

/** Beginning of the drag, and the trial values of the two keys before it. */
let start = { x: 0, z: 0 }, before: (number | undefined)[] = [];

export function beginDrag(name: string): void {
  const box = movableBox(name);
  if (!box) return;
  before = keys(box).map((key) => values.value[key]);
  start = place(box);
  boxDrag.value = { name, x: 0, z: 0 };
}

export function dragTo(x: number, z: number): void {
  const drag = boxDrag.value, box = drag && movableBox(drag.name);
  if (!drag || !box) return;
  const [xKey, zKey] = keys(box);
  batch(() => {
    boxDrag.value = { ...drag, x, z };
    setLive(xKey, start.x + x);
    setLive(zKey, start.z + z);
  });
}

function putBack(box: LiveBox): void {
  batch(() => keys(box).forEach((key, i) => setLive(key, before[i])));
}

export function cancelDrag(): void {
  const box = boxDrag.value && movableBox(boxDrag.value.name);
  boxDrag.value = null;
  if (box) putBack(box);
}

export async function endDrag(): Promise<void> {
  const drag = boxDrag.value, box = drag && movableBox(drag.name);
  boxDrag.value = null;
  if (!box) return;
  if (drag.x === 0 && drag.z === 0) { putBack(box); return; }
  // a trial radius or height also moves the boxes: all changes are written together
  if (values.value[stingerRadius] !== undefined || values.value[boxHeight] !== undefined) { await applyLive(); return; }
  const trial: LiveValues = Object.fromEntries(keys(box).flatMap((key) => { const value = values.value[key]; return value === undefined ? [] : [[key, value]]; }));
  const list = liveChanges(base.value, trial).map((c) => ({ path: c.path, value: convertLike(String(c.value), String(byPath.value.get(c.path)?.value ?? '')) }));
  try {
    await setKeys(list, () => keys(box).forEach((key) => setLive(key, undefined)));
  } catch (error) { putBack(box); sayError(error); }
}
