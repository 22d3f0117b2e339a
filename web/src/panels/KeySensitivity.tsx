// Effect of the tolerance of one key on the key results.
import { signal } from '@preact/signals';
import { changes } from '../state/live';
import { findingSensitivities, findSensitivities, sensitivities } from '../state/sensitivities';
import { Dialog } from './Dialog';

/** Key whose effect is shown. */
const shownKey = signal<{ path: string; name: string } | null>(null);

export function openKeySensitivity(path: string, name: string): void {
  shownKey.value = { path, name };
  if (sensitivities.value?.changes !== changes.value) void findSensitivities();
}

function Effects({ path, name }: { path: string; name: string }) {
  const answer = sensitivities.value?.answer;
  if (findingSensitivities.value || !answer) return <p class="brief" role="status">{findingSensitivities.value ? 'Computing…' : 'No result.'}</p>;
  if (answer.status === 'failed') return <p class="failuretext">{answer.what}: {answer.why}</p>;
  if (answer.status === 'invalid') return <p class="failuretext">The model cannot be solved.</p>;
  const rows = answer.results.flatMap((result) => result.inputs.filter((input) => input.key === path).map((input) => ({ result, input })));
  if (rows.length === 0) return <p>No key result depends on {name} as much as on the twelve inputs that move it most.</p>;
  const first = rows[0]!.input;
  return (
    <>
      <p class="brief">Effect of {name} ± {first.tolerance}{first.usual ? ', a default tolerance' : ''}, the other inputs unchanged.</p>
      <div class="table">
        <table>
          <thead><tr><th class="t">result</th><th>value</th><th>up</th><th>down</th></tr></thead>
          <tbody>
            {rows.map(({ result, input }) => (
              <tr key={result.name}><td class="t">{result.text}</td><td>{result.value}</td><td>{input.up_text}</td><td>{input.down_text}</td></tr>
            ))}
          </tbody>
        </table>
      </div>
    </>
  );
}

export function KeySensitivity() {
  const key = shownKey.value;
  if (!key) return null;
  const close = (): void => { shownKey.value = null; };
  return (
    <Dialog title={`Sensitivity to ${key.name}`} close={close}>
      <Effects {...key} />
      <footer><button type="button" class="main" onClick={close}>Close</button></footer>
    </Dialog>
  );
}
