// Name and note of each selected run, saved when the field is left.
import { useRef, useState } from 'preact/hooks';
import type { Run } from '../../api/types';
import { withoutPaths } from '../../logic/findings';
import { compared } from '../../state/compare';
import { annotate, runName } from '../../state/runs';

function NoteFields({ run }: { run: Run }) {
  const [name, setName] = useState(run.name);
  const [note, setNote] = useState(run.note);
  const kept = useRef({ name: run.name, note: run.note });  // as last sent: `run` has it only after the answer
  const keep = (): void => {
    const changes = { ...(name === kept.current.name ? {} : { name: name.trim() }), ...(note === kept.current.note ? {} : { note: note.trim() }) };
    const before = kept.current;
    kept.current = { name, note };
    if (Object.keys(changes).length) void annotate(run.id, changes).then((done) => { if (!done) kept.current = before; });
  };
  return (
    <section class="words" aria-label={`Notes on ${runName(run)}`}>
      <h3>{runName(run)}</h3>
      <input aria-label="Name of the run" placeholder={run.title || 'name'} value={name} onInput={(e) => setName(e.currentTarget.value)} onBlur={keep} onKeyDown={(e) => { if (e.key === 'Enter') keep(); }} />
      <textarea aria-label="Note on the run" placeholder="note" rows={4} value={note} onInput={(e) => setNote(e.currentTarget.value)} onBlur={keep} />
      {run.changed ? <p class="brief">Changed since the run before: {run.changed}</p> : null}
      {run.message ? <p class="brief">{withoutPaths(run.message)}</p> : null}
      <p class="brief">Folder: runs/{run.id.replace('~', '/')}</p>
    </section>
  );
}

export function RunNotes() {
  const list = compared.value;
  if (list.length === 0) return <p class="empty">Select a run in the table above.</p>;
  return <div class="runnotes">{list.map((run) => <NoteFields key={run.id} run={run} />)}</div>;
}
