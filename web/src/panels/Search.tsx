// The search for keys, objects, commands, findings and examples: Ctrl K anywhere.
import { useEffect } from 'preact/hooks';
import { SearchField } from '../components/SearchField';
import { searchPlaces } from '../state/search';
import { drawer } from '../state/workspace';

export function Search() {
  useEffect(() => {
    const keys = (event: KeyboardEvent): void => {
      if (!(event.ctrlKey || event.metaKey) || event.altKey || event.shiftKey || event.key.toLowerCase() !== 'k' || document.querySelector('dialog[open]')) return;
      event.preventDefault();
      const focus = (): void => document.getElementById('find')?.focus();
      // on narrow screens the column has to be shown first; elsewhere letters typed immediately after the shortcut must not be lost
      if (matchMedia('(max-width: 1099px)').matches) { drawer.value = 'model'; setTimeout(focus); } else focus();
    };
    addEventListener('keydown', keys, true);
    return () => removeEventListener('keydown', keys, true);
  }, []);
  return <SearchField label="Search" placeholder="Find a key, an object, a command …" keys="Ctrl K" entries={searchPlaces} choose={(place) => place.act()} />;
}
