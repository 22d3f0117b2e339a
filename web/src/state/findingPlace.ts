// Navigation to a finding.
import type { Bullet } from '../logic/findings';
import { active, seek } from './animation';
import { pathOfName } from './findings';
import { leadTo } from './lead';
import { cursor } from './look';
import { calmLay } from './shown';
import { selectObject } from './workspace';

export const hasPlace = (b: Bullet): boolean => b.key !== '' || b.from_top !== undefined || !!(b.object && pathOfName(b.object));

/** To the key, or to the object with its position on the pipe and the time, if known. */
export function followFinding(b: Bullet): void {
  if (b.key) { leadTo(b.key); return; }
  const path = b.object ? pathOfName(b.object) : '';
  if (path) selectObject(path);
  // a static finding of a box has no position: it is that of the box
  const place = b.from_top ?? calmLay.value?.supports.find((box) => box.name === b.object)?.s;
  if (place !== undefined) cursor.value = place;
  if (b.time !== undefined && active.value) seek(b.time);
}
