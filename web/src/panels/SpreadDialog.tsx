// A spread of mooring lines from a few answers, written into the model.
import { useState } from 'preact/hooks';
import { ApiError } from '../api/client';
import { parseAngles, spreadChanges, spreadCounts, spreadFaults, usualAngles, type SpreadWish } from '../logic/spread';
import { twin } from '../logic/units';
import { byPath, setKeys } from '../state/model';
import { dialog } from '../state/look';
import { say } from '../state/notices';
import { mode } from '../state/picture';
import { shownScene } from '../state/shown';
import { Dialog } from './Dialog';

const close = (): void => { dialog.value = null; };
const si = (path: string, other: number): number => byPath.value.get(path)?.si ?? other;

export function SpreadDialog() {
  const [wish, setWish] = useState<SpreadWish>({ count: 8, angles: usualAngles(8), distance: '1000 m', kind: 'wire', diameter: '64 mm', tension: '300 kN', winch: true });
  const [angles, setAngles] = useState(usualAngles(8).join(', '));
  const [refused, setRefused] = useState('');
  const [busy, setBusy] = useState(false);
  const faults = new Map(spreadFaults(wish, angles).map((f) => [f.key, f.text]));
  const drawn = shownScene.value?.vessel;
  const hull = { length: si('vessel.length', drawn?.length ?? 100), beam: si('vessel.beam', drawn?.beam ?? 25), freeboard: si('vessel.depth', drawn?.height ?? 8) - si('vessel.draught', drawn?.draught ?? 5) };
  const there = byPath.value.get('moorings.lines')?.count ?? 0;
  const set = (part: Partial<SpreadWish>): void => { setRefused(''); setWish({ ...wish, ...part }); };
  const send = async (): Promise<void> => {
    setBusy(true);
    try {
      await setKeys(spreadChanges({ ...wish, angles: parseAngles(angles, wish.count)! }, hull, (path) => byPath.value.get(path)?.given ?? false));
      say(`${wish.count} mooring lines written into the model`);
      mode.value = 'plan';
      close();
    } catch (error) {
      setRefused(error instanceof ApiError ? error.message : String(error));
      setBusy(false);
    }
  };
  const field = (key: 'distance' | 'diameter' | 'tension', name: string, title: string) => (
    <div class={`row${faults.has(key) ? ' wrong' : ''}`} title={title}>
      <label for={`m-${key}`}>{name}</label>
      <input id={`m-${key}`} value={wish[key]} autocomplete="off" aria-invalid={faults.has(key)} onInput={(e) => set({ [key]: e.currentTarget.value })} />
      <span class="twin">{twin(wish[key])}</span>
      {faults.has(key) ? <p class="fault" role="alert">{faults.get(key)}</p> : null}
    </div>
  );
  return (
    <Dialog title="Spread of mooring lines" close={close}>
      <form class="spread" onSubmit={(e) => { e.preventDefault(); if (faults.size === 0 && !busy) void send(); }}>
        <div class="row">
          <label for="m-count">lines</label>
          <select id="m-count" autofocus value={String(wish.count)} onChange={(e) => { const count = Number(e.currentTarget.value); setAngles(usualAngles(count).join(', ')); set({ count, angles: usualAngles(count) }); }}>
            {spreadCounts.map((n) => <option key={n} value={String(n)}>{n}</option>)}
          </select>
          <span class="twin" />
        </div>
        <div class={`row${faults.has('angles') ? ' wrong' : ''}`} title="Of the lines of one side, from the bow; the other side is its mirror image">
          <label for="m-angles">angles from the bow</label>
          <input id="m-angles" value={angles} autocomplete="off" aria-invalid={faults.has('angles')} onInput={(e) => { setRefused(''); setAngles(e.currentTarget.value); }} />
          <span class="twin">deg</span>
          {faults.has('angles') ? <p class="fault" role="alert">{faults.get('angles')}</p> : null}
        </div>
        {field('distance', 'anchor distance', 'Horizontal, from the fairlead')}
        <div class="row wide">
          <label for="m-kind">lines of</label>
          <select id="m-kind" value={wish.kind} onChange={(e) => set({ kind: e.currentTarget.value as SpreadWish['kind'] })}>
            <option value="wire">wire rope, wire core</option><option value="fibre">wire rope, fibre core</option><option value="chain">chain, studless</option>
          </select>
        </div>
        {field('diameter', 'diameter', 'Mass, stiffness and breaking load follow from it')}
        {field('tension', 'tension', 'At the fairlead, with the vessel where it is drawn')}
        <div class="row wide"><label for="m-winch">on winches</label><input id="m-winch" type="checkbox" checked={wish.winch} onChange={(e) => set({ winch: e.currentTarget.checked })} /></div>
        <p class="brief">Fairleads stand at the corners of the deck; all values can be changed in the form afterwards.{there ? ` The ${there} lines of the model are replaced; undo brings them back.` : ''}</p>
        {refused ? <p class="fault" role="alert">{refused}</p> : null}
        <footer><button type="button" onClick={close}>Cancel</button><button type="submit" class="main" disabled={busy || faults.size > 0}>Write into the model</button></footer>
      </form>
    </Dialog>
  );
}
