// A native dialog: it keeps the focus inside and closes with Escape.
import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';

export function Dialog({ title, close, children, wide }: { title: string; close: () => void; children: ComponentChildren; wide?: boolean }) {
  const ref = useRef<HTMLDialogElement>(null);
  useEffect(() => { const d = ref.current!; d.showModal(); d.querySelector<HTMLElement>('[autofocus], input, select, li button, button.main')?.focus(); return () => d.close(); }, []);
  return (
    <dialog ref={ref} class={wide ? 'wide' : ''} aria-label={title} onCancel={(e) => { e.preventDefault(); close(); }} onMouseDown={(e) => { if (e.target === ref.current) close(); }}>
      <header><h2>{title}</h2><button type="button" class="tiny" aria-label="Close" onClick={close}>✕</button></header>
      {children}
    </dialog>
  );
}
