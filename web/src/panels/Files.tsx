// Open, save as, and the choice between two tabs that changed the model.
import { useEffect, useState } from 'preact/hooks';
import { get, transport } from '../api/client';
import { differences } from '../logic/differences';
import { conflict, fileName, info, keepMine, openExample, openFile, overwrite, save, takeFile, takeTheirs, title } from '../state/model';
import { asking, dialog } from '../state/look';
import { sayError } from '../state/notices';
import { openFiles } from '../state/openFiles';
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
      <label class="upload">From this computer … <input type="file" aria-label="Open files of this computer" multiple onChange={(e) => { const files = [...(e.currentTarget.files ?? [])]; close(); void openFiles(files); }} /></label>
      <h3>{transport.local ? 'Files kept in this browser' : `Files in ${list?.folder ?? '…'}`}</h3>
      {transport.local ? <p class="brief">Models and results stay in this browser; nothing is sent anywhere. They are lost when its data are cleared: download what must last.</p> : null}
      {list && list.files.length === 0 ? <p class="empty">No model files yet.</p> : null}
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
  const exists = list?.files.some((f) => f.name === full) && full !== fileName.value;
  return (
    <Dialog title="Save as" close={close}>
      <form onSubmit={(e) => { e.preventDefault(); if (good) void save(full.trim()).then((done) => { if (done || overwrite.value) close(); }); }}>
        <div class="row"><label for="save-name">file name</label><input id="save-name" value={name} onInput={(e) => setName(e.currentTarget.value)} /><span class="twin" /></div>
        <p class="brief">{good ? (exists ? `${full} already exists. Both texts are shown before it is replaced.` : transport.local ? 'kept in this browser' : `in ${list?.folder ?? ''}`) : 'The name must not contain slashes.'}</p>
        <footer><button type="button" onClick={close}>Cancel</button><button type="submit" class="main" disabled={!good}>Save</button></footer>
      </form>
    </Dialog>
  );
}

export function ConflictDialog() {
  if (!conflict.value) return null;
  return (
    <Dialog title="Two tabs have changed this model" close={() => { void takeTheirs(); }}>
      <p>Another tab has changed the model in the meantime. Your last change in this tab has not been applied.</p>
      <footer>
        <button type="button" onClick={() => void keepMine()}>Keep mine, discard the other</button>
        <button type="button" class="main" onClick={() => void takeTheirs()}>Use the newer</button>
      </footer>
    </Dialog>
  );
}

/** New and Open with unsaved changes. */
export function UnsavedDialog() {
  const next = asking.value;
  if (!next) return null;
  const stay = (): void => { asking.value = null; };
  const go = (): void => { asking.value = null; dialog.value = next; };
  const keep = (): void => {
    if (!fileName.value) { asking.value = null; dialog.value = 'saveas'; return; }
    void save(fileName.value).then((done) => { if (done) go(); else stay(); });
  };
  return (
    <Dialog title="Changes are not saved" close={stay}>
      <p><b>{title.value}</b> has unsaved changes. {next === 'start' ? 'A new model' : 'Opening another model'} replaces it.</p>
      <footer>
        <button type="button" onClick={stay}>Cancel</button>
        <button type="button" class="danger" onClick={go}>Continue without saving</button>
        <button type="button" class="main" onClick={keep}>{fileName.value ? 'Save first' : 'Save as…'}</button>
      </footer>
    </Dialog>
  );
}

/** Save found a changed file on disk: both texts are shown. */
export function OverwriteDialog() {
  const o = overwrite.value;
  if (!o) return null;
  const close = (): void => { overwrite.value = null; };
  const isOwnFile = o.name === fileName.value;
  const rows = differences(o.theirs, o.mine);
  return (
    <Dialog title={isOwnFile ? `${o.name} has changed on disk` : `${o.name} already exists`} close={close} wide>
      <p>{isOwnFile ? 'Another program has changed the file since it was read.' : 'The folder already contains a file of that name.'} Nothing has been written. Differing lines:</p>
      <div class="compare" role="table" aria-label="The two texts">
        <div class="heads" role="row"><b role="columnheader">on disk</b><b role="columnheader">in this tab</b></div>
        {rows.map((r, i) => (r.gap ? <div key={i} class="gap">…</div> : <div key={i} role="row" class={r.left === r.right ? '' : 'differs'}><code role="cell">{r.left ?? ''}</code><code role="cell">{r.right ?? ''}</code></div>))}
      </div>
      <footer>
        <button type="button" onClick={close}>Cancel</button>
        <button type="button" onClick={() => { close(); dialog.value = 'saveas'; }}>Save under another name…</button>
        <button type="button" onClick={() => void takeFile(o.name)}>Reload from disk</button>
        <button type="button" class="danger" onClick={() => void save(o.name, o.version)}>Replace the file</button>
      </footer>
    </Dialog>
  );
}
