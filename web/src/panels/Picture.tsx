// The 3-D view with its buttons, legend and the values of what was picked.
import { useEffect, useRef, useState } from 'preact/hooks';
import { computed, effect, signal } from '@preact/signals';
import { css, niceRange } from '../logic/colour';
import { nearest } from '../logic/series';
import { numberIn, quantities, quantity, text, unitName } from '../logic/show';
import { tidy } from '../logic/units';
import { dragging, roundTrip } from '../state/live';
import { keyName, withoutPaths } from '../logic/findings';
import { leadToFault } from '../state/lead';
import { byPath, errors, hasModel, opened } from '../state/model';
import { colourBy, cursor, dialog, picked, theme, type ColourBy } from '../state/look';
import { tensionerState } from '../logic/tensioner';
import { histories, largestReaction, peakAt, shown as frame, valueAt } from '../state/animation';
import { envelopes, impacts, runName, select, selected } from '../state/runs';
import { shownStage } from '../state/operation';
import { calmLay, ofRun, shownDrawn, shownFailure, shownLay, shownScene } from '../state/shown';
import { chosenLine, mooredState, planShown, stage } from '../state/moorings';
import { poseAt } from '../logic/moorings';
import { partColours } from '../logic/operation';
import { shownViews } from '../logic/views';
import { LineValues } from './Moorings';
import { PlanView } from './PlanView';
import type { View3D } from '../view/view3d';

const flashTime = 0.7;
const debug = new URLSearchParams(location.search).has('debug');

/** Frames of a run hold tension and von Mises stress and nothing else. */
const inFrames = (key: ColourBy): boolean => key === 'effective_tension' || key === 'von_mises';
const coloured = (): ColourBy => (frame.value && !inFrames(colourBy.value) ? 'von_mises' : colourBy.value);

/** Reactions of the boxes at a time, as far as the run has their histories. */
function reactionsAt(t: number): Map<string, number> {
  const out = new Map<string, number>();
  for (const [name, series] of Object.entries(histories.value)) {
    const box = /^support\/(.*)\/reaction$/.exec(name)?.[1], value = box ? peakAt(series, t) : null;
    if (box && value !== null) out.set(box, value);
  }
  return out;
}

/** Ends of the legend: of the run where there is one, so that colours do not jump from frame to frame. */
function range(key: ColourBy, s = shownLay.value): [number, number] {
  const q = quantity(key)!;
  if (!s) return [0, 1];
  const band = key === 'utilisation' || key === 'checks' ? null : envelopes.value?.[key];
  const list = frame.value && band?.max ? [...band.max, ...(band.min ?? [])] : (s.pipe[key] as number[] | undefined) ?? [];
  let low = Infinity, high = -Infinity;
  for (const v of list) { low = Math.min(low, v); high = Math.max(high, v); }
  if (low > high) return [0, 1];
  return niceRange((key === 'effective_tension' ? low : 0) * q.factor, high * q.factor);
}

function Values() {
  const s = calmLay.value;
  const p = picked.value;
  const at = cursor.value;
  if (p?.kind === 'line') return <LineValues name={p.name} />;
  if (!s || s.pipe.s.length === 0 || (!p && at === null)) return null;
  if (p?.kind === 'roller') {
    const r = p.roller;
    return (
      <dl class="values"><div class="kv"><dt>{r.support.name}, row {r.row + 1}</dt><dd>{r.position}</dd></div>
        <div class="kv"><dt>reaction</dt><dd>{numberIn(r.reaction, 'N')} <small>{unitName('N')}</small></dd></div>
        {r.separation > 0 && r.reaction > 0 ? null : <div class="kv"><dt>{r.separation > 0 ? 'clear by' : 'pressed in'}</dt><dd>{numberIn(Math.abs(r.separation), 'mm', 3)} <small>{unitName('mm')}</small></dd></div>}</dl>
    );
  }
  const i = p?.kind === 'station' && at === null ? p.index : nearest(s.pipe.s, at ?? 0);
  return (
    <dl class="values">
      <div class="kv"><dt>s from tensioner</dt><dd>{tidy(s.pipe.s[i]!, 5)} <small>m</small></dd></div>
      <div class="kv"><dt>height</dt><dd>{tidy(s.pipe.z[i]!, 4)} <small>m</small></dd></div>
      {quantities.filter((q) => s.pipe[q.key]?.length).map((q) => <div key={q.key} class="kv"><dt>{q.name.toLowerCase().replace('effective ', '').replace('bending moment', 'moment').replace('von mises stress', 'von Mises').replace('utilisation of ', '')}</dt><dd>{tidy((s.pipe[q.key] as number[])[i]! * q.factor, 4)} <small>{q.unit === '–' ? '' : q.unit}</small></dd></div>)}
    </dl>
  );
}

