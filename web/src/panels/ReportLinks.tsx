// The report as a file, or printed (every browser can save a PDF).
import { FileLink } from '../components/FileLink';
import { printReport } from './report/print';

/** `path`: that of the report below /api. */
export function ReportLinks({ path, name, label = 'Report', title }: { path: string; name: string; label?: string; title?: string }) {
  return (
    <>
      <FileLink path={path} name={name} title={title}>{label}</FileLink>
      <button type="button" title={`Print: choose "Save as PDF" as the printer`} onClick={() => printReport(path)}>PDF…</button>
    </>
  );
}
