// The report as a file, or printed, of which every browser makes a PDF.
import { printReport } from './report/print';

/** `file`: its address as a download; `show`: as a page. */
export function ReportLinks({ file, show, name, words = 'Report', title }: { file: string; show: string; name: string; words?: string; title?: string }) {
  return (
    <>
      <a class="button" href={file} download={name} title={title}>{words}</a>
      <button type="button" title={`Prints it: choose "Save as PDF" as the printer`} onClick={() => printReport(show)}>PDF…</button>
    </>
  );
}
