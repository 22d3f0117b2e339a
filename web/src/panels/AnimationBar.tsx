// Time slider, speed and state of the tensioner under the picture.
import { useEffect, useState } from 'preact/hooks';
import { display } from '../logic/show';
import { tidy } from '../logic/units';
import { byPath } from '../state/model';
import type { Series } from '../api/types';
import { active, close, first, last, playing, seek, shown, speed, time, valueAt } from '../state/animation';
import { columns, fetchSeries, select, selected } from '../state/runs';

/** Histories worth a number while the animation runs. */
const wanted = /^(top_tension|travel|tensioner.*|elevation)$/;

function useReadings(): [string, string, Series][] {
  const [list, setList] = useState<[string, string, Series][]>([]);
  const run = selected.value;
  const names = columns.value.filter((c) => wanted.test(c.name)).slice(0, 4);
  useEffect(() => {
    if (!run || run.state !== 'done' || names.length === 0) { setList([]); return; }
    void fetchSeries(run.id, names.map((n) => n.name), null, null, 4000).then((answer) => setList(names.flatMap((n) => (answer[n.name] ? [[n.name, n.unit, answer[n.name]!] as [string, string, Series]] : [])))).catch(() => undefined);
  }, [run?.id, run?.state, names.length]);
  return list;
}

/** Where the tension lies in the operational range of the model. */
function tensionerState(tension: number | null): [string, string] | null {
  const low = byPath.value.get('tensioner.range[0]')?.si, high = byPath.value.get('tensioner.range[1]')?.si;
  if (tension === null || typeof low !== 'number' || typeof high !== 'number') return null;
  if (tension > high) return ['above range', 'bad'];
  if (tension < low) return ['below range', 'bad'];
  return ['in range', 'good'];
}

export function AnimationBar() {
  const readings = useReadings();
  if (!active.value) return null;
  const state = tensionerState(valueAt(readings.find((r) => r[0] === 'top_tension')?.[2], time.value));
  return (
    <div class="animation" role="group" aria-label="Animation">
      <button type="button" class="main" aria-label={playing.value ? 'Pause' : 'Play'} onClick={() => { playing.value = !playing.value; }}>{playing.value ? '❚❚' : '▶'}</button>
      <input type="range" aria-label="Time" min={first.value} max={last.value} step={0.05} value={time.value} aria-valuetext={`${time.value.toFixed(1)} s`} onInput={(e) => seek(Number(e.currentTarget.value))} />
      <output class="clock">{time.value.toFixed(1)} s</output>
      <select aria-label="Speed" value={String(speed.value)} onChange={(e) => { speed.value = Number(e.currentTarget.value); }}>
        {[0.1, 0.25, 0.5, 1, 2, 5, 10, 30].map((v) => <option key={v} value={String(v)}>{v} ×</option>)}
      </select>
      <span class="readings">
        {state ? <span class={`tag ${state[1]}`} title="Tension and the tensioner's operational range">tensioner {state[0]}</span> : null}
        {readings.map(([name, unit, series]) => {
          const v = valueAt(series, time.value);
          const [shownUnit, factor] = display(unit);
          return v === null ? null : <span key={name}><small>{name.replaceAll('_', ' ')}</small> {tidy(v * factor, 4)} {shownUnit === '–' ? '' : shownUnit}</span>;
        })}
      </span>
      <button type="button" class="tiny" aria-label="Back to statics" title="Back to statics" onClick={() => { close(); select(null); }}>✕</button>
      {shown.value ? null : <span class="brief">loading…</span>}
    </div>
  );
}
