// The selected case: its values and results, and commands to use it in the model.
import type { Matrix, MatrixCase } from '../../api/types';
import { withoutPaths } from '../../logic/findings';
import { keyLabel, resultTitle } from '../../logic/studies';
import { tidy } from '../../logic/units';
import { caseKeys, chosenCase, matrix, openInLay, takeIntoModel, triedValues } from '../../state/studies';

/** A key of one item; a pattern refers to several. */
const isPlain = (key: string): boolean => !/[*]|\[[^\]\d]/.test(key);

function Outcome({ c }: { c: MatrixCase }) {
  if (c.state === 'failed') return <p class="failuretext">{withoutPaths(c.reason)}</p>;
  if (c.state === 'open') return <p class="brief">Not computed yet.</p>;
  const check = c.governing ? `${c.governing}${c.utilisation === null ? '' : `: ${tidy(c.utilisation, 3)}`}` : '';
  const verdict = c.verdict === 'exceeded' ? 'exceeded' : c.obstacle ? `passes with reservations: ${c.obstacle}` : c.verdict;
  return <p class={c.passed ? 'brief' : c.verdict === 'reserved' ? 'note' : 'failuretext'}>{[check, verdict].filter(Boolean).join('; ')}</p>;
}

function Acts({ m, c }: { m: Matrix; c: MatrixCase }) {
  const keys = caseKeys(m, c), tried = triedValues(keys), plain = keys.every(({ key }) => isPlain(key));
  return (
    <div class="acts">
      <button
        type="button" class="main" disabled={!tried} onClick={() => { if (tried) openInLay(tried); }}
        title={tried ? 'Show this case in Lay with trial values; the model is not changed' : 'Some of these keys cannot be tried out: apply them to the model'}
      >
        Open in Lay
      </button>
      <button
        type="button" disabled={!plain} onClick={() => void takeIntoModel(keys, `case ${c.number}`)}
        title={plain ? 'Write the values of this case into the model, as one undo step' : 'A key of several items cannot be written'}
      >
        Apply to model
      </button>
    </div>
  );
}

export function ChosenCase() {
  const m = matrix.value, c = m?.cases.find(({ number }) => number === chosenCase.value);
  if (!m || !c) return null;
  return (
    <section class="chosencase" aria-label="Case">
      <header>
        <h3>Case {c.number}{c.seed === null ? '' : `, seed ${c.seed}`}</h3>
        <button type="button" class="tiny" aria-label="Close the case" onClick={() => { chosenCase.value = null; }}>✕</button>
      </header>
      <Outcome c={c} />
      <dl>
        {m.inputs.map((input, i) => <div key={input.key} title={input.key}><dt>{keyLabel(input.key)}</dt><dd>{c.words[i]}</dd></div>)}
        {c.state === 'done' ? m.outputs.map((out, i) => (
          <div key={out.name} title={out.name}><dt>{resultTitle(m, i)}</dt><dd>{typeof c.values[i] === 'number' ? tidy(c.values[i]!, 4) : '–'}</dd></div>
        )) : null}
      </dl>
      <Acts m={m} c={c} />
    </section>
  );
}
