// Files of the user's machine: a model is opened as new, data files are put into its folder.
import { post } from '../api/client';
import { openNew } from './model';
import { say, sayError } from './notices';

const isModel = (file: File): boolean => /\.ya?ml$/i.test(file.name);

/** Data files first: the model names them. */
export async function openFiles(files: readonly File[]): Promise<void> {
  try {
    for (const file of files.filter((f) => !isModel(f))) await post('data', { name: file.name, text: await file.text() });
    const model = files.find(isModel);
    if (model) await openNew(await model.text());
    say(model ? `${model.name} is open as a new, unsaved model.` : `${files.length} data file${files.length === 1 ? '' : 's'} added to the folder.`);
  } catch (error) { sayError(error); }
}

/** Files that are dropped on the page are opened. */
export function startDrop(): void {
  const hasFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes('Files') ?? false;
  addEventListener('dragover', (event) => { if (hasFiles(event)) event.preventDefault(); });
  addEventListener('drop', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    void openFiles([...event.dataTransfer!.files]);
  });
}
