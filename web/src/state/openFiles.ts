// Files of the user's machine: a model is opened as new, data files are put into its folder, models of other programs are
// translated.
import { signal } from '@preact/signals';
import { post } from '../api/client';
import type { ImportAccount } from '../api/types';
import { isOrcaFlex, isYaml } from '../logic/fileKinds';
import type { DataFile } from '../logic/motion';
import { dialog } from './look';
import { openNew } from './model';
import { say, sayError } from './notices';

/** Account of the last import, for its dialog. */
export const imported = signal<{ name: string; account: ImportAccount } | null>(null);

interface Text { name: string; text: string }

/** Translates the first of the files that no other one includes. */
async function importFiles(files: readonly Text[]): Promise<void> {
  const isIncluded = (file: Text): boolean => files.some((from) => from !== file && from.text.includes(file.name));
  const first = files.find((file) => !isIncluded(file)) ?? files[0]!;
  const answer = await post<{ text: string; account: ImportAccount }>('import', { files: [first, ...files.filter((file) => file !== first)] });
  await openNew(answer.text);
  imported.value = { name: first.name, account: answer.account };
  dialog.value = 'import';
}

/** Puts a data file into the folder of the model, byte for byte. */
export async function sendFile(file: File): Promise<DataFile> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const part = 0x8000; // of the bytes, as many as arguments of a call
  let text = '';
  for (let i = 0; i < bytes.length; i += part) text += String.fromCharCode(...bytes.subarray(i, i + part));
  return post<DataFile>('data', { name: file.name, base64: btoa(text) });
}

/** Data files first: the model names them. */
export async function openFiles(files: readonly File[]): Promise<void> {
  try {
    const models = files.filter((file) => isYaml(file.name));
    const yaml = await Promise.all(models.map(async (file): Promise<Text> => ({ name: file.name, text: await file.text() })));
    for (const file of files.filter((f) => !isYaml(f.name))) await sendFile(file);
    if (yaml.some((file) => isOrcaFlex(file.text))) { await importFiles(yaml); return; }
    const model = yaml[0];
    if (model) await openNew(model.text);
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
