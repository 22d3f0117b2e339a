// Varied keys of a study, a row for each: its unit, the value of the model, a range or a list of values.
import { useState } from 'preact/hooks';
import { variableKeys } from '../../logic/seek';
import { axisCount, emptyAxis, firstAxis, tenthAxis, type AxisRequest } from '../../logic/studyFile';
import { byPath, fields } from '../../state/model';
import { kind, modelKeys, setStudy, request } from '../../state/studies';

/** Keys of the sea are only for dynamic analyses. */
function offered(): string[] {
  const sea = fields.value.filter((f) => /^environment\.waves(\[\d+\])?\.(hs|tp|tz|from|height|period)$/.test(f.path)).map((f) => f.path);
  return [...new Set([...variableKeys(fields.value).map((f) => f.path), ...sea])];
}

/** With values about that of the model: a tenth down and up for one key at a time. */
const newAxis = (key: string): AxisRequest => {
  const field = byPath.value.get(key);
  const axis = kind.value === 'each' ? tenthAxis(field) : firstAxis(field);
  return axis.key ? axis : emptyAxis(key);
};

function setAxis(index: number, part: Partial<AxisRequest>): void {
  setStudy({ axes: request.value.axes.map((axis, i) => (i === index ? { ...axis, ...part } : axis)) });
}

function rename(index: number, key: string): void {
  const axis = request.value.axes[index]!;
  const untouched = !axis.list && (!axis.from || axis.from === newAxis(axis.key).from);
  setAxis(index, untouched && byPath.value.has(key) ? newAxis(key) : { key });
}

function Row({ axis, index }: { axis: AxisRequest; index: number }) {
  const number = index + 1, listed = axis.list.trim() !== '', values = axisCount(axis);
  const cell = (part: 'from' | 'to' | 'count', name: string) => (
    <td class={listed ? 'unused' : undefined}>
      <input
        aria-label={`Key ${number}, ${name}`} value={axis[part]} autocomplete="off" inputMode={part === 'count' ? 'numeric' : undefined}
        onInput={(e) => setAxis(index, { [part]: e.currentTarget.value })}
      />
    </td>
  );
  return (
    <tr>
      <td class="key">
        <input
          aria-label={`Key ${number}`} list="study-keys" placeholder="key of the model" value={axis.key} autocomplete="off" spellcheck={false}
          onInput={(e) => rename(index, e.currentTarget.value)}
        />
      </td>
      <td class="soft">{modelKeys.unit(axis.key) || '–'}</td>
      <td class="soft">{modelKeys.value(axis.key) || '–'}</td>
      {cell('from', 'from')}{cell('to', 'to')}{cell('count', 'count')}
      <td class="list">
        <input
          aria-label={`Values of key ${number}`} placeholder="or a list: 1, 1.5, 2" value={axis.list} autocomplete="off"
          onInput={(e) => setAxis(index, { list: e.currentTarget.value })}
        />
      </td>
      <td class="soft number">{values || ''}</td>
      <td>
        <button type="button" class="tiny" aria-label={`Remove key ${number}`} onClick={() => setStudy({ axes: request.value.axes.filter((_, k) => k !== index) })}>✕</button>
      </td>
    </tr>
  );
}

function AddKey() {
  const [text, setText] = useState('');
  const add = (field: HTMLInputElement): void => {
    const key = field.value.trim();
    field.value = '';  // the state may already be empty, and the field would keep its text
    setText('');
    setStudy({ axes: [...request.value.axes, newAxis(key)] });
  };
  return (
    <input
      aria-label="Add a key" list="study-keys" placeholder="add a key: search …" value={text} autocomplete="off" spellcheck={false}
      onInput={(e) => { if (byPath.value.has(e.currentTarget.value)) add(e.currentTarget); else setText(e.currentTarget.value); }}
      onKeyDown={(e) => { if (e.key === 'Enter' && text.trim()) { e.preventDefault(); add(e.currentTarget); } }}
    />
  );
}

export function KeysGrid() {
  return (
    <div class="keysgrid">
      <datalist id="study-keys">{offered().map((key) => <option key={key} value={key} />)}</datalist>
      <table aria-label="Keys that change">
        <thead>
          <tr><th scope="col">key</th><th scope="col">unit</th><th scope="col">model</th><th scope="col">from</th><th scope="col">to</th><th scope="col">count</th><th scope="col">values</th><th /><th /></tr>
        </thead>
        <tbody>
          {request.value.axes.map((axis, i) => <Row key={i} axis={axis} index={i} />)}
          <tr><td class="key"><AddKey /></td><td colSpan={8} /></tr>
        </tbody>
      </table>
    </div>
  );
}
