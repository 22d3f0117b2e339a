import type { ReportDocument } from '../components/document';
import { marginStyle } from './margins';

/** A style element with the size of printed pages, and title, number and date in their margins. */
export function PageMargins({ report }: { report: ReportDocument }) {
  return <style>{marginStyle(report)}</style>;
}
