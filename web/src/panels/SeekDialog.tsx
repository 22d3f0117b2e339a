// "Make this ...": a value for a result, a key that may change for it, and what the program finds.
import { signal } from '@preact/signals';
import { useState } from 'preact/hooks';
import { ApiError, post } from '../api/client';
import { relations, seekFaults, seekRemarks, seekRequest, startWish, usualBounds, variableKeys, type Relation, type SeekAnswer, type SeekTarget, type SeekWish } from '../logic/seek';
import { twin, write } from '../logic/units';
import { dialog } from '../state/look';
import { byPath, fields, setKeys } from '../state/model';
import { say } from '../state/notices';
import { Dialog } from './Dialog';

const target = signal<SeekTarget | null>(null);
const close = (): void => { dialog.value = null; };

export function SeekButton({ goal }: { goal: SeekTarget }) {
  return <button type="button" class="tiny make" aria-label={`Make ${goal.name} …`} title={`Make ${goal.name} …: find the value of a key with which it is as wanted`} onClick={() => { target.value = goal; dialog.value = 'seek'; }}>make…</button>;
}

function Found({ answer, unit }: { answer: SeekAnswer; unit: string }) {
  const found = answer.seek;
  if (!found) return <p class="fault" role="alert">{answer.diagnostics?.[0]?.message ?? 'The question cannot be read.'}</p>;
  const remarks = seekRemarks(found, target.value!, unit);
  const reached = found.goals[0]?.reached;
  return (
    <div class="found" role="status">
      {found.found && found.answer !== null
        ? <p><b>{unit ? write(found.answer, unit, 6) : found.answer}</b>{reached !== null && reached !== undefined ? ` makes it ${write(reached, target.value!.unit, 5)}` : ''} <small>({found.evaluations} models solved)</small></p>
        : <p class="fault">{found.why}</p>}
      {remarks.length ? <ul>{remarks.map((r) => <li key={r}>{r}</li>)}</ul> : null}
    </div>
  );
}

export function SeekDialog() {
  const goal = target.value;
  const keys = variableKeys(fields.value);
  const [wish, setWish] = useState<SeekWish>(() => startWish(goal!, keys[0]));
  const [answer, setAnswer] = useState<SeekAnswer | null>(null);
  const [refused, setRefused] = useState('');
  const [busy, setBusy] = useState(false);
  if (!goal) return null;
  const unit = byPath.value.get(wish.key)?.unit ?? '';
  const faults = new Map(seekFaults(wish).map((f) => [f.key, f.text]));
  const set = (part: Partial<SeekWish>): void => { setRefused(''); setAnswer(null); setWish({ ...wish, ...part }); };
  const attempt = async (act: () => Promise<void>): Promise<void> => {
    setBusy(true);
    try { await act(); } catch (error) { setRefused(error instanceof ApiError ? error.message : String(error)); }
    setBusy(false);
  };
  const solve = (): Promise<void> => attempt(async () => setAnswer(await post<SeekAnswer>('seek', { seek: seekRequest(wish, goal, unit) })));
  const put = (): Promise<void> => attempt(async () => { await setKeys(answer!.changes!); say(`${wish.key} is ${answer!.changes![0]!.value}`); close(); });
  const found = answer?.status === 'found';
  const field = (key: 'value' | 'from' | 'to', name: string, title: string) => (
    <div class={`row${faults.has(key) ? ' wrong' : ''}`} title={title}>
      <label for={`s-${key}`}>{name}</label>
      <input id={`s-${key}`} value={wish[key]} autofocus={key === 'value'} autocomplete="off" aria-invalid={faults.has(key)} onInput={(e) => set({ [key]: e.currentTarget.value })} />
      <span class="twin">{twin(wish[key])}</span>
      {faults.has(key) ? <p class="fault" role="alert">{faults.get(key)}</p> : null}
    </div>
  );
  return (
    <Dialog title={`Make ${goal.name} …`} close={close}>
      <form class="seek" onSubmit={(e) => { e.preventDefault(); if (faults.size === 0 && !busy) void (found ? put() : solve()); }}>
        <div class="row wide">
          <label for="s-relation">make it</label>
          <select id="s-relation" value={wish.relation} onChange={(e) => set({ relation: e.currentTarget.value as Relation })}>
            {relations.map(([id, words]) => <option key={id} value={id}>{words}</option>)}
          </select>
        </div>
        {field('value', 'value', `Wanted for ${goal.result}`)}
        <div class="row wide">
          <label for="s-key">by changing</label>
          <select id="s-key" value={wish.key} onChange={(e) => { const key = e.currentTarget.value; set({ key, ...usualBounds(byPath.value.get(key)) }); }}>
            {keys.map((f) => <option key={f.path} value={f.path}>{f.path}</option>)}
          </select>
        </div>
        {field('from', 'from', 'Lower bound')}
        {field('to', 'to', 'Upper bound')}
        {busy ? <p class="brief" role="status">Solving…</p> : null}
        {answer ? <Found answer={answer} unit={unit} /> : null}
        {refused ? <p class="fault" role="alert">{refused}</p> : null}
        <footer><button type="button" onClick={close}>Cancel</button><button type="submit" class="main" disabled={busy || faults.size > 0}>{found ? 'Put into the model' : 'Find'}</button></footer>
      </form>
    </Dialog>
  );
}
