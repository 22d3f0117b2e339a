// Vessel motion: fixed, from an RAO file, from a motion history, or harmonic.
import type { ComponentChildren } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { get } from '../api/client';
import type { Field } from '../api/types';
import type { Node } from '../logic/formTree';
import { fileLabels, hydrodynamics, motionKind, motionValue, motionLabels, type DataFile, type FileKind, type MotionKind } from '../logic/motion';
import { byPath, setKeys } from '../state/model';
import { sayError } from '../state/notices';
import { sendFile } from '../state/openFiles';

const path = 'vessel.motion';

async function write(value: unknown, key = path): Promise<void> {
  try { await setKeys([{ path: key, value }]); } catch (error) { sayError(error); }
}

/** Files of the folder and of this machine; the selection is written into the model. */
function FileRow({ kind, present }: { kind: FileKind; present: string }) {
  const [files, setFiles] = useState<DataFile[] | null>(null);
  const list = (): void => { get<{ files: DataFile[] }>('data').then((a) => setFiles(a.files)).catch(sayError); };
  useEffect(list, []);
  const named = (file: string): string => (kind === 'coupled' ? hydrodynamics(file) : file);
  const fitting = (files ?? []).filter((f) => f.kinds.includes(kind)).map((f) => named(f.name));
  const choose = (name: string): void => {
    if (!name) return;
    // other data of a floating hull are kept
    if (kind === 'coupled' && present) void write(name, `${path}.coupled.hydrodynamics`);
    else void write(motionValue(kind, name, byPath.value));
  };
  const take = async (sent: File[]): Promise<void> => {
    try {
      const taken: DataFile[] = [];
      for (const file of sent) taken.push(await sendFile(file));
      list();
      // a set of several files is recognised once all of it is there
      const { files: all } = await get<{ files: DataFile[] }>('data');
      const first = taken.map((file) => all.find((f) => f.name === file.name)).find((file) => file?.kinds.includes(kind));
      if (first) choose(named(first.name));
      else sayError(new Error(`${taken.map((file) => file.name).join(', ')}: not ${fileLabels[kind]} in a form that is read.`));
    } catch (error) { sayError(error); }
  };
  return (
    <>
      <div class="row wide">
        <label for="motion-file">file</label>
        <select id="motion-file" value={present} onChange={(e) => choose(e.currentTarget.value)}>
          {present ? null : <option value="">– choose</option>}
          {present && !fitting.includes(present) ? <option value={present}>{present}</option> : null}
          {fitting.map((f) => <option key={f} value={f}>{f}</option>)}
        </select>
      </div>
      <label class="upload">Upload… <input type="file" aria-label="Upload a file" multiple={kind !== 'history'} onChange={(e) => { const input = e.currentTarget; void take([...(input.files ?? [])]).then(() => { input.value = ''; }); }} /></label>
      {files && fitting.length === 0 && !present ? <p class="brief">No file with {fileLabels[kind]} in this folder.</p> : null}
    </>
  );
}

export function Motion({ node, show }: { node: Node<Field>; show: (n: Node<Field>) => ComponentChildren }) {
  const present = motionKind(byPath.value);
  // a kind that needs a file is only selected here until there is one
  const [wanted, setWanted] = useState<MotionKind | null>(null);
  // the kind being written into the model: its arrival does not overwrite a later selection
  const written = useRef<MotionKind | null>(null);
  useEffect(() => {
    if (present === written.current) written.current = null;
    else setWanted(null);
  }, [present]);
  const kind = wanted ?? present;
  const file = kind === 'raos' || kind === 'history' || kind === 'coupled' ? kind : null;
  const choose = (next: MotionKind): void => {
    const needsFile = next !== 'fixed' && next !== 'harmonic';
    setWanted(needsFile && next !== present ? next : null);
    if (needsFile || (next === present && !written.current)) return;
    written.current = next;
    void write(motionValue(next, '', byPath.value));
  };
  const harmonic = node.children.find((c) => c.path === `${path}.harmonic`);
  const convention = node.children.find((c) => c.path === `${path}.convention`);
  const coupled = node.children.find((c) => c.path === `${path}.coupled`);
  return (
    <>
      <div class="row wide">
        <label for="motion-kind">motion</label>
        <select id="motion-kind" value={kind ?? ''} onChange={(e) => choose(e.currentTarget.value as MotionKind)}>
          {kind === null ? <option value="">– not given</option> : null}
          {(Object.keys(motionLabels) as MotionKind[]).map((k) => <option key={k} value={k}>{motionLabels[k]}</option>)}
        </select>
      </div>
      {file ? <FileRow key={file} kind={file} present={file === present ? String(byPath.value.get(file === 'coupled' ? `${path}.coupled.hydrodynamics` : `${path}.${file}`)?.value ?? '') : ''} /> : null}
      {kind === 'coupled' && present !== 'coupled' ? <p class="brief">Mass, centre of gravity, radii of gyration and current coefficients are set to those of a box: replace them with vessel data. The hull needs moorings or station keeping.</p> : null}
      {kind === 'harmonic' && present === 'harmonic' && harmonic ? show(harmonic) : null}
      {kind === 'coupled' && present === 'coupled' && coupled ? show(coupled) : null}
      {file && file !== 'coupled' && kind === present && convention ? show(convention) : null}
    </>
  );
}
