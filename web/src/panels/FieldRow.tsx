// A value of the form: as written in the model, and converted to the other unit system. A number is
// varied by dragging its label or with the arrow keys, and has a menu.
import { useRef, useState } from 'preact/hooks';
import { ApiError } from '../api/client';
import type { Field } from '../api/types';
import { complete, parseQuantity, twin } from '../logic/units';
import { label as fieldLabel, parts } from '../logic/formTree';
import { diagnostics, newerChosen, setKeys } from '../state/model';
import { openFieldMenu } from './FieldMenu';
import { useUpdate } from './useUpdate';
import { useVariation } from './variation';
import '../styles/numbers.css';

function value(field: Field): string {
  return field.value === null || field.value === undefined ? '' : String(field.value);
}

interface Sent { typed: string; value: string; answered: boolean }

export function FieldRow({ field, name }: { field: Field; name?: string }) {
  const written = value(field);
  const [typed, setTyped] = useState(written);
  const [problem, setProblem] = useState('');
  // Values sent to the model, in order, until the model shows them: their arrival must not overwrite text typed meanwhile.
  const sent = useRef<Sent[]>([]);
  useUpdate(() => {
    const index = sent.current.findIndex((s) => s.value === written);
    const arrived = sent.current[index];
    const later = arrived ? sent.current.slice(index + 1) : [];
    sent.current = later;
    setTyped((current) => (arrived && (later.length > 0 || current !== arrived.typed) ? current : written));
    setProblem('');
  }, [written, field.path]);
  useUpdate(() => { sent.current = []; setTyped(written); setProblem(''); }, [newerChosen.value]);

  const variation = useVariation(field);
  const shownText = variation.text ?? typed;

  const about = diagnostics.value.filter((d) => d.key === field.path);
  const diagnostic = about.find((d) => d.severity === 'error') ?? about[0];
  const message = problem || (diagnostic?.message ?? '');
  const wrong = problem !== '' || diagnostic?.severity === 'error';
  const id = `f-${field.path}`;
  const shown = name ?? fieldLabel(parts(field.path).at(-1)!);
  const left = field.default !== null && field.default !== undefined ? String(field.default) : field.left_out ?? (field.required ? 'required' : '');

  const send = async (text: string): Promise<void> => {
    const last = sent.current.findLast((s) => !s.answered);
    if (last ? text === last.typed : text.trim() === written.trim()) { setProblem(''); return; }
    let next: unknown = text.trim();
    if (next === '') next = null;
    else if (field.kind === 'quantity') {
      if (!parseQuantity(text)) { setProblem('Enter a number with a unit, for example 12 m.'); return; }
      next = complete(text, parseQuantity(last?.value ?? written)?.unit || field.unit);
    } else if (field.kind === 'number' || field.kind === 'integer') {
      const n = Number(text);
      if (!Number.isFinite(n)) { setProblem('Enter a number without unit.'); return; }
      next = n;
    }
    const entry: Sent = { typed: text, value: String(next ?? ''), answered: false };
    const drop = (): void => { sent.current = sent.current.filter((s) => s !== entry); };
    sent.current.push(entry);
    try {
      setProblem('');
      if (await setKeys([{ path: field.path, value: next }])) entry.answered = true;
      else drop();
    } catch (error) {
      drop();
      setProblem(error instanceof ApiError ? error.message : String(error));
    }
  };

  const hint = [field.text, field.range ? `Range: ${field.range}.` : '', !field.given && left ? `If omitted: ${left}.` : ''].filter(Boolean).join(' ');
  const converted = field.kind === 'quantity' ? twin(shownText || (field.given ? '' : left)) : '';
  const menuAtKey = (event: KeyboardEvent & { currentTarget: HTMLElement }): boolean => {
    if (event.key !== 'ContextMenu' && !(event.key === 'F10' && event.shiftKey)) return false;
    event.preventDefault();
    const box = event.currentTarget.getBoundingClientRect();
    openFieldMenu(field, shown, box.left, box.bottom);
    return true;
  };
  const keys = (event: KeyboardEvent & { currentTarget: HTMLInputElement }): void => {
    if (variation.key(event) || menuAtKey(event)) return;
    if (event.key === 'Enter' && !variation.commit(true)) void send(event.currentTarget.value);
    if (event.key === 'Escape' && !variation.cancel()) { setTyped(written); setProblem(''); }
  };
  return (
    <div class={`row${variation.able ? ' number' : ''}${variation.text === null ? '' : ' varied'}${field.kind === 'text' || field.kind === 'choice' ? ' wide' : ''}${wrong ? ' wrong' : message ? ' warned' : ''}${field.given ? '' : ' absent'}`} title={hint}>
      <label
        for={id}
        title={variation.able ? `${hint} Drag to vary: Shift coarse, Alt fine, Esc resets.`.trim() : undefined}
        onContextMenu={(e) => { e.preventDefault(); openFieldMenu(field, shown, e.clientX, e.clientY); }}
        {...variation.label}
      >
        {shown}{field.required && !field.given ? <b class="must" aria-label="required"> *</b> : null}
      </label>
      {field.kind === 'choice' ? (
        <select id={id} value={written} onChange={(e) => void send(e.currentTarget.value)}>
          <option value="">{left ? `– (${left})` : '–'}</option>
          {written && !(field.choices ?? []).includes(written) ? <option value={written}>{written}</option> : null}
          {(field.choices ?? []).map((c) => <option key={c} value={c}>{c.replaceAll('_', ' ')}</option>)}
        </select>
      ) : (
        <input
          id={id}
          value={shownText}
          data-written={variation.text ?? written}
          placeholder={left}
          spellcheck={false}
          autocomplete="off"
          aria-invalid={wrong}
          onInput={(e) => { const text = e.currentTarget.value; variation.cancel(); setTyped(text); }}
          onBlur={(e) => { if (!variation.commit() && variation.text === null) void send(e.currentTarget.value); }}
          onKeyDown={keys}
        />
      )}
      <button
        type="button"
        class="tiny more"
        tabIndex={-1}
        aria-label={`Commands of ${shown}`}
        title="Commands (Shift+F10 in the field)"
        aria-haspopup="menu"
        onClick={(e) => { const box = e.currentTarget.getBoundingClientRect(); openFieldMenu(field, shown, box.left, box.bottom); }}
      >
        ⋯
      </button>
      <span class="twin" title={converted}>{converted}</span>
      {message ? <p class={wrong ? 'failuretext' : 'note'} role={wrong ? 'alert' : undefined}>{message}</p> : null}
    </div>
  );
}
