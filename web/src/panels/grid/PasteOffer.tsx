// A table was pasted while no cell was selected: choice of its destination.
import type { Pasted } from '../../logic/gridPaste';
import type { ViewList } from '../../logic/gridView';
import { countIn } from '../../state/gridEdit';
import type { PasteMode } from '../../state/gridTable';

interface Props { pasted: Pasted; lists: ViewList[]; take: (list: string, mode: PasteMode) => void; close: () => void }

const many = (n: number, what: string): string => `${n} ${what}${n === 1 ? '' : 's'}`;

/** Summary of a pasted table: columns, ignored columns, unreadable cells. */
export function pastedText({ rows, columns, ignored, hasHead }: Pasted): string {
  const bad = rows.reduce((sum, row) => sum + row.cells.filter((c) => 'message' in c.read).length, 0);
  return [
    `${many(rows.length, 'row')} with ${columns.map((c) => c.title).join(', ') || 'no column of this table'}`,
    hasHead ? '' : 'no headings found, assigned in the order of the columns',
    ignored.length ? `ignored: ${ignored.join(', ')}` : '',
    bad ? `${many(bad, 'cell')} cannot be read` : '',
  ].filter(Boolean).join('; ');
}

export function PasteOffer({ pasted, lists, take, close }: Props) {
  const named = lists.length > 1;
  // the aft list first: a pasted table of boxes is usually a stinger
  const order = [...lists].reverse();
  return (
    <div class="gridstrip" role="group" aria-label="Pasted table" onKeyDown={(e) => { if (e.key === 'Escape') close(); }}>
      <p>Pasted: {pastedText(pasted)}.</p>
      {pasted.columns.length ? order.map((list, i) => {
        const count = countIn(list.path);
        return (
          <span key={list.path}>
            <button type="button" class={i === 0 ? 'main' : ''} onClick={() => take(list.path, 'replace')}>
              {count ? `Replace the ${many(count, 'row')}${named ? ` of ${list.title}` : ''}` : `Write${named ? ` as ${list.title}` : ' the rows'}`}
            </button>
            {count ? <button type="button" onClick={() => take(list.path, 'append')}>Add{named ? ` to ${list.title}` : ' below'}</button> : null}
          </span>
        );
      }) : null}
      <button type="button" onClick={close}>Cancel</button>
    </div>
  );
}
