// The report as a file, or printed (every browser can save a PDF).
import { printReport } from './report/print';

/** `file`: its address for download; `show`: for display. */
export function ReportLinks({ file, show, name, label = 'Report', title }: { file: string; show: string; name: string; label?: string; title?: string }) {
  return (
    <>
      <a class="button" href={file} download={name} title={title}>{label}</a>
      <button type="button" title={`Print: choose "Save as PDF" as the printer`} onClick={() => printReport(show)}>PDF…</button>
    </>
  );
}
