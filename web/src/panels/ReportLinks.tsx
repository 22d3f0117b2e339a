// The report as a file, or printed, of which every browser makes a PDF.
import { sayError } from '../state/notices';

/** Width that the report lays its figures out for [px]. */
const wide = 1000;

/** Loads the report out of sight and opens the browser's dialogue for printing it. */
function print(source: string): void {
  document.querySelector('iframe.printed')?.remove();
  const frame = document.createElement('iframe');
  frame.className = 'printed';
  frame.tabIndex = -1;
  frame.setAttribute('aria-hidden', 'true');
  frame.style.width = `${wide}px`;
  frame.addEventListener('load', () => {
    const view = frame.contentWindow;
    if (!view || view.document.documentElement.dataset.drawn !== 'yes') { frame.remove(); sayError(new Error('The report could not be loaded for printing. Download it with Report and print that file.')); return; }
    view.addEventListener('afterprint', () => setTimeout(() => frame.remove(), 1000));
    view.focus();
    view.print();
  });
  frame.src = source;
  document.body.append(frame);
}

/** `file`: its address as a download; `show`: as a page. */
export function ReportLinks({ file, show, name, words = 'Report', title }: { file: string; show: string; name: string; words?: string; title?: string }) {
  return (
    <>
      <a class="button" href={file} download={name} title={title}>{words}</a>
      <button type="button" title={`Prints it: choose "Save as PDF" as the printer`} onClick={() => print(show)}>PDF…</button>
    </>
  );
}
