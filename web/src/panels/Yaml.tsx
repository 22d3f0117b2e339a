// The YAML tab: the editor, with the errors below it.
import { useEffect, useRef, useState } from 'preact/hooks';
import { effect } from '@preact/signals';
import { get } from '../api/client';
import type { Schema } from '../logic/schema';
import { diagnostics, putText, redo, text, typing, undo } from '../state/model';
import { lead } from '../state/lead';
import { sayError } from '../state/notices';
import type { YamlEditor } from './yamlEditor';

let schema: Schema | null = null;

export function Yaml() {
  const box = useRef<HTMLDivElement>(null);
  const editor = useRef<YamlEditor | null>(null);
  const [ready, setReady] = useState(false);
  useEffect(() => {
    let gone = false;
    let stop = (): void => undefined;
    let timer = 0;
    let waiting: string | null = null;
    const flush = (): void => { clearTimeout(timer); typing.value = false; if (waiting !== null) { const t = waiting; waiting = null; void putText(t, 'yaml'); } };
    void import('./yamlEditor').then(({ makeEditor }) => {
      if (gone || !box.current) return;
      const e = makeEditor(box.current, text.peek(), () => schema, (t) => { waiting = t; typing.value = true; clearTimeout(timer); timer = window.setTimeout(flush, 250); }, () => { flush(); undo(); }, () => { flush(); redo(); });
      editor.current = e;
      setReady(true);
      const a = effect(() => { const t = text.value; if (waiting === null) e.setText(t); });
      const b = effect(() => { e.setDiagnostics(diagnostics.value); });
      const c = effect(() => { const to = lead.value; if (to && !to.key && to.line) { e.goTo(to.line); lead.value = null; } });
      stop = () => { a(); b(); c(); };
    }).catch(sayError);
    // the search of the browser only covers rendered lines
    const find = (e: KeyboardEvent): void => {
      if (!(e.ctrlKey || e.metaKey) || e.altKey || e.shiftKey || e.key.toLowerCase() !== 'f' || e.defaultPrevented || document.querySelector('dialog[open]')) return;
      e.preventDefault();
      editor.current?.openSearch();
    };
    addEventListener('keydown', find);
    if (!schema) get<Schema>('schema').then((s) => { schema = s; }).catch(sayError);
    return () => { removeEventListener('keydown', find); gone = true; flush(); stop(); editor.current?.destroy(); };
  }, []);
  return (
    <div class="yaml">
      <div class="editor" ref={box}>{ready ? null : <p class="empty">Loading the editor…</p>}</div>
      {diagnostics.value.length ? (
        <ul class="diagnosticlist" aria-label="Errors in the model">
          {diagnostics.value.map((d, i) => (
            <li key={i} class={d.severity}><button type="button" onClick={() => editor.current?.goTo(d.line)}><b>line {d.line}</b> {d.message}</button></li>
          ))}
        </ul>
      ) : null}
    </div>
  );
}
