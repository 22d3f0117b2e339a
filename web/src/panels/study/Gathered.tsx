// Several seeds by their statistics, or variants side by side; each case is a separate run.
import type { Run } from '../../api/types';
import { bullets } from '../../logic/findings';
import { runs, select } from '../../state/runs';
import { gathered } from '../../state/studies';
import { goTo } from '../../state/workspace';
import { Findings } from '../Findings';
import { QuantityTable } from './QuantityTable';

export function Gathered({ run }: { run: Run }) {
  const of = gathered.value, cases = runs.value.filter((r) => r.parent === run.id);
  return (
    <section class="gathered" aria-label="Seeds or variants">
      {cases.length ? (
        <p class="acts">
          {cases.map((c) => <button key={c.id} type="button" disabled={!c.has_results} title="Show this run" onClick={() => { select(c.id); goTo('storm'); }}>{c.title}</button>)}
        </p>
      ) : null}
      {of ? (
        <>
          <QuantityTable of={of} />
          <Findings list={bullets(of.findings.map((f) => (f.cases < of.cases.length ? { ...f, message: `${f.message} (${f.cases} of ${of.cases.length})` } : f)), [])} />
        </>
      ) : run.has_results ? <p class="brief">Loading …</p> : null}
    </section>
  );
}
