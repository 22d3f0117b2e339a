// One value of the form: as it is written in the model, and beside it the same in the other system of units.
import { useEffect, useRef, useState } from 'preact/hooks';
import { ApiError } from '../api/client';
import type { Field } from '../api/types';
import { complete, parseQuantity, twin } from '../logic/units';
import { label as nameOf, parts } from '../logic/formTree';
import { diagnostics, setKeys } from '../state/model';

function value(field: Field): string {
  return field.value === null || field.value === undefined ? '' : String(field.value);
}

export function FieldRow({ field, name }: { field: Field; name?: string }) {
  const written = value(field);
  const [typed, setTyped] = useState(written);
  const [fault, setFault] = useState('');
  // what is on its way into the model: its arrival does not take away what was typed meanwhile
  const sent = useRef<{ typed: string; value: string } | null>(null);
  useEffect(() => {
    const own = sent.current;
    sent.current = null;
    setTyped((now) => (own && written === own.value && now !== own.typed ? now : written));
    setFault('');
  }, [written, field.path]);

  const about = diagnostics.value.filter((d) => d.key === field.path);
  const told = about.find((d) => d.severity === 'error') ?? about[0];
  const message = fault || (told?.message ?? '');
  const wrong = fault !== '' || told?.severity === 'error';
  const id = `f-${field.path}`;
  const shown = name ?? nameOf(parts(field.path).at(-1)!);
  const left = field.default !== null && field.default !== undefined ? String(field.default) : field.left_out ?? (field.required ? 'required' : '');

  const send = async (text: string): Promise<void> => {
    if (text.trim() === written.trim()) { setFault(''); return; }
    let next: unknown = text.trim();
    if (next === '') next = null;
    else if (field.kind === 'quantity') {
      if (!parseQuantity(text)) { setFault('A number and a unit, like "12 m".'); return; }
      next = complete(text, parseQuantity(sent.current?.value ?? written)?.unit || field.unit);
    } else if (field.kind === 'number' || field.kind === 'integer') {
      const n = Number(text);
      if (!Number.isFinite(n)) { setFault('A number, without unit.'); return; }
      next = n;
    }
    sent.current = { typed: text, value: String(next ?? '') };
    try {
      setFault('');
      await setKeys([{ path: field.path, value: next }]);
    } catch (error) {
      sent.current = null;
      setFault(error instanceof ApiError ? error.message : String(error));
    }
  };

  const hint = [field.text, field.range ? `Range: ${field.range}.` : '', !field.given && left ? `If omitted: ${left}.` : ''].filter(Boolean).join(' ');
  const other = field.kind === 'quantity' ? twin(typed || (field.given ? '' : left)) : '';
  return (
    <div class={`row${field.kind === 'text' || field.kind === 'choice' ? ' wide' : ''}${wrong ? ' wrong' : message ? ' warned' : ''}${field.given ? '' : ' absent'}`} title={hint}>
      <label for={id}>{shown}{field.required && !field.given ? <b class="must" aria-label="required"> *</b> : null}</label>
      {field.kind === 'choice' ? (
        <select id={id} value={written} onChange={(e) => void send(e.currentTarget.value)}>
          <option value="">{left ? `– (${left})` : '–'}</option>
          {(field.choices ?? []).map((c) => <option key={c} value={c}>{c.replaceAll('_', ' ')}</option>)}
        </select>
      ) : (
        <input
          id={id} value={typed} data-written={written} placeholder={left} spellcheck={false} autocomplete="off" aria-invalid={wrong}
          onInput={(e) => setTyped(e.currentTarget.value)}
          onBlur={(e) => void send(e.currentTarget.value)}
          onKeyDown={(e) => {
            if (e.key === 'Enter') void send(e.currentTarget.value);
            if (e.key === 'Escape') { setTyped(written); setFault(''); }
          }}
        />
      )}
      <span class="twin">{other}</span>
      {message ? <p class={wrong ? 'fault' : 'note'} role={wrong ? 'alert' : undefined}>{message}</p> : null}
    </div>
  );
}
