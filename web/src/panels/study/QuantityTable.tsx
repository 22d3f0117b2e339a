// Results of the cases of a study: several seeds by their statistics, variants side by side.
import type { Study, StudyQuantity } from '../../api/types';
import { tidy } from '../../logic/units';

const shown = (value: number | null | undefined, q: StudyQuantity): string => (value === null || value === undefined ? '–' : tidy(value * q.factor, 4));

interface Shown { head: { name: string; title: string }[]; values: (q: StudyQuantity) => (number | null | undefined)[] }

const overSeeds: Shown = { head: ['mean', 'std', 'min', 'max'].map((name) => ({ name, title: `${name} over the seeds` })), values: (q) => [q.mean, q.std, q.min, q.max] };
const caseByCase = (of: Study): Shown => ({ head: of.cases.map((c) => ({ name: c.name.replace('_', ' '), title: c.words })), values: (q) => q.values });

/** The quantity has a separate line: its name is longer than a column is wide. */
export function QuantityTable({ of }: { of: Study }) {
  const columns = of.kind === 'seeds' ? overSeeds : caseByCase(of);
  return (
    <table class="minmax study">
      <thead><tr>{columns.head.map((c) => <th key={c.name} scope="col" title={c.title}>{c.name}</th>)}</tr></thead>
      {of.quantities.map((q) => (
        <tbody key={q.name}>
          <tr class="group"><th scope="rowgroup" colSpan={columns.head.length}>{q.text}{q.unit === '-' ? null : <>{'\u00a0'}<small>{q.unit}</small></>}</th></tr>
          <tr>{columns.values(q).map((v, i) => <td key={i}>{shown(v, q)}</td>)}</tr>
          {q.gumbel ? <tr><th colSpan={columns.head.length} title="Most probable extreme of three hours by a Gumbel distribution, with its 95 % confidence interval">3 h, Gumbel: {shown(q.gumbel.estimate, q)} ({shown(q.gumbel.low, q)} to {shown(q.gumbel.high, q)})</th></tr> : null}
          {q.acer ? <tr><th colSpan={columns.head.length} title="Most probable extreme of three hours by average conditional exceedance rates of the histories of all seeds, with its 95 % confidence interval">3 h, ACER: {shown(q.acer.estimate, q)} ({shown(q.acer.low, q)} to {shown(q.acer.high, q)})</th></tr> : null}
        </tbody>
      ))}
    </table>
  );
}
