// Warnings in brief: three are shown, the others unfold.
import { useState } from 'preact/hooks';
import type { Bullet } from '../logic/warnings';
import { leadTo } from '../state/lead';

const shown = 3;

function Item({ b }: { b: Bullet }) {
  const name = b.key ? <button type="button" class="link" onClick={() => leadTo(b.key)}>{b.name}</button> : b.name ? <b>{b.name}:</b> : null;
  return (
    <li>
      {name}{name ? ' ' : ''}
      {b.short === b.full ? b.full : <details><summary>{b.short}</summary><p>{b.full}</p></details>}
    </li>
  );
}

export function Warnings({ list }: { list: Bullet[] }) {
  const [open, setOpen] = useState(false);
  if (list.length === 0) return null;
  return (
    <div class="warnings" role="group" aria-label="Warnings">
      <ul>{(open ? list : list.slice(0, shown)).map((b) => <Item key={`${b.key} ${b.full}`} b={b} />)}</ul>
      {list.length > shown ? <button type="button" class="link" aria-expanded={open} onClick={() => setOpen(!open)}>{open ? 'fewer' : `${list.length - shown} more`}</button> : null}
    </div>
  );
}
