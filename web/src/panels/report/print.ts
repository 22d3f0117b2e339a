// Prints a report (every browser can save a PDF).
import { frameSource } from '../../api/frames';
import { sayError } from '../../state/notices';

/** Layout width of the report figures [px]. */
const wide = 1000;

/** Loads the report at a path below /api in a hidden frame and opens the print dialog of the browser; `prepare` is applied to its page first. */
export function printReport(path: string, prepare?: (page: Document) => void): void {
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
  frameSource(`${path}?show=1`).then((source) => {
    Object.assign(frame, source);
    document.body.append(frame);
  }).catch(sayError);
}
