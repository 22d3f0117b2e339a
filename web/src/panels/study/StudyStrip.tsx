// Above the table: the kind of study, varied keys and results, and the button that solves it.
import '../../styles/study.css';
import type { StudyKind } from '../../logic/studyFile';
import { duration } from '../../logic/show';
import { changes } from '../../state/live';
import { busy, count, editedFile, expected, inputError, isPlainTable, kind, rejection, setKind, setStudy, solveStudy, request } from '../../state/studies';
import { KeysGrid } from './KeysGrid';
import { StripField } from './StripField';
import { TableFields } from './TableFields';

const kinds: [StudyKind, string][] = [['table', 'lay table'], ['study', 'study'], ['operability', 'operability'], ['each', 'one at a time']];

const analyses = [['static', 'statics'], ['dynamic', 'dynamic analysis'], ['operation', 'operation, all stages'], ['seek', 'goal seek']] as const;

function StudyFields() {
  const { analysis, seeds, duration: time, gather, over, resolution, axes } = request.value, dynamic = analysis === 'dynamic';
  const searched = kind.value === 'operability', keys = axes.map((axis) => axis.key).filter(Boolean);
  return (
    <>
      <StripField id="st-analysis" label="analysis">
        <select id="st-analysis" value={analysis} onChange={(e) => setStudy({ analysis: e.currentTarget.value as typeof analysis })}>
          {analyses.map(([id, name]) => <option key={id} value={id}>{name}</option>)}
        </select>
      </StripField>
      {searched ? (
        <>
          <StripField
            id="st-over" label="find the limit of"
            title="Find the largest value of this key that passes every check, for every combination of the others"
          >
            <select id="st-over" value={over} onChange={(e) => setStudy({ over: e.currentTarget.value })}>
              <option value="">choose a key</option>
              {keys.map((key) => <option key={key} value={key}>{key}</option>)}
            </select>
          </StripField>
          <StripField id="st-resolution" label="resolution">
            <input id="st-resolution" class="short" value={resolution} placeholder="default" autocomplete="off" onInput={(e) => setStudy({ resolution: e.currentTarget.value })} />
          </StripField>
        </>
      ) : null}
      {dynamic ? (
        <>
          <StripField id="st-seeds" label="seeds">
            <input id="st-seeds" class="short" value={seeds} placeholder="from model" autocomplete="off" onInput={(e) => setStudy({ seeds: e.currentTarget.value })} />
          </StripField>
          <StripField id="st-duration" label="duration">
            <input id="st-duration" class="short" value={time} placeholder="from model" autocomplete="off" onInput={(e) => setStudy({ duration: e.currentTarget.value })} />
          </StripField>
        </>
      ) : null}
      {searched ? null : (
        <StripField id="st-gather" label="results" title="Results by their names in summary.json, separated by commas">
          <input id="st-gather" value={gather} placeholder="default results" autocomplete="off" onInput={(e) => setStudy({ gather: e.currentTarget.value })} />
        </StripField>
      )}
    </>
  );
}

function solveLabel(): string {
  const time = expected.value === null ? '' : `, about ${duration(Math.max(1, expected.value))}`;
  if (busy.value) return isPlainTable.value ? 'Making the table …' : 'Starting …';
  if (editedFile.value !== null) return 'Solve the study file';
  return kind.value === 'operability' ? `Find ${count.value} ${count.value === 1 ? 'limit' : 'limits'}` : `Solve ${count.value} ${count.value === 1 ? 'case' : 'cases'}${time}`;
}

export function StudyStrip() {
  const why = rejection.value || inputError.value;
  return (
    <form class="studystrip" aria-label="Study" onSubmit={(e) => { e.preventDefault(); void solveStudy(); }}>
      <div class="stripfields">
        <StripField id="st-kind" label="kind">
          <select id="st-kind" value={kind.value} onChange={(e) => setKind(e.currentTarget.value as StudyKind)}>
            {kinds.map(([id, name]) => <option key={id} value={id}>{name}</option>)}
          </select>
        </StripField>
        {kind.value === 'table' ? <TableFields /> : <StudyFields />}
        {kind.value === 'table' ? <button type="submit" class="main" disabled={busy.value || inputError.value !== null}>{solveLabel()}</button> : null}
      </div>
      {kind.value === 'table' ? null : (
        <>
          <KeysGrid />
          <div class="stripfields"><button type="submit" class="main" disabled={busy.value || inputError.value !== null}>{solveLabel()}</button></div>
        </>
      )}
      {why ? <p class="failuretext" role="alert">{why}</p> : null}
      {editedFile.value === null ? null : <p class="note">The edited study file is solved; the fields above are not used.</p>}
      {changes.value.length ? <p class="note">Trial values are not used: a study uses the model as written.</p> : null}
    </form>
  );
}
