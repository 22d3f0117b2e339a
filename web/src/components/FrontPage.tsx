// First page of a report: subject, verdict, highest utilisations, findings and contents.
import type { Bar, BlockData, Front, VerdictData } from './document';
import { Entries } from './Entries';
import { Findings } from './Findings';
import { sections } from './outline';
import { fixed } from './units';

/** Utilisation at the end of a bar. */
const barEnd = 1.25;

function UtilisationBar({ bar }: { bar: Bar }) {
  const width = 100 * Math.min(Math.max(bar.utilisation / barEnd, 0), 1);
  return (
    <div class={bar.utilisation > 1 ? 'bar over' : 'bar'}>
      <div class="region">{bar.title}</div>
      <div class="track"><div style={{ width: `${fixed(width, 1)}%` }} /></div>
      <div class="value">{fixed(bar.utilisation, 3)}</div>
      <div class="what">{bar.what}</div>
    </div>
  );
}

/** Only the subject of the verdict if there are no bars. */
function Utilisation({ heading, bars, note }: NonNullable<Front['utilisation']>) {
  const remark = note ? <p class="small">{note}</p> : null;
  if (bars.length === 0) return remark;
  return (
    <div class="card">
      <h3>{heading}</h3>
      {bars.map((bar) => <UtilisationBar bar={bar} />)}
      {remark}
    </div>
  );
}

export function Verdict({ verdict }: { verdict: VerdictData }) {
  return (
    <div class={`verdict ${verdict.kind.replace(' ', '-')}`}>
      <div class="words">{verdict.words}</div>
      <div class="because">{verdict.because}</div>
    </div>
  );
}

export function Contents({ body }: { body: BlockData[] }) {
  return (
    <nav id="contents">
      <h2>Contents</h2>
      <ol>
        {sections(body).map((section) => <li><a href={`#${section.id}`}>{section.heading}</a></li>)}
      </ol>
    </nav>
  );
}

export function FrontPage({ front, body }: { front: Front; body: BlockData[] }) {
  return (
    <div class="front">
      <header>
        <div class="kind">{front.kind}</div>
        <h1>{front.title}</h1>
        {front.control ? <Entries entries={front.control} framed /> : null}
        <Entries entries={front.entries} />
      </header>
      {front.verdict || front.utilisation ? (
        <section id="verdict">
          {front.verdict ? <Verdict verdict={front.verdict} /> : null}
          {front.utilisation ? <Utilisation {...front.utilisation} /> : null}
        </section>
      ) : null}
      <Findings findings={front.findings} />
      <Contents body={body} />
    </div>
  );
}
