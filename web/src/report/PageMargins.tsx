import type { ReportDocument } from '../components/document';
import { marginStyle } from './margins';

/** A style element with the page size, and title, number and date in the margins of printed pages. */
export function PageMargins({ report }: { report: ReportDocument }) {
  return <style>{marginStyle(report)}</style>;
}
