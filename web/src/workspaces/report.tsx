// The workspace of reports: what goes to others, as it will be.
import { ReportMiddle } from '../panels/report/ReportMiddle';
import { ReportStrip } from '../panels/report/ReportStrip';
import type { WorkspaceParts } from './workspace';

export const report: WorkspaceParts = { id: 'report', title: 'Report', Strip: ReportStrip, Middle: ReportMiddle, tabs: [] };
