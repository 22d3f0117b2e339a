// Goal seek: a result and its target, a key that may vary, and the solution.
import { useState } from 'preact/hooks';
import { ApiError, post } from '../api/client';
import { quantityText, relations, findSeekErrors, seekGoals, seekRemarks, seekRequest, initialSeek, usualBounds, variableKeys, type Relation, type SeekAnswer, type SeekTarget, type SeekRequest } from '../logic/seek';
import { twin } from '../logic/units';
import { calm, changes } from '../state/live';
import { dialog } from '../state/look';
import { byPath, fields, setKeys } from '../state/model';
import { say } from '../state/notices';
import { openSeek, sought, type Sought } from '../state/seek';
import { Dialog } from './Dialog';

const close = (): void => { dialog.value = null; };

export function SeekButton({ goal }: { goal: SeekTarget }) {
  return <button type="button" class="tiny make" aria-label={`Goal seek: ${goal.name}`} title={`Goal seek: ${goal.name}. Find the value of a key that gives a target`} onClick={() => openSeek({ goal })}>seek…</button>;
}

function Found({ answer, goal, unit }: { answer: SeekAnswer; goal: SeekTarget; unit: string }) {
  const found = answer.seek;
  if (!found) return <p class="failuretext" role="alert">{answer.diagnostics?.[0]?.message ?? 'The request is invalid.'}</p>;
  const remarks = seekRemarks(found, goal, unit);
  const reached = found.goals[0]?.reached;
  return (
    <div class="found" role="status">
      {found.found && found.answer !== null
        ? <p><b>{quantityText(found.answer, unit, 6)}</b>{reached !== null && reached !== undefined ? ` gives ${quantityText(reached, goal.unit)}` : ''} <small>({found.evaluations} models solved)</small></p>
        : <p class="failuretext">{found.why}</p>}
      {remarks.length ? <ul>{remarks.map((r) => <li key={r}>{r}</li>)}</ul> : null}
    </div>
  );
}

/** Selectable results: those of the state shown, and the requested one. */
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
  const [request, setRequest] = useState<SeekRequest>(() => initialSeek(start.goal, keys.find((f) => f.path === start.key) ?? keys[0]));
  const [answer, setAnswer] = useState<SeekAnswer | null>(null);
  const [message, setMessage] = useState('');
  const [busy, setBusy] = useState(false);
  const unit = byPath.value.get(request.key)?.unit ?? '';
  const errors = new Map(findSeekErrors(request).map((f) => [f.key, f.text]));
  const set = (part: Partial<SeekRequest>): void => { setMessage(''); setAnswer(null); setRequest({ ...request, ...part }); };
  const attempt = async (act: () => Promise<void>): Promise<void> => {
    setBusy(true);
    try { await act(); } catch (error) { setMessage(error instanceof ApiError ? error.message : String(error)); }
    setBusy(false);
  };
  const solve = (): Promise<void> => attempt(async () => setAnswer(await post<SeekAnswer>('seek', { seek: seekRequest(request, goal, unit) })));
  const put = (): Promise<void> => attempt(async () => { await setKeys(answer!.changes!); say(`${request.key} set to ${answer!.changes![0]!.value}`); close(); });
  const goals = goalsWith(start.goal);
  const chooseGoal = (result: string): void => {
    const next = goals.find((g) => g.result === result)!;
    setGoal(next);
    set({ value: quantityText(next.si, next.unit, 4) });
  };
  const found = answer?.status === 'found';
  const field = (key: 'value' | 'from' | 'to', name: string, title: string) => (
    <div class={`row${errors.has(key) ? ' wrong' : ''}`} title={title}>
      <label for={`s-${key}`}>{name}</label>
      <input id={`s-${key}`} value={request[key]} autofocus={key === 'value'} autocomplete="off" aria-invalid={errors.has(key)} onInput={(e) => set({ [key]: e.currentTarget.value })} />
      <span class="twin">{twin(request[key])}</span>
      {errors.has(key) ? <p class="failuretext" role="alert">{errors.get(key)}</p> : null}
    </div>
  );
  return (
    <Dialog title="Goal seek" close={close}>
      <form class="seek" onSubmit={(e) => { e.preventDefault(); if (errors.size === 0 && !busy) void (found ? put() : solve()); }}>
        <div class="row wide">
          <label for="s-goal">result</label>
          <select id="s-goal" value={goal.result} onChange={(e) => chooseGoal(e.currentTarget.value)}>
            {goals.map((g) => <option key={g.result} value={g.result}>{g.name}, at present {quantityText(g.si, g.unit, 4)}</option>)}
          </select>
        </div>
        <div class="row wide">
          <label for="s-relation">target</label>
          <select id="s-relation" value={request.relation} onChange={(e) => set({ relation: e.currentTarget.value as Relation })}>
            {relations.map(([id, label]) => <option key={id} value={id}>{label}</option>)}
          </select>
        </div>
        {field('value', 'value', `Target of ${goal.result}`)}
        <div class="row wide">
          <label for="s-key">key to vary</label>
          <select id="s-key" value={request.key} onChange={(e) => { const key = e.currentTarget.value; set({ key, ...usualBounds(byPath.value.get(key)) }); }}>
            {keys.map((f) => <option key={f.path} value={f.path}>{f.path}</option>)}
          </select>
        </div>
        {field('from', 'from', 'Lower bound')}
        {field('to', 'to', 'Upper bound')}
        {changes.value.length ? <p class="brief">The trial values are not used in the search.</p> : null}
        {busy ? <p class="brief" role="status">Solving…</p> : null}
        {answer ? <Found answer={answer} goal={goal} unit={unit} /> : null}
        {message ? <p class="failuretext" role="alert">{message}</p> : null}
        <footer><button type="button" onClick={close}>Cancel</button><button type="submit" class="main" disabled={busy || errors.size > 0}>{found ? 'Apply' : 'Find'}</button></footer>
      </form>
    </Dialog>
  );
}
