// Preview of the report: its page in a frame.
import { useEffect, useRef, useState } from 'preact/hooks';
import { frameSource, type FrameSource } from '../../api/frames';
import { prepareReport, reportSections } from '../../logic/reportPage';
import { hasModel } from '../../state/model';
import { sayError } from '../../state/notices';
import { busy, canMake, files, leftOut, makeReport, outdated, paper, subject } from '../../state/report';
import { headings } from './ReportStrip';

function Nothing() {
  const stages = subject.value === 'operation';
  return (
    <div class="empty noreport">
      <p>{stages ? 'The report contains the stages of the operation, with the procedure sheet for use on board.' : 'The report contains the present lay of the model: key results, checks with their calculation, diagrams, tables, the model file.'}</p>
      <button type="button" class="main" disabled={busy.value || !canMake.value} onClick={() => void makeReport()}>{busy.value ? 'Making the report …' : stages ? 'Solve the stages and make the report' : 'Make the report'}</button>
    </div>
  );
}

function Page({ path, made }: { path: string; made: number }) {
  const [source, setSource] = useState<FrameSource | null>(null);
  const frame = useRef<HTMLIFrameElement>(null);
  const prepare = (): void => {
    const page = frame.current?.contentDocument;
    if (!page) return;
    headings.value = reportSections(page).map(({ heading }) => heading);
    prepareReport(page, leftOut.value, paper.value);
  };
  useEffect(prepare, [leftOut.value, paper.value]);
  useEffect(() => {
    frameSource(`${path}?show=1&made=${made}`).then(setSource).catch(sayError);
    return () => { headings.value = []; };
  }, [path, made]);
  if (!source) return null;
  return <iframe ref={frame} key={`${path} ${made}`} class="reportpage" title="The report" {...source} onLoad={prepare} />;
}

export function ReportMiddle() {
  const made = files.value;
  if (!hasModel.value && !made) return <p class="empty">No model yet.</p>;
  return (
    <section class={`reportmiddle${outdated.value ? ' old' : ''}`} aria-label="The report">
      {outdated.value ? (
        <p class="note" role="status">
          The model has changed since this report was made.
          {canMake.value ? <button type="button" class="link" disabled={busy.value} onClick={() => void makeReport()}>Update the report</button> : null}
        </p>
      ) : null}
      {made ? <Page path={made.report} made={made.made} /> : <Nothing />}
    </section>
  );
}
