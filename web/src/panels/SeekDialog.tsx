// "Find a value": a result and what it shall be, a key that may change for it, and what the program finds.
import { useState } from 'preact/hooks';
import { ApiError, post } from '../api/client';
import { quantityText, relations, seekFaults, seekGoals, seekRemarks, seekRequest, startWish, usualBounds, variableKeys, type Relation, type SeekAnswer, type SeekTarget, type SeekWish } from '../logic/seek';
import { twin } from '../logic/units';
import { calm, changes } from '../state/live';
import { dialog } from '../state/look';
import { byPath, fields, setKeys } from '../state/model';
import { say } from '../state/notices';
import { openSeek, sought, type Sought } from '../state/seek';
import { Dialog } from './Dialog';

const close = (): void => { dialog.value = null; };

export function SeekButton({ goal }: { goal: SeekTarget }) {
  return <button type="button" class="tiny make" aria-label={`Make ${goal.name} …`} title={`Make ${goal.name} …: find the value of a key with which it is as wanted`} onClick={() => openSeek({ goal })}>make…</button>;
}

function Found({ answer, goal, unit }: { answer: SeekAnswer; goal: SeekTarget; unit: string }) {
  const found = answer.seek;
  if (!found) return <p class="fault" role="alert">{answer.diagnostics?.[0]?.message ?? 'The question cannot be read.'}</p>;
  const remarks = seekRemarks(found, goal, unit);
  const reached = found.goals[0]?.reached;
  return (
    <div class="found" role="status">
      {found.found && found.answer !== null
        ? <p><b>{quantityText(found.answer, unit, 6)}</b>{reached !== null && reached !== undefined ? ` makes it ${quantityText(reached, goal.unit)}` : ''} <small>({found.evaluations} models solved)</small></p>
        : <p class="fault">{found.why}</p>}
      {remarks.length ? <ul>{remarks.map((r) => <li key={r}>{r}</li>)}</ul> : null}
    </div>
  );
}

/** Results to choose from: those of the state shown, and the one that was asked for. */
function goalsWith(goal: SeekTarget): SeekTarget[] {
  const list = calm.value ? seekGoals(calm.value) : [];
  return list.some((g) => g.result === goal.result) ? list : [goal, ...list];
}

export function SeekDialog() {
  const wanted = sought.value;
  return wanted ? <SeekForm start={wanted} /> : null;
}

function SeekForm({ start }: { start: Sought }) {
  const [goal, setGoal] = useState(start.goal);
  const keys = variableKeys(fields.value, start.key);
  const [wish, setWish] = useState<SeekWish>(() => startWish(start.goal, keys.find((f) => f.path === start.key) ?? keys[0]));
  const [answer, setAnswer] = useState<SeekAnswer | null>(null);
  const [refused, setRefused] = useState('');
  const [busy, setBusy] = useState(false);
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
  const goals = goalsWith(start.goal);
  const chooseGoal = (result: string): void => {
    const next = goals.find((g) => g.result === result)!;
    setGoal(next);
    set({ value: quantityText(next.si, next.unit, 4) });
  };
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
    <Dialog title="Find a value" close={close}>
      <form class="seek" onSubmit={(e) => { e.preventDefault(); if (faults.size === 0 && !busy) void (found ? put() : solve()); }}>
        <div class="row wide">
          <label for="s-goal">make</label>
          <select id="s-goal" value={goal.result} onChange={(e) => chooseGoal(e.currentTarget.value)}>
            {goals.map((g) => <option key={g.result} value={g.result}>{g.name}, now {quantityText(g.si, g.unit, 4)}</option>)}
          </select>
        </div>
        <div class="row wide">
          <label for="s-relation">it shall be</label>
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
        {changes.value.length ? <p class="brief">Sought in the model without the values that are tried out.</p> : null}
        {busy ? <p class="brief" role="status">Solving…</p> : null}
        {answer ? <Found answer={answer} goal={goal} unit={unit} /> : null}
        {refused ? <p class="fault" role="alert">{refused}</p> : null}
        <footer><button type="button" onClick={close}>Cancel</button><button type="submit" class="main" disabled={busy || faults.size > 0}>{found ? 'Put into the model' : 'Find'}</button></footer>
      </form>
    </Dialog>
  );
}
