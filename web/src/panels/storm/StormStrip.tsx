// Storm settings above the picture: each as a button that shows its value, and Run with a summary.
import { useState } from 'preact/hooks';
import { Popover } from '../../components/Popover';
import { duration as timeText } from '../../logic/show';
import { directionText, expectedSeconds, motionText, seaText, seedsTyped, tensionerText } from '../../logic/storm';
import { changes } from '../../state/live';
import { leadToDiagnostic } from '../../state/lead';
import { byPath, errors, hasModel } from '../../state/model';
import { duration, missing, pace, seeds, setUpStorm, startStorm, stormKind, stormKinds, type StormKind } from '../../state/storm';
import { DirectionFields, DurationFields, MotionFields, SeaFields, SeedsFields, TensionerFields } from './StripFields';
import '../../styles/storm.css';

const written = (path: string): string => { const field = byPath.value.get(path); return field?.given ? String(field.value ?? '') : ''; };

/** Whole hours and minutes without decimals, for any unit in the model. */
function durationText(): string {
  const text = written('analysis.dynamic.duration'), s = duration.value;
  if (!text || !(s >= 600) || s % 60 !== 0) return text;
  return s % 3600 === 0 ? `${s / 3600} h` : `${s / 60} min`;
}

/** Number of runs: seeds of a storm, variants of a comparison. */
const runCount = (): number => (stormKind.value === 'storm' ? seeds.value.length : stormKind.value === 'tensioner' ? 3 : 2);

/** "Run 10 × 3 h". */
function runText(): string {
  const count = runCount(), length = durationText();
  const name = stormKinds.find(([id]) => id === stormKind.value)![2];
  return stormKind.value === 'storm' ? `Run ${count > 1 ? `${count} × ` : ''}${length}` : `${name}, ${length}`;
}

function timeNeeded(): string {
  const expected = expectedSeconds(pace.value, duration.value + (byPath.value.get('analysis.dynamic.build_up')?.si ?? 60), runCount());
  return expected === null ? '' : `, about ${timeText(Math.max(1, expected))}`;
}

function SetUp() {
  const [busy, setBusy] = useState(false);
  const start = (): void => { setBusy(true); void setUpStorm().finally(() => setBusy(false)); };
  const title = `Adds ${missing.value.join(', ')}: JONSWAP sea with Hs 2 m and Tp 8 s on the bow, the library hull scaled to the vessel, 3 h. One undo step.`;
  return <button type="button" class="main" disabled={busy} title={title} onClick={start}>Set up a storm</button>;
}

function RunButton() {
  const error = errors.value[0];
  const choose = (kind: string): void => { stormKind.value = kind as StormKind; };
  if (missing.value.length) return <SetUp />;
  return (
    <>
      <span class="runbutton">
        <button type="button" class="main" disabled={error !== undefined} onClick={() => void startStorm()}>{runText()}{timeNeeded()}</button>
        <select aria-label="Type of run" title="Type of run" value={stormKind.value} onChange={(e) => choose(e.currentTarget.value)}>
          {stormKinds.map(([id, text]) => <option key={id} value={id}>{text}</option>)}
        </select>
      </span>
      {error ? <button type="button" class="link" onClick={() => leadToDiagnostic(error)}>error at {error.key || `line ${error.line}`}</button> : null}
    </>
  );
}

export function StormStrip() {
  if (!hasModel.value) return null;
  const motion = motionText(byPath.value), tensioner = tensionerText(byPath.value);
  const has = (group: string): boolean => byPath.value.get(group)?.given === true;
  return (
    <div class="stormstrip" role="group" aria-label="Storm">
      <Popover label="sea" value={seaText(byPath.value)} placeholder="no waves yet"><SeaFields /></Popover>
      <Popover label="from" value={directionText(byPath.value)}><DirectionFields /></Popover>
      {has('vessel') ? <Popover label="motion" value={motion.text} note={motion.note} placeholder="not given" wide><MotionFields /></Popover> : null}
      {has('tensioner') ? <Popover label="tensioner" value={tensioner.text} note={tensioner.note}><TensionerFields /></Popover> : null}
      <Popover label="duration" value={durationText()} placeholder="not given"><DurationFields /></Popover>
      <Popover label="seeds" value={seedsTyped(seeds.value)}><SeedsFields /></Popover>
      <div class="stormacts"><RunButton /></div>
      {changes.value.length ? <p class="note">A run uses the model as written: slider values are included after "Apply to model".</p> : null}
      {motion.note ? <p class="brief">{motion.note}</p> : null}
    </div>
  );
}
