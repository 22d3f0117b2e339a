// The bar under the picture: every pinned key as a slider with live statics, and the commands for trial values.
import { useComputed } from '@preact/signals';
import { useRef, useState } from 'preact/hooks';
import { passSentence, type PassInterval } from '../logic/passRange';
import { parseQuantity, sameFamily, toSi, twin } from '../logic/units';
import { gridStep, onStep, pace, paceFactor, variableStep, variableText, type Variable } from '../logic/variables';
import { leadTo } from '../state/lead';
import { applyLive, changes, resetLive, setLive, values } from '../state/live';
import { hasModel } from '../state/model';
import { removePin, sliders, type Slider } from '../state/pins';
import { passRange } from '../state/ranges';
import { openSeek } from '../state/seek';
import { openMenu, type MenuItem } from './Menu';
import { openPinEnds, openPinSearch, PinEnds, PinSearch } from './PinDialogs';
import '../styles/numbers.css';
import { useUpdate } from './useUpdate';

const isKey = (id: string): boolean => !id.includes(' ');

function commands({ variable }: Slider): MenuItem[] {
  return [
    { name: 'Unpin', act: () => removePin(variable.id) },
    { name: 'Slider range …', act: () => openPinEnds(variable.id) },
    { name: 'Back to the model\'s value', disabled: values.value[variable.id] === undefined, act: () => setLive(variable.id, undefined) },
    ...(isKey(variable.id) ? [
      { name: 'Goal seek …', act: () => openSeek({ key: variable.id }) },
      { name: 'Show in properties', act: () => leadTo(variable.id) },
    ] : []),
  ];
}

/** Typed text as an SI value: a bare number takes the unit shown, another unit must be of the same kind. */
function typedValue(text: string, variable: Variable): number {
  const q = parseQuantity(text);
  if (!q) return Number.NaN;
  if (!q.unit || q.unit === variable.unit) return q.number * variable.scale;
  return sameFamily(q.unit, variable.unit) ? toSi(q.number, q.unit) : Number.NaN;
}

function Strip({ intervals, low, high }: { intervals: readonly PassInterval[]; low: number; high: number }) {
  const part = (si: number): number => 100 * Math.min(1, Math.max(0, (si - low) / (high - low)));
  return (
    <div class="strip" role="presentation">
      {intervals.map((i) => <i key={i.from} style={{ left: `${part(i.from)}%`, width: `${Math.max(1, part(i.to) - part(i.from))}%` }} />)}
    </div>
  );
}

function PinSlider({ slider }: { slider: Slider }) {
  const { variable } = slider, id = variable.id;
  const live = useComputed(() => values.value[id]).value;
  const intervals = useComputed(() => passRange(id)).value;
  const value = live ?? variable.si, written = variableText(variable, value);
  const [typed, setTyped] = useState(written);
  const place = useRef<HTMLDivElement>(null);
  useUpdate(() => setTyped(written), [written]);

  const step = variableStep(variable);
  const low = Math.min(slider.low, value), high = Math.max(slider.high, value);
  const set = (si: number): void => setLive(id, Math.abs(si - variable.si) < 1e-6 * step * variable.scale ? undefined : si);
  const send = (): void => {
    if (typed === written) return;
    const si = typedValue(typed, variable);
    if (Number.isFinite(si)) set(si); else setTyped(written);
  };
  const arrows = (event: KeyboardEvent): void => {
    const up = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    if (event.key === 'Escape' && live !== undefined) { event.stopPropagation(); setLive(id, undefined); }
    if (up === undefined) return;
    event.preventDefault();
    const paced = step * paceFactor[pace(event)];
    set(onStep(variable, value + up * paced * variable.scale, gridStep(variable, event)));
  };
  const open = (x: number, y: number): void => openMenu(commands(slider), x, y);
  const text = (si: number): string => variableText(variable, si, 4);
  const sentence = intervals ? passSentence(intervals, text) : '';
  const back = live === undefined ? '' : `model value ${variableText(variable, variable.si)}, double-click to reset`;
  return (
    <div ref={place} class={`pin${live === undefined ? '' : ' moved'}`} title={[isKey(id) ? id : '', sentence, back].filter(Boolean).join('\n')}
      onContextMenu={(e) => { e.preventDefault(); open(e.clientX, e.clientY); }}>
      <label for={`s-${id}`}>{variable.name}</label>
      <button type="button" class="tiny more" aria-label={`Commands of ${variable.name}`} aria-haspopup="menu"
        onClick={() => { const box = place.current!.getBoundingClientRect(); open(box.left, box.top); }}>⋯</button>
      <input class="typed" data-written={written} aria-label={`${variable.name}, typed`} title={twin(written)} value={typed} style={{ width: `${Math.max(6, written.length) + 1}ch` }}
        onInput={(e) => setTyped(e.currentTarget.value)} onBlur={send} onKeyDown={(e) => { if (e.key === 'Enter') send(); if (e.key === 'Escape') setTyped(written); }} />
      <div class="track">
        {intervals ? <Strip intervals={intervals} low={low} high={high} /> : null}
        <input id={`s-${id}`} type="range" min={low / variable.scale} max={high / variable.scale} step="any" value={value / variable.scale} style={{ '--part': `${(100 * (value - low)) / (high - low)}%` }}
          aria-valuetext={sentence ? `${written}, ${sentence}` : written}
          onInput={(e) => set(onStep(variable, Number(e.currentTarget.value) * variable.scale, step))}
          onKeyDown={arrows} onDblClick={() => setLive(id, undefined)} />
      </div>
    </div>
  );
}

function TriedOut() {
  const count = useComputed(() => changes.value.length).value;
  if (count === 0) return null;
  return (
    <div class="apply" role="group" aria-label="Trial values">
      <button type="button" class="main" title="Write the trial values into the model, in one step" onClick={() => void applyLive()}>Apply to model</button>
      <button type="button" title="Reset to the values of the model" onClick={resetLive}>Reset</button>
    </div>
  );
}

export function PinnedBar() {
  if (!hasModel.value) return null;
  return (
    <section class="pinned" aria-label="Try out">
      <div class="pins">{sliders.value.map((slider) => <PinSlider key={slider.variable.id} slider={slider} />)}</div>
      <TriedOut />
      <button type="button" onClick={openPinSearch}>Pin a key</button>
      <button type="button" onClick={() => openSeek()}>Goal seek …</button>
      <PinSearch />
      <PinEnds />
    </section>
  );
}
