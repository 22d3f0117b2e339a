// Draws a report from the data in its page.
import { render } from 'preact';
import type { ReportDocument, ShownUnits } from '../components/document';
import { openWhilePrinting } from '../components/Folded';
import { Page } from './Page';
import './report.css';
import '../components/chart.css';

function readJson<T>(id: string): T {
  return JSON.parse(document.getElementById(id)!.textContent!) as T;
}

const page = (
  <Page
    report={readJson<ReportDocument>('document')}
    data={readJson<unknown>('results-data')}
    units={readJson<ShownUnits>('shown-units')}
  />
);
render(page, document.getElementById('report')!);
openWhilePrinting();
// Components that measure their drawing are drawn again by then.
queueMicrotask(() => { document.documentElement.dataset.drawn = 'yes'; });
