// Selection of a key to pin, and the range of its slider.
import { signal } from '@preact/signals';
import { useState } from 'preact/hooks';
import { SearchField } from '../components/SearchField';
import type { SearchEntry } from '../logic/search';
import { complete, parseQuantity } from '../logic/units';
import { boxHeight, currentFactor, findVariable, stingerRadius, variableFields, variableName, variableText, type Variable } from '../logic/variables';
import { base } from '../state/live';
import { fields } from '../state/model';
import { addPin, isPinned, setPinEnds, sliders } from '../state/pins';
import { Dialog } from './Dialog';

const searching = signal(false);
const editing = signal('');
export function openPinSearch(): void { searching.value = true; }
export function openPinEnds(id: string): void { editing.value = id; }

function pinEntries(): SearchEntry[] {
  const several = [stingerRadius, currentFactor, boxHeight].map((id) => findVariable(id, base.value)).filter((v): v is Variable => v !== null)
    .map((v) => ({ id: v.id, name: v.name, detail: variableText(v, v.si), kind: 'key' as const, weight: 2 }));
  const keys = variableFields(fields.value).map((field) => ({
    id: field.path,
    name: variableName(field.path, base.value.fields),
    more: field.path,
    detail: String(field.value ?? field.default ?? ''),
    kind: 'key' as const,
    weight: field.given ? 2 : 0,
  }));
  return [...several, ...keys].filter((entry) => !isPinned(entry.id));
}

export function PinSearch() {
  if (!searching.value) return null;
  const close = (): void => { searching.value = false; };
  return (
    <Dialog title="Pin a key" close={close}>
      <SearchField id="find-pin" label="Key to pin" placeholder="tension, wall thickness, stinger 3 z …" entries={pinEntries} inline kinds={false} choose={(entry) => { addPin(entry.id); close(); }} />
    </Dialog>
  );
}

export function PinEnds() {
  const slider = sliders.value.find((s) => s.variable.id === editing.value);
  return slider ? <EndsForm key={editing.value} variable={slider.variable} low={slider.low} high={slider.high} /> : null;
}

function EndsForm({ variable, low, high }: { variable: Variable; low: number; high: number }) {
  const [from, setFrom] = useState(variableText(variable, low));
  const [to, setTo] = useState(variableText(variable, high));
  const close = (): void => { editing.value = ''; };
  const si = (text: string): number => {
    const q = parseQuantity(complete(text, variable.unit));
    return q && q.unit === variable.unit ? q.number * variable.scale : Number.NaN;
  };
  const wrong = !(si(from) < si(to));
  const field = (id: string, name: string, value: string, set: (text: string) => void) => (
    <div class="row">
      <label for={id}>{name}</label>
      <input id={id} value={value} autocomplete="off" aria-invalid={wrong} onInput={(e) => set(e.currentTarget.value)} />
    </div>
  );
  return (
    <Dialog title={`Slider range: ${variable.name}`} close={close}>
      <form onSubmit={(e) => { e.preventDefault(); if (!wrong) { setPinEnds(variable.id, [si(from), si(to)]); close(); } }}>
        {field('ends-from', 'from', from, setFrom)}
        {field('ends-to', 'to', to, setTo)}
        {wrong ? <p class="failuretext" role="alert">Two numbers in {variable.unit || 'the unit of the key'}, in ascending order.</p> : null}
        <footer>
          <button type="button" onClick={() => { setPinEnds(variable.id, undefined); close(); }}>Default range</button>
          <button type="submit" class="main" disabled={wrong}>Set</button>
        </footer>
      </form>
    </Dialog>
  );
}
