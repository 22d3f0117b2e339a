// Sensitivities: the inputs whose tolerances have the largest effect on a key result, as a tornado diagram.
import { signal } from '@preact/signals';
import type { SensitivityAnswer, SensitivityInput } from '../api/types';
import { changes } from '../state/live';
import { findingSensitivities as busy, findSensitivities, sensitivities as found } from '../state/sensitivities';

const chosen = signal('');

function Bar({ share, up }: { share: number; up: boolean }) {
  const width = 50 * Math.abs(share);
  return <i class={up ? 'up' : 'down'} style={{ left: `${share < 0 ? 50 - width : 50}%`, width: `${width}%` }} />;
}

function Row({ input }: { input: SensitivityInput }) {
  const title = `${input.text}\n${input.key} ± ${input.tolerance}${input.usual ? ' (default tolerance)' : ''}: ${input.up_text} upwards, ${input.down_text} downwards${input.contact ? `\nOne-sided: ${input.contact}` : ''}`;
  return (
    <li title={title}>
      <span class="what">{input.name} <small>± {input.tolerance}</small></span>
      <span class="track" role="presentation"><Bar share={input.down} up={false} /><Bar share={input.up} up /></span>
      <b>{input.up_text}{input.contact ? ' *' : ''}</b>
      {input.contact ? <small class="contact">* one-sided: {input.contact}</small> : null}
    </li>
  );
}

function Tornado({ answer }: { answer: SensitivityAnswer }) {
  if (answer.status === 'failed') return <p class="empty">{answer.what}: {answer.why}</p>;
  if (answer.status === 'invalid') return <p class="empty">The model cannot be solved.</p>;
  const result = answer.results.find((r) => r.name === chosen.value) ?? answer.results[0];
  if (!result) return <p class="empty">No key result depends on a number of the model file.</p>;
  return (
    <>
      <select aria-label="Result" value={result.name} onChange={(e) => { chosen.value = e.currentTarget.value; }}>
        {answer.results.map((r) => <option key={r.name} value={r.name}>{r.text}, {r.value}</option>)}
      </select>
      <ol class="tornado">{result.inputs.map((input) => <Row key={input.key} input={input} />)}</ol>
      <small>Effect of each tolerance, the other inputs unchanged. {answer.assumptions.join(' ')}</small>
    </>
  );
}

export function Sensitivities() {
  const result = found.value;
  const old = result !== null && result.changes !== changes.value;
  return (
    <section class={`sensitivities${old ? ' old' : ''}`} aria-label="Sensitivities">
      <h3>Sensitivities {old ? <small>before the last change</small> : null}</h3>
      <button type="button" disabled={busy.value} onClick={() => { void findSensitivities(); }}>
        {busy.value ? 'Computing…' : result ? 'Compute again' : 'Compute the sensitivities'}
      </button>
      {result ? <Tornado answer={result.answer} /> : null}
    </section>
  );
}
