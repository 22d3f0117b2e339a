// A roller box that is dragged in the side view: statics follow, and on release its place is written as one step of undo.
import { batch, signal } from '@preact/signals';
import { liveChanges, type LiveBox, type LiveValues } from '../logic/live';
import { inUnitOf } from '../logic/units';
import { boxHeight, stingerRadius } from '../logic/variables';
import { applyLive, base, changes, setLive, values } from './live';
import { byPath, setKeys } from './model';
import { sayError } from './notices';
import { ofRun, shownStage } from './shown';

/** Move of the box from where it lay when the drag began [m]. */
export interface BoxDrag { name: string; x: number; z: number }

export const boxDrag = signal<BoxDrag | null>(null);

/** Null where the box cannot be moved: generated in a row, or of a run or stage. */
export const movableBox = (name: string): LiveBox | null =>
  (ofRun.value || shownStage.value ? null : base.value.boxes.find((box) => box.name === name) ?? null);

const keys = (box: LiveBox): [x: string, z: string] => [`${box.path}.x`, `${box.path}.z`];

/** Where the box lies with what is tried out [m]. */
function place(box: LiveBox): { x: number; z: number } {
  const [x, z] = keys(box).map((key, i) => { const change = changes.value.find((c) => c.path === key); return change ? Number.parseFloat(String(change.value)) : i === 0 ? box.x : box.z; });
  return { x: x!, z: z! };
}

/** Where the drag began, and what was tried out for the two keys before. */
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
  // a radius or height that is tried out moves the boxes as well: all is written together
  if (values.value[stingerRadius] !== undefined || values.value[boxHeight] !== undefined) { await applyLive(); return; }
  const own: LiveValues = Object.fromEntries(keys(box).flatMap((key) => { const value = values.value[key]; return value === undefined ? [] : [[key, value]]; }));
  const list = liveChanges(base.value, own).map((c) => ({ path: c.path, value: inUnitOf(String(c.value), String(byPath.value.get(c.path)?.value ?? '')) }));
  try {
    await setKeys(list, () => keys(box).forEach((key) => setLive(key, undefined)));
  } catch (error) { putBack(box); sayError(error); }
}
