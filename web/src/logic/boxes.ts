// Roller boxes by their path in the model and by their name in the results.
import type { LiveBox } from './live';

interface Named { name: string; structure: string }

/** Path of a box in the model; for generated boxes the path of the row. */
export function boxPath(boxes: readonly LiveBox[], supports: readonly Named[], name: string): string {
  const known = boxes.find((box) => box.name === name);
  if (known) return known.path;
  const support = supports.find((s) => s.name === name);
  if (!support) return '';
  const listed = boxes.filter((box) => box.structure === support.structure);
  const index = supports.filter((s) => s.structure === support.structure).findIndex((s) => s.name === name);
  return listed[index]?.path ?? `supports.${support.structure}`;
}

/** Result name of the box with a path in the model; null if the path is not a box. */
export function boxName(boxes: readonly LiveBox[], supports: readonly Named[], path: string): string | null {
  const found = /^supports\.(ramp|stinger)\.boxes\[(\d+)\]/.exec(path);
  if (!found) return null;
  const [, structure, index] = found;
  const name = boxes.find((box) => box.structure === structure && box.index === Number(index))?.name;
  if (name !== undefined && supports.some((s) => s.name === name)) return name;
  return supports.filter((s) => s.structure === structure)[Number(index)]?.name ?? null;
}
