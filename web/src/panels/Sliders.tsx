// Sliders that re-solve while they are dragged. Every one has a field for typing, which takes any unit.
import { useComputed } from '@preact/signals';
import { useEffect, useState } from 'preact/hooks';
import { span } from '../logic/live';
import { fromSi, parseQuantity, tidy, toSi, twin } from '../logic/units';
import { shownScene } from '../state/shown';
import { applyLive, base, changes, resetLive, setLive, values } from '../state/live';

interface Props { id: string; name: string; unit: string; start: number; low: number; high: number; step: number; relative?: boolean }

/** All values in the unit shown; `start` is the model's own. */
function Slider({ id, name, unit, start, low, high, step }: Props) {
  const live = useComputed(() => values.value[id]).value;
  const factor = unit === '%' ? 0.01 : toSi(1, unit);
  const now = live === undefined ? start : live / factor;
  const written = `${tidy(now, 5)} ${unit}`;
  const [typed, setTyped] = useState(written);
  useEffect(() => setTyped(written), [written]);
  const set = (v: number): void => setLive(id, Math.abs(v - start) < 1e-9 ? undefined : v * factor);
  const send = (): void => {
    const q = parseQuantity(typed);
    const v = q ? (unit === '%' ? q.number : fromSi(toSi(q.number, q.unit || unit), unit)) : Number.NaN;
    if (Number.isFinite(v)) set(v); else setTyped(written);
  };
  return (
    <div class={`slider${live === undefined ? '' : ' moved'}`}>
      <label for={`s-${id}`}>{name}</label>
      <input class="typed" data-written={written} aria-label={`${name}, typed`} title={twin(written)} value={typed} onInput={(e) => setTyped(e.currentTarget.value)} onBlur={send} onKeyDown={(e) => { if (e.key === 'Enter') send(); }} />
      <input id={`s-${id}`} type="range" min={Math.min(low, now)} max={Math.max(high, now)} step={step} value={now}
        aria-valuetext={written} onInput={(e) => set(Number(e.currentTarget.value))} onDblClick={() => setLive(id, undefined)} />
    </div>
  );
}

function round(v: number): number { return Number(v.toPrecision(6)); }

function Apply() {
  const none = useComputed(() => changes.value.length === 0).value;
  return (
    <div class="apply">
      <button type="button" class="main" disabled={none} onClick={() => void applyLive()}>Apply to model</button>
      <button type="button" disabled={none} onClick={resetLive}>Reset</button>
    </div>
  );
}

export function Sliders() {
  const b = base.value;
  const boxes = b.boxes;
  const ranged = (value: number, low: number, high: number): { low: number; high: number } => { const [l, h] = span(value, low, high); return { low: l, high: h }; };
  return (
    <section class="sliders" aria-label="Try out">
      <h2>Try out <small>drag to see the effect</small></h2>
      {b.tension !== null ? <Slider id="tension" name="tension" unit="kN" start={round(b.tension / 1e3)} {...ranged(b.tension / 1e3, 0.4, 2.5)} step={b.tension > 1e6 ? 5 : 1} /> : null}
      {b.depth !== null ? <Slider id="depth" name="water depth" unit="m" start={round(b.depth)} {...ranged(b.depth, 0.5, 1.6)} step={b.depth > 500 ? 5 : 0.5} /> : null}
      {b.radius !== null ? <Slider id="radius" name="stinger radius" unit="m" start={round(b.radius)} {...ranged(b.radius, 0.6, 2)} step={1} /> : null}
      {b.depth !== null && shownScene.value?.vessel !== null ? <Slider id="trim" name="trim" unit="deg" start={round(fromSi(b.trim, 'deg'))} low={-2} high={2} step={0.05} /> : null}
      {b.current.length ? <Slider id="current" name="current" unit="%" start={100} low={0} high={200} step={2} /> : null}
      {boxes.length ? (
        <details open>
          <summary>box heights</summary>
          {boxes.map((x) => <Slider key={x.key} id={x.key} name={x.name} unit="m" start={0} low={-0.5} high={0.5} step={0.01} relative />)}
        </details>
      ) : null}
      <Apply />
    </section>
  );
}
