// Content behind a summary on screen.
import type { ComponentChildren } from 'preact';

interface Props { summary: string; printed: boolean; children: ComponentChildren }

/** `printed`: whether paper shows it, unfolded; see openWhilePrinting. */
export function Folded({ summary, printed, children }: Props) {
  return (
    <details class={printed ? 'print-open' : 'print-not'}>
      <summary>{summary}</summary>
      {children}
    </details>
  );
}

/** Unfolds what is to be printed before printing, and folds it again afterwards. */
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
