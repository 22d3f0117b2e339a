// A mooring spread from a few inputs, written into the model.
import { useState } from 'preact/hooks';
import { ApiError } from '../api/client';
import { parseAngles, spreadChanges, spreadCounts, findSpreadErrors, usualAngles, type SpreadRequest } from '../logic/spread';
import { twin } from '../logic/units';
import { byPath, setKeys } from '../state/model';
import { dialog } from '../state/look';
import { say } from '../state/notices';
import { mode } from '../state/picture';
import { shownScene } from '../state/shown';
import { Dialog } from './Dialog';

const close = (): void => { dialog.value = null; };
const si = (path: string, fallback: number): number => byPath.value.get(path)?.si ?? fallback;

export function SpreadDialog() {
  const [request, setRequest] = useState<SpreadRequest>({ count: 8, angles: usualAngles(8), distance: '1000 m', kind: 'wire', diameter: '64 mm', tension: '300 kN', winch: true });
  const [angles, setAngles] = useState(usualAngles(8).join(', '));
  const [message, setMessage] = useState('');
  const [busy, setBusy] = useState(false);
  const errors = new Map(findSpreadErrors(request, angles).map((f) => [f.key, f.text]));
  const drawn = shownScene.value?.vessel;
  const hull = { length: si('vessel.length', drawn?.length ?? 100), beam: si('vessel.beam', drawn?.beam ?? 25), freeboard: si('vessel.depth', drawn?.height ?? 8) - si('vessel.draught', drawn?.draught ?? 5) };
  const lineCount = byPath.value.get('moorings.lines')?.count ?? 0;
  const set = (part: Partial<SpreadRequest>): void => { setMessage(''); setRequest({ ...request, ...part }); };
  const send = async (): Promise<void> => {
    setBusy(true);
    try {
      await setKeys(spreadChanges({ ...request, angles: parseAngles(angles, request.count)! }, hull, (path) => byPath.value.get(path)?.given ?? false));
      say(`${request.count} mooring lines added to the model`);
      mode.value = 'plan';
      close();
    } catch (error) {
      setMessage(error instanceof ApiError ? error.message : String(error));
      setBusy(false);
    }
  };
  const field = (key: 'distance' | 'diameter' | 'tension', name: string, title: string) => (
    <div class={`row${errors.has(key) ? ' wrong' : ''}`} title={title}>
      <label for={`m-${key}`}>{name}</label>
      <input id={`m-${key}`} value={request[key]} autocomplete="off" aria-invalid={errors.has(key)} onInput={(e) => set({ [key]: e.currentTarget.value })} />
      <span class="twin">{twin(request[key])}</span>
      {errors.has(key) ? <p class="failuretext" role="alert">{errors.get(key)}</p> : null}
    </div>
  );
  return (
    <Dialog title="Mooring spread" close={close}>
      <form class="spread" onSubmit={(e) => { e.preventDefault(); if (errors.size === 0 && !busy) void send(); }}>
        <div class="row">
          <label for="m-count">lines</label>
          <select id="m-count" autofocus value={String(request.count)} onChange={(e) => { const count = Number(e.currentTarget.value); setAngles(usualAngles(count).join(', ')); set({ count, angles: usualAngles(count) }); }}>
            {spreadCounts.map((n) => <option key={n} value={String(n)}>{n}</option>)}
          </select>
          <span class="twin" />
        </div>
        <div class={`row${errors.has('angles') ? ' wrong' : ''}`} title="Angles of one side, from the bow; the other side is its mirror image">
          <label for="m-angles">angles from the bow</label>
          <input id="m-angles" value={angles} autocomplete="off" aria-invalid={errors.has('angles')} onInput={(e) => { setMessage(''); setAngles(e.currentTarget.value); }} />
          <span class="twin">deg</span>
          {errors.has('angles') ? <p class="failuretext" role="alert">{errors.get('angles')}</p> : null}
        </div>
        {field('distance', 'anchor distance', 'Horizontal, from the fairlead')}
        <div class="row wide">
          <label for="m-kind">lines of</label>
          <select id="m-kind" value={request.kind} onChange={(e) => set({ kind: e.currentTarget.value as SpreadRequest['kind'] })}>
            <option value="wire">wire rope, wire core</option><option value="fibre">wire rope, fibre core</option><option value="chain">chain, studless</option>
          </select>
        </div>
        {field('diameter', 'diameter', 'Mass, stiffness and breaking load follow from it')}
        {field('tension', 'tension', 'At the fairlead, with the vessel at its nominal position')}
        <div class="row wide"><label for="m-winch">on winches</label><input id="m-winch" type="checkbox" checked={request.winch} onChange={(e) => set({ winch: e.currentTarget.checked })} /></div>
        <p class="brief">Fairleads are placed at the corners of the deck; all values can be edited in the form afterwards.{lineCount ? ` The ${lineCount} lines of the model are replaced; undo restores them.` : ''}</p>
        {message ? <p class="failuretext" role="alert">{message}</p> : null}
        <footer><button type="button" onClick={close}>Cancel</button><button type="submit" class="main" disabled={busy || errors.size > 0}>Apply</button></footer>
      </form>
    </Dialog>
  );
}
