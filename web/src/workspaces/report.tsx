// The workspace of reports: preview, print and download.
import { ReportMiddle } from '../panels/report/ReportMiddle';
import { ReportStrip } from '../panels/report/ReportStrip';
import type { WorkspaceParts } from './workspace';

export const report: WorkspaceParts = { id: 'report', title: 'Report', Strip: ReportStrip, Middle: ReportMiddle, tabs: [] };
