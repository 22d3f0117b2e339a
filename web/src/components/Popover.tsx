// A flat button that shows a value and opens a panel with its fields below. The panel lies on the top layer of the
// browser: it is not clipped, and closes with Escape and by a click elsewhere.
import type { ComponentChildren } from 'preact';
import { useId, useRef, useState } from 'preact/hooks';
import '../styles/popover.css';

const margin = 8;

interface Props {
  /** Small label above the value. */
  label: string;
  value: string;
  /** Placeholder for an empty value. */
  placeholder?: string;
  /** A reservation, shown as the title and with a mark. */
  note?: string;
  wide?: boolean;
  children: ComponentChildren;
}

export function Popover({ label, value, placeholder = '–', note, wide, children }: Props) {
  const id = useId();
  const button = useRef<HTMLButtonElement>(null), panel = useRef<HTMLDivElement>(null);
  const [open, setOpen] = useState(false);
  const place = (): void => {
    const box = panel.current, from = button.current?.getBoundingClientRect();
    if (!box || !from) return;
    box.style.top = `${from.bottom + 4}px`;
    box.style.maxHeight = `${innerHeight - from.bottom - 4 - margin}px`;
    box.style.left = `${Math.max(margin, Math.min(from.left, innerWidth - box.offsetWidth - margin))}px`;
  };
  const toggled = (event: Event): void => {
    const shown = (event as Event & { newState: string }).newState === 'open';
    setOpen(shown);
    if (shown) requestAnimationFrame(() => { place(); panel.current?.querySelector<HTMLElement>('input, select, button')?.focus(); });
  };
  // Enter commits a field and closes the panel.
  const pressed = (event: KeyboardEvent): void => {
    if (event.key !== 'Enter' || !(event.target instanceof HTMLInputElement)) return;
    event.preventDefault();  // otherwise the button, which then has the focus, would open the panel again
    panel.current?.hidePopover();
  };
  return (
    <div class="valuebox">
      <span class="valuelabel" id={`${id}-label`}>{label}</span>
      <button
        ref={button}
        type="button"
        class={value ? undefined : 'unset'}
        aria-haspopup="dialog"
        aria-expanded={open}
        aria-labelledby={`${id}-label ${id}-value`}
        title={note}
        {...{ popovertarget: id }}
      >
        <span id={`${id}-value`}>{value || placeholder}</span>
        {note ? <i class="dot warn" role="img" aria-label={note} /> : null}
      </button>
      <div
        ref={panel}
        id={id}
        class={`valuepanel${wide ? ' wide' : ''}`}
        role="dialog"
        aria-label={label}
        onKeyDown={pressed}
        {...{ popover: 'auto', onToggle: toggled }}
      >
        {open ? children : null}
      </div>
    </div>
  );
}
