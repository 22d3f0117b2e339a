// Short findings, the serious ones first: each leads to its object, position and time; further notes are folded.
import { useState } from 'preact/hooks';
import type { Bullet } from '../logic/findings';
import { followFinding, hasPlace } from '../state/findingPlace';

const leastShown = 4;

function Item({ b }: { b: Bullet }) {
  const name = b.name || b.object || '';
  return (
    <li class={b.severity} title={b.code}>
      <span class="hidden">{b.severity}: </span>
      {b.short === b.full ? b.full : <details><summary title="Show the full text"><span class="short">{b.short}</span><span class="full">{b.full}</span></summary></details>}
      {name || hasPlace(b) ? (
        <span class="place">
          {hasPlace(b) ? <button type="button" class="link" onClick={() => followFinding(b)}>{name || 'show the location'}</button> : name}
          {b.time !== undefined ? `, t = ${b.time.toFixed(1)} s` : ''}
        </span>
      ) : null}
    </li>
  );
}

export function Findings({ list }: { list: Bullet[] }) {
  const [open, setOpen] = useState(false);
  if (list.length === 0) return null;
  const shown = Math.max(leastShown, list.filter((b) => b.severity === 'serious').length);
  return (
    <div class="findings" role="group" aria-label="Findings">
      <ul>{(open ? list : list.slice(0, shown)).map((b) => <Item key={`${b.key} ${b.full}`} b={b} />)}</ul>
      {list.length > shown ? <button type="button" class="link" aria-expanded={open} onClick={() => setOpen(!open)}>{open ? 'fewer' : `${list.length - shown} more`}</button> : null}
    </div>
  );
}
