// Files of the program within the page, kept by the browser (IndexedDB): nothing is sent anywhere.
import type { FileChange } from './engine.worker';

const store = 'files';

function open(): Promise<IDBDatabase> {
  return new Promise((done, fail) => {
    const request = indexedDB.open('overbend', 1);
    request.onupgradeneeded = () => request.result.createObjectStore(store);
    request.onsuccess = () => done(request.result);
    request.onerror = () => fail(request.error ?? new Error('The browser keeps no files for this page.'));
  });
}

let database: Promise<IDBDatabase> | null = null;
const opened = (): Promise<IDBDatabase> => (database ??= open());

/** Returns all files by their paths; none if the browser keeps nothing for this page. */
export async function readFiles(): Promise<FileChange[]> {
  try {
    const files = (await opened()).transaction(store).objectStore(store);
    const [keys, values] = [files.getAllKeys(), files.getAll()];
    await new Promise((done, fail) => { values.onsuccess = done; values.onerror = fail; });
    return keys.result.map((path, i) => ({ path: String(path), bytes: values.result[i] as Uint8Array }));
  } catch {
    return [];
  }
}

/** Writes or removes files, in one transaction. Rejects if the browser keeps nothing or its space is full. */
export async function writeFiles(changes: FileChange[]): Promise<void> {
  const transaction = (await opened()).transaction(store, 'readwrite');
  const files = transaction.objectStore(store);
  for (const { path, bytes } of changes) bytes ? files.put(bytes, path) : files.delete(path);
  await new Promise<void>((done, fail) => {
    transaction.oncomplete = () => done();
    transaction.onabort = transaction.onerror = () => fail(transaction.error ?? new Error('The browser has no space left for this page.'));
  });
}
