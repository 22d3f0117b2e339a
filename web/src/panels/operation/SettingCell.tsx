// An editable cell for an input of a listed stage.
import { useEffect, useRef, useState } from 'preact/hooks';
import { ApiError } from '../../api/client';
import { complete, parseQuantity } from '../../logic/units';
import { byPath, setKeys } from '../../state/model';
import { say } from '../../state/notices';

/** `text`: the value of the solved stage; the cell shows the present value of the model. */
export function SettingCell({ text, path, title }: { text: string; path: string; title: string }) {
  const field = path ? byPath.value.get(path) : undefined, written = field?.given ? String(field.value ?? '') : '';
  const [typed, setTyped] = useState(written), typing = useRef(false);
  useEffect(() => { if (!typing.current) setTyped(written); }, [written]);
  if (!field) return <td title={title}>{text}</td>;
  const send = async (): Promise<void> => {
    typing.current = false;
    const next = typed.trim();
    if (next === written) return;
    if (next && !parseQuantity(next)) { say(`${title}: enter a number with a unit, for example 12 m.`); setTyped(written); return; }
    try {
      await setKeys([{ path, value: next ? complete(next, parseQuantity(written)?.unit || field.unit) : null }]);
    } catch (error) { say(error instanceof ApiError ? error.message : String(error)); setTyped(written); }
  };
  return (
    <td class="setting" title={title} onClick={(e) => e.stopPropagation()}>
      <input
        aria-label={title} value={typed} data-written={written} placeholder={text} spellcheck={false} autocomplete="off"
        onFocus={(e) => { typing.current = true; e.currentTarget.select(); }}
        onInput={(e) => setTyped(e.currentTarget.value)}
        onBlur={() => void send()}
        onKeyDown={(e) => {
          if (e.key === 'Enter') e.currentTarget.blur();
          if (e.key === 'Escape') { typing.current = false; setTyped(written); }
        }}
      />
    </td>
  );
}
