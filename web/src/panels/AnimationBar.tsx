// Playback of a run under the picture: time, speed, events, extremes, and the state of the tensioner.
import { nextEvent, worstImpact, type RunEvent } from '../logic/events';
import { tensionerState } from '../logic/tensioner';
import { fixedIn, text, unitName } from '../logic/show';
import { byPath } from '../state/model';
import { active, close, first, histories, last, peakAt, playing, seek, shown, speed, time, valueAt } from '../state/animation';
import { events, extremes, goToExtreme, goToNext, goToWorstImpact } from '../state/events';
import { impacts, select } from '../state/runs';
import '../styles/playback.css';

/** Position of the tension relative to the tension range of the model, for runs without a history of the tensioner. */
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
      {state ? <span class={`tag ${state.tone}`} title="State of the tensioner">tensioner {state.label}</span> : null}
      {tension !== null ? <span class={`reading${range?.[1] === 'bad' ? ' out' : ''}`} title={range ? `Tension, ${range[0]}` : 'Tension'}>{text(tension, 'N')}</span> : null}
      {travel !== null ? (
        <span class="reading" title="Pipe paid out by the tensioner, negative if hauled in"><small>travel</small> {fixedIn(travel, 'm', 2)} {unitName('m')}</span>
      ) : null}
    </span>
  );
}

/** Buttons to the events around the time shown. */
function EventButtons() {
  const all = events.value, t = time.value;
  const next = nextEvent(all, t, 1), before = nextEvent(all, t, -1), impact = nextEvent(all, t, 1, 'impact');
  const worst = worstImpact(impacts.value);
  return (
    <>
      {all.length ? (
        <>
          <button
            type="button"
            aria-label="Previous event"
            title={before ? `Previous event: ${before.name}, at ${before.time.toFixed(1)} s` : 'No earlier event'}
            disabled={!before}
            onClick={() => goToNext(-1)}
          >
            ‹
          </button>
          <button type="button" class="next" title={next ? `${next.name}, at ${next.time.toFixed(1)} s` : 'No later event'} disabled={!next} onClick={() => goToNext(1)}>
            {next ? <>next event<span class="what">: {next.name}</span></> : 'no later event'}
          </button>
        </>
      ) : null}
      {worst ? (
        <>
          <button
            type="button"
            title={impact ? `Next impact: ${impact.object}, at ${impact.time.toFixed(1)} s` : 'No later impact'}
            disabled={!impact}
            onClick={() => goToNext(1, 'impact')}
          >
            next impact
          </button>
          <button type="button" title={`${text(worst.peak_force, 'N', 4)} on ${worst.support}, at ${worst.time.toFixed(1)} s`} onClick={goToWorstImpact}>worst impact</button>
        </>
      ) : null}
    </>
  );
}

/** Menu of the maximum or minimum of any history. */
function Extremes() {
  const list = extremes.value;
  if (list.length === 0) return null;
  return (
    <select
      aria-label="Go to extreme of"
      title="Go to the maximum or minimum of a history"
      value=""
      onChange={(e) => { const chosen = list[Number(e.currentTarget.value)]; e.currentTarget.value = ''; if (chosen) void goToExtreme(chosen); }}
    >
      <option value="">max / min of …</option>
      {([1, -1] as const).map((sign) => (
        <optgroup key={sign} label={sign > 0 ? 'Maximum' : 'Minimum'}>
          {list.map((w, i) => (w.sign === sign ? <option key={i} value={String(i)} title={w.column.text}>{w.name}</option> : null))}
        </optgroup>
      ))}
    </select>
  );
}

const mostMarks = 200;

/** Events along the time axis, above the slider; impacts by their force. */
function Marks() {
  const [low, high] = [first.value, last.value];
  if (!(high > low)) return null;
  const worst = worstImpact(impacts.value)?.peak_force ?? 1;
  const weight = (event: RunEvent): number => (event.impact ? event.impact.peak_force / worst : 1);
  const marked = events.value.slice().sort((a, b) => weight(b) - weight(a)).slice(0, mostMarks);
  return (
    <span class="eventmarks" aria-hidden="true">
      {marked.map((event, i) => <i key={i} class={event.kind} style={{ left: `${(100 * (event.time - low)) / (high - low)}%`, height: `${20 + 80 * weight(event)}%` }} />)}
    </span>
  );
}

function Slider() {
  return (
    <input
      type="range"
      aria-label="Time"
      min={first.value}
      max={last.value}
      step={0.05}
      value={time.value}
      aria-valuetext={`${time.value.toFixed(1)} s`}
      onInput={(e) => seek(Number(e.currentTarget.value))}
    />
  );
}

const Clock = () => <output class="clock">{time.value.toFixed(1)} s <small>of {last.value.toFixed(0)} s</small></output>;
const Loading = () => (shown.value ? null : <span class="brief">loading…</span>);

/** Only the parts that show the time are drawn again during playback. */
export function AnimationBar() {
  if (!active.value) return null;
  return (
    <div class="animation" role="group" aria-label="Animation">
      <button type="button" class="main" aria-label={playing.value ? 'Pause' : 'Play'} onClick={() => { playing.value = !playing.value; }}>{playing.value ? '❚❚' : '▶'}</button>
      <select aria-label="Speed" value={String(speed.value)} onChange={(e) => { speed.value = Number(e.currentTarget.value); }}>
        {[0.1, 0.25, 0.5, 1, 2, 5, 10, 30].map((v) => <option key={v} value={String(v)}>{v} ×</option>)}
      </select>
      <span class="timeline"><Marks /><Slider /></span>
      <Clock />
      <span class="jumps"><EventButtons /><Extremes /></span>
      <Readings />
      <button type="button" class="tiny" aria-label="Back to statics" title="Back to statics" onClick={() => { close(); select(null); }}>✕</button>
      <Loading />
    </div>
  );
}
