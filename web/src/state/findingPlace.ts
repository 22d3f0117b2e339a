// Where a finding leads.
import type { Bullet } from '../logic/findings';
import { active, seek } from './animation';
import { pathOfName } from './findings';
import { leadTo } from './lead';
import { cursor } from './look';
import { calmLay } from './shown';
import { selectObject } from './workspace';

export const hasPlace = (b: Bullet): boolean => b.key !== '' || b.from_top !== undefined || !!(b.object && pathOfName(b.object));

/** To the key, or to the object with its place on the pipe and the time, where they are known. */
export function followFinding(b: Bullet): void {
  if (b.key) { leadTo(b.key); return; }
  const path = b.object ? pathOfName(b.object) : '';
  if (path) selectObject(path);
  // of a box at rest the finding names no place: it is where the box is
  const place = b.from_top ?? calmLay.value?.supports.find((box) => box.name === b.object)?.s;
  if (place !== undefined) cursor.value = place;
  if (b.time !== undefined && active.value) seek(b.time);
}
