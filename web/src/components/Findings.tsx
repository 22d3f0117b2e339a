// Findings of a report by severity.
import type { FindingData } from './document';
import { Folded } from './Folded';

/** More would push the contents off the first page. */
const shown = 6;

function upperFirst(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

function FindingList({ findings }: { findings: FindingData[] }) {
  return (
    <ul>
      {findings.map((finding) => (
        <li class={finding.severity}>
          <b>{upperFirst(finding.severity)}</b> {finding.text} <span class="code">{finding.code}</span>
        </li>
      ))}
    </ul>
  );
}

/** The first six findings, the others folded; nothing if there are none. */
export function Findings({ findings }: { findings: FindingData[] }) {
  if (findings.length === 0) return null;
  const rest = findings.slice(shown);
  return (
    <section id="findings" class="findings">
      <h2>Findings</h2>
      <FindingList findings={findings.slice(0, shown)} />
      {rest.length > 0 ? (
        <Folded summary={`${rest.length} more`} printed>
          <FindingList findings={rest} />
        </Folded>
      ) : null}
    </section>
  );
}
