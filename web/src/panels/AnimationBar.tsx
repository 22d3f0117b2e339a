// Time slider, speed and state of the tensioner under the picture.
import { tensionerState } from '../logic/tensioner';
import { fixedIn, text, unitName } from '../logic/show';
import { byPath } from '../state/model';
import { active, close, first, histories, last, peakAt, playing, seek, shown, speed, time, valueAt } from '../state/animation';
import { select } from '../state/runs';

/** Where the tension lies in the operational range of the model, for runs without a history of the tensioner. */
function place(tension: number | null): [string, string] | null {
  const low = byPath.value.get('tensioner.range[0]')?.si, high = byPath.value.get('tensioner.range[1]')?.si;
  if (tension === null || typeof low !== 'number' || typeof high !== 'number') return null;
  if (tension > high) return ['above its range', 'bad'];
  if (tension < low) return ['below its range', 'bad'];
  return ['in its range', 'good'];
}

function Readings() {
  const h = histories.value, t = time.value;
  const tension = valueAt(h['tensioner/tension'] ?? h['top_tension'], t), travel = valueAt(h['tensioner/travel'], t);
  const state = tensionerState(peakAt(h['tensioner/state'], t));
  const range = place(tension);
  return (
    <span class="readings">
      {state ? <span class={`tag ${state.tone}`} title="What the tensioner does">tensioner {state.words}</span> : null}
      {tension !== null ? <span class={`reading${range?.[1] === 'bad' ? ' out' : ''}`} title={range ? `Tension, ${range[0]}` : 'Tension'}>{text(tension, 'N')}</span> : null}
      {travel !== null ? <span class="reading" title="Pipe paid out by the tensioner, hauled in negative"><small>travel</small> {fixedIn(travel, 'm', 2)} {unitName('m')}</span> : null}
    </span>
  );
}

export function AnimationBar() {
  if (!active.value) return null;
  return (
    <div class="animation" role="group" aria-label="Animation">
      <button type="button" class="main" aria-label={playing.value ? 'Pause' : 'Play'} onClick={() => { playing.value = !playing.value; }}>{playing.value ? '❚❚' : '▶'}</button>
      <input type="range" aria-label="Time" min={first.value} max={last.value} step={0.05} value={time.value} aria-valuetext={`${time.value.toFixed(1)} s`} onInput={(e) => seek(Number(e.currentTarget.value))} />
      <output class="clock">{time.value.toFixed(1)} s</output>
      <select aria-label="Speed" value={String(speed.value)} onChange={(e) => { speed.value = Number(e.currentTarget.value); }}>
        {[0.1, 0.25, 0.5, 1, 2, 5, 10, 30].map((v) => <option key={v} value={String(v)}>{v} ×</option>)}
      </select>
      <Readings />
      <button type="button" class="tiny" aria-label="Back to statics" title="Back to statics" onClick={() => { close(); select(null); }}>✕</button>
      {shown.value ? null : <span class="brief">loading…</span>}
    </div>
  );
}