/** Diameter of the cable, of that of the pipe. */
function cableThickness(): number {
  const cable = byPath.value.get('operation.cable.diameter')?.si, pipe = shownScene.value?.pipe.outer_radius;
  return cable && pipe ? cable / (2 * pipe) : 0.3;
}

/** Impacts that light up at the moment. */
const flashing = signal(0);
const animating = computed(() => frame.value !== null);

/** For those who measure: the address with &debug. */
function Speed() {
  return <span class="speed" title="Time from asking for a solution to its arrival">{roundTrip.value ? `${Math.round(roundTrip.value)} ms` : ''}</span>;
}

export function Picture() {
  const box = useRef<HTMLDivElement>(null);
  const view = useRef<View3D | null>(null);
  const [problem, setProblem] = useState('');
  const [ready, setReady] = useState(false);

  useEffect(() => {
    let gone = false;
    const stops: (() => void)[] = [];
    void import('../view/view3d').then(({ View3D }) => {
      if (gone || !box.current) return;
      let v: View3D;
      try { v = new View3D(box.current); } catch { setProblem('This browser shows no 3-D pictures (WebGL is off). Numbers and diagrams work all the same.'); return; }
      view.current = v;
      (window as unknown as { __view: View3D }).__view = v;
      v.onPick = (p) => { picked.value = p; chosenLine.value = p?.kind === 'line' ? p.name : null; cursor.value = p?.kind === 'station' ? shownLay.value?.pipe.s[p.index] ?? null : null; };
      v.onHover = (i) => { if (i === null && picked.value !== null && picked.value.kind !== 'roller') return; if (i !== null) picked.value = null; cursor.value = i === null ? null : shownLay.value?.pipe.s[i] ?? null; };
      stops.push(
        effect(() => v.setDark(theme.value === 'dark')),
        effect(() => { void opened.value; v.reset(); }),
        effect(() => { if (shownScene.value) v.setScene(shownScene.value); }),
        effect(() => v.setDragging(dragging.value)),
        effect(() => {
          const state = mooredState.value, lay = shownLay.value, drawn = shownDrawn.value;
          v.setStage(stage.value >= 0 && state && lay?.moorings && drawn ? { state, pose: poseAt(drawn, state.vessel) } : null);
        }),
        effect(() => v.choose(chosenLine.value)),
        effect(() => { const parts = ofRun.value ? null : shownStage.value?.parts ?? null; v.setParts(parts ? { parts, cable: cableThickness() } : null); }),
        effect(() => { if (shownLay.value) v.setSolution(shownLay.value); }),
        effect(() => {
          const f = frame.value;
          const flashes = f ? impacts.value.filter((i) => i.time <= f.time && f.time < i.time + flashTime).map((i) => ({ ...i, strength: Math.min(1, i.peak_force / (impacts.value[0]?.peak_force || 1)) * (1 - (f.time - i.time) / flashTime) })) : [];
          const h = histories.value, state = f ? tensionerState(peakAt(h['tensioner/state'], f.time)) : null;
          const tensioner = f && state ? { way: state.way, limit: state.limit, travel: valueAt(h['tensioner/travel'], f.time) ?? 0 } : null;
          v.setMoment(f ? { time: f.time, pose: f.pose, places: f.places, flashes, reactions: reactionsAt(f.time), largest: largestReaction.value, tensioner, lines: f.lines } : null);
          flashing.value = flashes.length;
        }),
        effect(() => {
          const s = shownLay.value;
          if (!s) return;
          const key = coloured(), q = quantity(key)!;
          const [low, high] = range(key);
          const f = frame.value;
          const values = f ? (key === 'effective_tension' ? f.effective_tension : f.von_mises) : (s.pipe[key] as number[] | undefined) ?? null;
          v.setColouring({ values: shownFailure.value && !f ? null : values, low: low / q.factor, high: high / q.factor });
        }),
        effect(() => {
          const s = shownLay.value, at = cursor.value;
          v.setCursor(s && at !== null && !frame.value ? nearest(s.pipe.s, at) : null);
        }),
      );
      setReady(true);
    });
    return () => { gone = true; stops.forEach((f) => f()); view.current?.dispose(); view.current = null; };
  }, []);

  const animated = animating.value;
  const key = animated && !inFrames(colourBy.value) ? 'von_mises' : colourBy.value;
  const [low, high] = range(key, calmLay.value);
  const q = quantity(key)!;
  const bad = shownFailure.value;
  const lay = calmLay.value;
  const views = shownViews(lay);
  const moored = lay?.moorings != null, laid = !planShown.value && (lay === null || lay.pipe.s.length > 0);
  const known = calmLay.value !== null;
  const largest = animated ? largestReaction.value : Math.max(0, ...(calmLay.value?.supports ?? []).flatMap((x) => x.rollers.map((r) => r.reaction)));
  return (
    <section class={`picture${bad ? ' failed' : ''}`} aria-label="3-D view">
      <div class="canvas" ref={box} tabIndex={0} role="img" aria-label={`Barge, stinger, pipe, moorings, water and seabed. Keys 1 to ${views.length} change the view.`}
        onKeyDown={(e) => { const v = views.find((x) => x[1] === e.key); if (v) { planShown.value = false; view.current?.go(v[0]); } }} />
      {planShown.value ? <PlanView /> : null}
      <div class="viewbuttons" role="toolbar" aria-label="Views">
        {views.map(([name, key]) => <button key={name} type="button" title={`View: ${name} (key ${key} in the 3-D view)`} disabled={!ready || !known} onClick={() => { planShown.value = false; view.current?.go(name); }}>{name}</button>)}
        {moored ? <button type="button" aria-pressed={planShown.value} title="Plan of vessel and moorings, north up" onClick={() => { planShown.value = !planShown.value; }}>plan</button> : null}
      </div>
      {laid ? <div class="legend" data-flashes={animated ? flashing.value : undefined}>
        <select aria-label="Colour of the pipe" title={animated ? 'A run stores tension and von Mises stress for its animation; the other quantities are in the diagrams.' : undefined} value={key} onChange={(e) => { colourBy.value = e.currentTarget.value as ColourBy; }}>
          {quantities.filter((x) => x.key !== 'bending_moment').map((x) => <option key={x.key} value={x.key} disabled={animated && !inFrames(x.key as ColourBy)}>{x.name}{animated && !inFrames(x.key as ColourBy) ? ' (not in animations)' : ''}</option>)}
        </select>
        <div class="ramp" style={{ background: css('stress') }} />
        <div class="ends"><span>{tidy(low, 3)}</span><span>{tidy((low + high) / 2, 3)}</span><span>{tidy(high, 3)} {q.unit === '–' ? '' : q.unit}</span></div>
        <div class="rollerkey">{animated && !largest ? 'no reactions in this run' : <><i class="solid" style={{ background: css('load') }} /> {animated ? 'box' : 'roller'}{largest ? `, to ${text(largest, 'N', 3)}` : ' carries'} <span><i class={animated ? 'pale' : 'hollow'} /> clear</span></>}</div>
        {!ofRun.value && shownStage.value?.parts ? <div class="rollerkey"><i style={{ background: partColours(theme.value === 'dark').head }} /> head <span><i style={{ background: partColours(theme.value === 'dark').cable }} /> cable</span></div> : null}
      </div> : null}
      {ofRun.value && selected.value ? <div class="whose" title={runName(selected.value)}>run: <b>{runName(selected.value)}</b> <button type="button" class="tiny" aria-label="Back to the model" title="Back to the model" onClick={() => select(null)}>✕</button></div> : null}
      {planShown.value ? null : <Values />}
      {bad ? <div class="failure" role="alert"><b>{bad.what || 'No solution'}{bad.where ? `: ${bad.where}` : ''}</b><p>{withoutPaths(bad.why)}</p>{errors.value[0] ? <button type="button" onClick={() => leadToFault(errors.value[0]!)}>Show {errors.value[0].key ? keyName(errors.value[0].key) : `line ${errors.value[0].line}`}</button> : null}{known ? <p class="brief">The last valid solution is shown in grey.</p> : null}</div> : null}
      {problem ? <p class="failure">{problem}</p> : null}
      {!hasModel.value ? <div class="welcome"><h2>New pipelay model</h2><p>Answer a few questions to see the lay at once, or open an example.</p><button type="button" class="main" onClick={() => { dialog.value = 'start'; }}>New model…</button></div> : null}
      {debug ? <Speed /> : null}
    </section>
  );
}
