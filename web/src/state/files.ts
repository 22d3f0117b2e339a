// Saving, and asking before another model takes the place of one that is not saved.
import { asking, dialog, type DialogName } from './look';
import { fileName, hasModel, save, unsaved } from './model';

export function saveNow(): void {
  if (!hasModel.value) return;
  if (fileName.value) void save(fileName.value); else dialog.value = 'saveas';
}

/** New and Open put another model in the place of this one: what is not saved is asked about first. */
export function askFor(next: DialogName): void {
  if (unsaved.value) asking.value = next; else dialog.value = next;
}
