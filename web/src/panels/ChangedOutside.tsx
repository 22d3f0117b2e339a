// Reports that another program has changed the model file, and offers both choices.
import { changedOutside, keepOwn } from '../state/disk';
import { fileName, saved, takeFile } from '../state/model';

export function ChangedOutside() {
  if (!changedOutside.value) return null;
  return (
    <div class="changedoutside" role="alert">
      <span>{fileName.value} has been changed by another program.{saved.value ? '' : ' Your changes here are not saved.'}</span>
      <button type="button" class="main" title="Undo restores your text" onClick={() => void takeFile(fileName.value)}>Reload from disk</button>
      <button type="button" onClick={keepOwn}>Keep mine</button>
    </div>
  );
}
