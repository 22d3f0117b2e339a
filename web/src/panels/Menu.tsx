// A context menu: operated by keyboard and pointer, closed by Escape and by a click elsewhere.
import { signal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import '../styles/menu.css';

export interface MenuItem { name: string; act: () => void; disabled?: boolean; title?: string }

const shown = signal<{ items: MenuItem[]; x: number; y: number; from: HTMLElement | null } | null>(null);

/** Opens a menu at a position of the window; the focus returns to its previous element. */
export function openMenu(items: MenuItem[], x: number, y: number): void {
  shown.value = items.length ? { items, x, y, from: document.activeElement as HTMLElement | null } : null;
}

/** Opens a menu below an element, such as a button with "⋯". */
export function openMenuBelow(items: MenuItem[], element: Element): void {
  const box = element.getBoundingClientRect();
  openMenu(items, box.left, box.bottom + 2);
}

function close(): void {
  const from = shown.value?.from;
  shown.value = null;
  from?.focus();
}

function step(list: HTMLElement, by: number): void {
  const buttons = [...list.querySelectorAll<HTMLElement>('button:not(:disabled)')];
  const index = buttons.indexOf(document.activeElement as HTMLElement);
  buttons[(index + by + buttons.length) % buttons.length]?.focus();
}

/** Moves to the next command that begins with a letter. */
function stepTo(list: HTMLElement, letter: string): void {
  const buttons = [...list.querySelectorAll<HTMLElement>('button:not(:disabled)')], index = buttons.indexOf(document.activeElement as HTMLElement);
  const next = [...buttons.slice(index + 1), ...buttons.slice(0, index + 1)].find((button) => button.textContent!.toLowerCase().startsWith(letter.toLowerCase()));
  next?.focus();
}

export function Menu() {
  const list = useRef<HTMLUListElement>(null);
  const menu = shown.value;
  useEffect(() => {
    if (!menu || !list.current) return undefined;
    const { width, height } = list.current.getBoundingClientRect();
    list.current.style.left = `${Math.max(4, Math.min(menu.x, innerWidth - width - 4))}px`;
    list.current.style.top = `${Math.max(4, Math.min(menu.y, innerHeight - height - 4))}px`;
    list.current.querySelector<HTMLElement>('button:not(:disabled)')?.focus();
    const away = (e: PointerEvent): void => { if (!list.current?.contains(e.target as Node)) shown.value = null; };
    addEventListener('pointerdown', away, true);
    return () => removeEventListener('pointerdown', away, true);
  }, [menu]);
  if (!menu) return null;
  return (
    <ul
      ref={list}
      class="menu"
      role="menu"
      onKeyDown={(e) => {
        if (e.key === 'Escape' || e.key === 'Tab') { e.preventDefault(); close(); }
        else if (e.key === 'ArrowDown') { e.preventDefault(); step(e.currentTarget, 1); }
        else if (e.key === 'ArrowUp') { e.preventDefault(); step(e.currentTarget, -1); }
        else if (e.key.length === 1) stepTo(e.currentTarget, e.key);
      }}
    >
      {menu.items.map((item) => (
        <li key={item.name} role="none">
          <button type="button" role="menuitem" disabled={item.disabled} title={item.title} onClick={() => { close(); item.act(); }}>{item.name}</button>
        </li>
      ))}
    </ul>
  );
}
