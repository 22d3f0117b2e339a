// Saving, and the confirmation before an unsaved model is replaced.
import { asking, dialog, type DialogName } from './look';
import { fileName, hasModel, save, unsaved } from './model';

export function saveNow(): void {
  if (!hasModel.value) return;
  if (fileName.value) void save(fileName.value); else dialog.value = 'saveas';
}

/** New and Open replace the model: unsaved changes need a confirmation. */
export function askFor(next: DialogName): void {
  if (unsaved.value) asking.value = next; else dialog.value = next;
}
