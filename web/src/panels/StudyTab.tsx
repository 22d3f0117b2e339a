// The tab of studies: keys that change together or against each other, and what is computed of every case.
import { useState } from 'preact/hooks';
import { ApiError } from '../api/client';
import { download } from '../components/download';
import { variableKeys } from '../logic/seek';
import { axisCount, caseCount, firstAxis, studyFault, studyYaml, type AxisWish, type StudyWish } from '../logic/studies';
import { changes } from '../state/live';
import { leftTab } from '../state/look';
import { byPath, errors, fields, fileName } from '../state/model';
import { startStudy, wish } from '../state/studies';

const kinds = [['static', 'Statics'], ['dynamic', 'Dynamic analysis'], ['operation', 'Operation, all stages'], ['seek', 'Goal seek']] as const;

const unitOf = (key: string): string => byPath.value.get(key)?.unit ?? '';
const first = (): StudyWish => ({ analysis: 'static', axes: [firstAxis(byPath.value.get('tensioner.tension') ?? variableKeys(fields.value)[0])], seeds: '', duration: '', gather: '', limit: '' });

/** Keys of the sea come with dynamic analyses. */
function offered(): string[] {
  const sea = fields.value.filter((f) => /^environment\.waves\.(hs|tp|from|height|period)$/.test(f.path)).map((f) => f.path);
  return [...new Set([...variableKeys(fields.value).map((f) => f.path), ...sea])];
}

function Axis({ axis, index, set, drop }: { axis: AxisWish; index: number; set: (part: Partial<AxisWish>) => void; drop: () => void }) {
  const count = axisCount(axis);
  return (
    <li class="axis">
      <input aria-label={`Key ${index + 1}`} list="study-keys" placeholder="key of the model" value={axis.key} autocomplete="off" onInput={(e) => { const key = e.currentTarget.value; set(byPath.value.has(key) && !axis.values ? firstAxis(byPath.value.get(key)) : { key }); }} />
      <button type="button" class="tiny" aria-label={`Remove key ${index + 1}`} onClick={drop}>✕</button>
      <input aria-label={`Values of key ${index + 1}`} placeholder="1 m, 2 m, 3 m  or  1 m..3 m/5" value={axis.values} autocomplete="off" onInput={(e) => set({ values: e.currentTarget.value })} />
      <small>{count || ''}</small>
    </li>
  );
}

export function StudyTab() {
  const [refused, setRefused] = useState('');
  const [busy, setBusy] = useState(false);
  const now = wish.value ?? first();
  const set = (part: Partial<StudyWish>): void => { setRefused(''); wish.value = { ...now, ...part }; };
  const setAxis = (index: number, part: Partial<AxisWish>): void => set({ axes: now.axes.map((a, i) => (i === index ? { ...a, ...part } : a)) });
  const fault = errors.value.length ? 'the model has errors; correct them first' : studyFault(now, unitOf);
  const text = (): string => studyYaml(now, fileName.value || 'model.yaml', unitOf);
  const send = async (): Promise<void> => {
    setBusy(true);
    try { await startStudy(text()); leftTab.value = 'runs'; } catch (error) { setRefused(error instanceof ApiError ? error.message : String(error)); }
    setBusy(false);
  };
  const keys = now.axes.map((a) => a.key).filter(Boolean);
  const limits = now.axes.filter((a) => a.key && axisCount(a) > 1).map((a) => a.key);
  const dynamic = now.analysis === 'dynamic';
  return (
    <form class="studyform" aria-label="Study of the model" onSubmit={(e) => { e.preventDefault(); if (!fault && !busy) void send(); }}>
      <div class="row wide">
        <label for="st-analysis">of every case</label>
        <select id="st-analysis" value={now.analysis} onChange={(e) => set({ analysis: e.currentTarget.value as StudyWish['analysis'] })}>{kinds.map(([id, name]) => <option key={id} value={id}>{name}</option>)}</select>
      </div>
      <h3>Keys that change</h3>
      <datalist id="study-keys">{offered().map((key) => <option key={key} value={key} />)}</datalist>
      <ul class="axes">{now.axes.map((axis, i) => <Axis key={i} axis={axis} index={i} set={(part) => setAxis(i, part)} drop={() => set({ axes: now.axes.filter((_a, k) => k !== i) })} />)}</ul>
      <button type="button" onClick={() => set({ axes: [...now.axes, { key: '', values: '' }] })}>Add a key</button>
      {dynamic ? (
        <>
          <div class="row wide"><label for="st-seeds">seeds</label><input id="st-seeds" value={now.seeds} placeholder="the model's" autocomplete="off" onInput={(e) => set({ seeds: e.currentTarget.value })} /></div>
          <div class="row wide"><label for="st-duration">duration</label><input id="st-duration" value={now.duration} placeholder="the model's" autocomplete="off" onInput={(e) => set({ duration: e.currentTarget.value })} /></div>
        </>
      ) : null}
      <div class="row wide">
        <label for="st-limit" title="Find the largest value of one key with which every check is passed, for every combination of the others: the operability chart where that key is the wave height">largest that passes</label>
        <select id="st-limit" value={now.limit} onChange={(e) => set({ limit: e.currentTarget.value })}><option value="">no: every combination</option>{limits.map((key) => <option key={key} value={key}>{key}</option>)}</select>
      </div>
      <div class="row wide"><label for="st-gather">results</label><input id="st-gather" value={now.gather} placeholder="the usual ones" title="Results by their names in summary.json, parted by commas" autocomplete="off" onInput={(e) => set({ gather: e.currentTarget.value })} /></div>
      {changes.value.length ? <p class="note">The study is of the model as it is written. Values on the sliders count only after "Apply to model".</p> : null}
      {refused || (fault && keys.length) ? <p class="fault" role="alert">{refused || fault}</p> : null}
      <footer class="acts">
        <button type="submit" class="main" disabled={busy || fault !== null}>{busy ? 'Starting…' : now.limit ? `Find ${caseCount(now)} limits` : `Run ${caseCount(now)} cases`}</button>
        <button type="button" disabled={fault !== null} title="For the command line, or a cluster: overbend study study.yaml" onClick={() => download('study.yaml', new Blob([text()], { type: 'text/yaml' }))}>Study file</button>
      </footer>
    </form>
  );
}
