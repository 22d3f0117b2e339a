// Findings in brief: three are shown, all serious ones in any case; the others unfold.
import { useState } from 'preact/hooks';
import type { Bullet } from '../logic/findings';
import { leadTo } from '../state/lead';

const leastShown = 3;

function Item({ b }: { b: Bullet }) {
  const name = b.key ? <button type="button" class="link" onClick={() => leadTo(b.key)}>{b.name}</button> : b.name ? <b>{b.name}:</b> : null;
  return (
    <li class={b.severity} title={b.code}>
      <span class="severity">{b.severity}</span>{' '}
      {name}{name ? ' ' : ''}
      {b.short === b.full ? b.full : <details><summary>{b.short}</summary><p>{b.full}</p></details>}
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
