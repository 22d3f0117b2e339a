// Open, save as, and the question which of two tabs is right.
import { useEffect, useState } from 'preact/hooks';
import { get } from '../api/client';
import { conflict, fileName, info, keepMine, openExample, openFile, save, takeTheirs } from '../state/model';
import { dialog } from '../state/look';
import { sayError } from '../state/notices';
import { Dialog } from './Dialog';

interface Listing { folder: string; files: { name: string; modified: number }[] }

function useFiles(): Listing | null {
  const [list, setList] = useState<Listing | null>(null);
  useEffect(() => { get<Listing>('files').then(setList).catch(sayError); }, []);
  return list;
}

const close = (): void => { dialog.value = null; };

export function OpenDialog() {
  const list = useFiles();
  return (
    <Dialog title="Open" close={close}>
      <h3>Files in {list?.folder ?? '…'}</h3>
      {list && list.files.length === 0 ? <p class="empty">No model files there.</p> : null}
      <ul class="filelist">{(list?.files ?? []).map((f) => <li key={f.name}><button type="button" onClick={() => { close(); void openFile(f.name); }}><b>{f.name}</b><span class="brief">{new Date(f.modified * 1000).toLocaleString()}</span></button></li>)}</ul>
      <h3>Examples</h3>
      <ul class="filelist">{(info.value?.examples ?? []).map((x) => <li key={x.name}><button type="button" onClick={() => { close(); void openExample(x.name); }}><b>{x.title || x.name}</b><span class="brief">{x.name}</span></button></li>)}</ul>
    </Dialog>
  );
}

export function SaveAsDialog() {
  const list = useFiles();
  const [name, setName] = useState(fileName.value || 'model.yaml');
  const full = /\.ya?ml$/i.test(name) ? name : `${name}.yaml`;
  const good = /^[^/\\:*?"<>|]+$/.test(name.trim()) && !name.startsWith('.');
  const there = list?.files.some((f) => f.name === full) && full !== fileName.value;
  return (
    <Dialog title="Save as" close={close}>
      <form onSubmit={(e) => { e.preventDefault(); if (good) void save(full.trim()).then((done) => { if (done) close(); }); }}>
        <div class="row"><label for="save-name">file name</label><input id="save-name" value={name} onInput={(e) => setName(e.currentTarget.value)} /><span class="twin" /></div>
        <p class="brief">{good ? (there ? `${full} is there already and will be replaced.` : `in ${list?.folder ?? ''}`) : 'A name without slashes.'}</p>
        <footer><button type="button" onClick={close}>Cancel</button><button type="submit" class="main" disabled={!good}>{there ? 'Replace' : 'Save'}</button></footer>
      </form>
    </Dialog>
  );
}

export function ConflictDialog() {
  if (!conflict.value) return null;
  return (
    <Dialog title="Two tabs have changed this model" close={() => { void takeTheirs(); }}>
      <p>Another tab changed the model after this one last saw it. Your last change here has not been stored.</p>
      <footer>
        <button type="button" onClick={() => void keepMine()}>Keep mine, replace the other</button>
        <button type="button" class="main" onClick={() => void takeTheirs()}>Take the newer</button>
      </footer>
    </Dialog>
  );
}
