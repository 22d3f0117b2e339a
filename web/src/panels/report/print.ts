// Prints a report, of which every browser makes a PDF.
import { sayError } from '../../state/notices';

/** Width that the report lays its figures out for [px]. */
const wide = 1000;

/** Loads the report out of sight and opens the browser's dialogue for printing it; `prepare` is done to its page before. */
export function printReport(source: string, prepare?: (page: Document) => void): void {
  document.querySelector('iframe.printed')?.remove();
  const frame = document.createElement('iframe');
  frame.className = 'printed';
  frame.tabIndex = -1;
  frame.setAttribute('aria-hidden', 'true');
  frame.style.width = `${wide}px`;
  frame.addEventListener('load', () => {
    const view = frame.contentWindow;
    if (!view || view.document.documentElement.dataset.drawn !== 'yes') {
      frame.remove();
      sayError(new Error('The report could not be loaded for printing. Download it as HTML and print that file.'));
      return;
    }
    prepare?.(view.document);
    view.addEventListener('afterprint', () => setTimeout(() => frame.remove(), 1000));
    view.focus();
    view.print();
  });
  frame.src = source;
  document.body.append(frame);
}
