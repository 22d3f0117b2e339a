// A field with a list of matches below it, operated by keyboard: arrows move, Enter selects, Esc closes.
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { findEntries, prepare, type SearchEntry } from '../logic/search';
import './searchField.css';

interface Props<E extends SearchEntry> {
  label: string;
  placeholder: string;
  /** Entries, collected only when the field gets the focus. */
  entries: () => E[];
  choose: (entry: E) => void;
  id?: string;
  /** The list is part of the layout and always open, as in a dialog. */
  inline?: boolean;
  kinds?: boolean;
  /** Shortcut of the field, shown at its end. */
  keys?: string;
}

const kindNames: Record<SearchEntry['kind'], string> = { command: 'command', object: 'object', key: 'key', finding: 'finding', example: 'example' };
const shownEntries = 40;

export function SearchField<E extends SearchEntry>({ label, placeholder, entries, choose, id = 'find', inline = false, kinds = true, keys: shortcut }: Props<E>) {
  const [query, setQuery] = useState('');
  const [open, setOpen] = useState(inline);
  const [chosen, setChosen] = useState(0);
  const input = useRef<HTMLInputElement>(null);
  const list = useRef<HTMLUListElement>(null);
  const prepared = useMemo(() => (open ? prepare(entries()) : []), [open]);
  const fits = useMemo(() => findEntries(prepared, query, shownEntries), [prepared, query]);
  useEffect(() => setChosen(0), [query, open]);
  useEffect(() => { list.current?.querySelector('[aria-selected=true]')?.scrollIntoView({ block: 'nearest' }); }, [chosen]);

  const leave = (): void => { setQuery(''); if (!inline) { setOpen(false); input.current?.blur(); } };
  const take = (entry: E | undefined): void => { if (!entry) return; leave(); choose(entry); };
  const keys = (event: KeyboardEvent): void => {
    const last = fits.length - 1;
    const next = { ArrowDown: Math.min(last, chosen + 1), ArrowUp: Math.max(0, chosen - 1), PageDown: Math.min(last, chosen + 8), PageUp: Math.max(0, chosen - 8) }[event.key];
    if (next !== undefined) { event.preventDefault(); setOpen(true); setChosen(next); }
    else if (event.key === 'Enter') { event.preventDefault(); take(fits[chosen]); }
    else if (event.key === 'Escape' && !inline) { event.preventDefault(); event.stopPropagation(); leave(); }
  };
  return (
    <div class={`searchfield${inline ? ' still' : ''}`} role="search">
      <input
        ref={input}
        id={id}
        role="combobox"
        aria-label={label}
        aria-expanded={open}
        aria-controls={`${id}-list`}
        aria-activedescendant={open && fits[chosen] ? `${id}-${chosen}` : undefined}
        aria-autocomplete="list"
        placeholder={placeholder}
        autocomplete="off"
        spellcheck={false}
        value={query}
        onFocus={() => setOpen(true)}
        onBlur={() => { if (!inline) setOpen(false); }}
        onInput={(e) => { setOpen(true); setQuery(e.currentTarget.value); }}
        onKeyDown={keys}
      />
      {shortcut && !open ? <kbd aria-hidden="true">{shortcut}</kbd> : null}
      {open ? (
        <ul id={`${id}-list`} ref={list} class="found-entries" role="listbox" aria-label={label}>
          {fits.map((entry, i) => (
            <li
              key={entry.id}
              id={`${id}-${i}`}
              role="option"
              aria-selected={i === chosen}
              title={entry.more}
              onPointerDown={(e) => e.preventDefault()}
              onClick={() => take(entry)}
            >
              <span>{entry.name}</span>
              <small>{entry.detail}</small>
              {kinds ? <i>{kindNames[entry.kind]}</i> : null}
            </li>
          ))}
          {fits.length === 0 ? <li class="none">{query ? 'No matches.' : 'Type to search.'}</li> : null}
        </ul>
      ) : null}
    </div>
  );
}
