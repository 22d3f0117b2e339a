// Content that is folded behind a summary on screen.
import type { ComponentChildren } from 'preact';

interface Props { summary: string; printed: boolean; children: ComponentChildren }

/** `printed`: true to unfold it on paper; see openWhilePrinting. */
export function Folded({ summary, printed, children }: Props) {
  return (
    <details class={printed ? 'print-open' : 'print-not'}>
      <summary>{summary}</summary>
      {children}
    </details>
  );
}

/** Unfolds printed parts before printing, and folds them again afterwards. */
export function openWhilePrinting(): void {
  const opened: HTMLDetailsElement[] = [];
  window.addEventListener('beforeprint', () => {
    for (const details of document.querySelectorAll<HTMLDetailsElement>('details.print-open:not([open])')) {
      details.open = true;
      opened.push(details);
    }
  });
  window.addEventListener('afterprint', () => {
    for (const details of opened.splice(0)) details.open = false;
  });
}
