// Starts a run: one, several seeds, or variants of the model beside each other.
import { useEffect, useState } from 'preact/hooks';
import { parseSeeds } from '../logic/runs';
import { duration as inWords } from '../logic/show';
import { parseQuantity, toSi } from '../logic/units';
import { changes } from '../state/live';
import { leadToFault } from '../state/lead';
import { byPath, errors, hasModel } from '../state/model';
import { startRun, type Order } from '../state/runs';

const kinds = [['dynamic', 'One run'], ['seeds', 'Several seeds'], ['tensioner', 'Compare tensioner modes'], ['contact', 'Compare contact models'], ['impacts', 'Compare impacts resolved and captured']] as const;
type Kind = (typeof kinds)[number][0];

/** As the model gives them: a number of seeds, or a list. */
function givenSeeds(): string {
  const given = byPath.value.get('analysis.dynamic.seeds');
  if (typeof given?.value === 'number' || typeof given?.value === 'string') return `1-${given.value}`;
  const list: string[] = [];
  for (let i = 0; byPath.value.has(`analysis.dynamic.seeds[${i}]`); ++i) list.push(String(byPath.value.get(`analysis.dynamic.seeds[${i}]`)!.value));
  return list.length > 1 ? list.join(', ') : '1-5';
}

function orderOf(kind: Kind, duration: number, seeds: number[] | null): Order {
  if (kind === 'seeds') return { kind: 'seeds', duration, seeds: seeds ?? [] };
  return kind === 'dynamic' ? { kind, duration } : { kind: 'comparison', of: kind, duration };
}

export function StartRun() {
  const given = byPath.value.get('analysis.dynamic.duration');
  const [kind, setKind] = useState<Kind>('dynamic');
  const offered = givenSeeds();
  const lasting = given?.value ? String(given.value) : '120 s';
  const [typed, setTyped] = useState(lasting);
  const [typedSeeds, setTypedSeeds] = useState(offered);
  useEffect(() => { setTyped(lasting); }, [lasting]);
  useEffect(() => { setTypedSeeds(offered); }, [offered]);
  const q = parseQuantity(typed);
  const seconds = q ? (q.unit ? toSi(q.number, q.unit) : q.number) : Number.NaN;
  const good = Number.isFinite(seconds) && seconds > 0;
  const seeds = parseSeeds(typedSeeds);
  const goodSeeds = kind !== 'seeds' || (seeds !== null && seeds.length > 1);
  const first = errors.value[0];
  const ready = hasModel.value && !first;
  return (
    <form class="startrun" onSubmit={(e) => { e.preventDefault(); if (good && goodSeeds && ready) void startRun(orderOf(kind, seconds, seeds)); }}>
      <h3>Dynamic run</h3>
      <div class="row">
        <label for="run-kind">what</label>
        <select id="run-kind" value={kind} onChange={(e) => setKind(e.currentTarget.value as Kind)}>{kinds.map(([id, name]) => <option key={id} value={id}>{name}</option>)}</select>
      </div>
      <div class="row">
        <label for="run-duration">duration</label>
        <input id="run-duration" value={typed} aria-invalid={!good} onInput={(e) => setTyped(e.currentTarget.value)} />
        <span class="twin">{good ? inWords(seconds) : ''}</span>
        {good ? null : <p class="fault">A time, like "600 s" or "3 h".</p>}
      </div>
      {kind === 'seeds' ? (
        <div class="row">
          <label for="run-seeds">seeds</label>
          <input id="run-seeds" value={typedSeeds} aria-invalid={!goodSeeds} onInput={(e) => setTypedSeeds(e.currentTarget.value)} />
          <span class="twin">{goodSeeds && seeds ? `${seeds.length} runs` : ''}</span>
          {goodSeeds ? null : <p class="fault">Two seeds at least, each once, like "1-5" or "3, 7, 12".</p>}
        </div>
      ) : null}
      {changes.value.length ? <p class="note">The run computes the model as it is written. Values on the sliders count only after "Apply to model".</p> : null}
      {first ? <p class="fault">The model has an error at <button type="button" class="link" onClick={() => leadToFault(first)}>{first.key || `line ${first.line}`}</button>; a run needs it mended.</p> : null}
      <div class="acts">
        <button type="submit" class="main" disabled={!ready || !good || !goodSeeds}>Start run</button>
        <button type="button" disabled={!ready} onClick={() => void startRun({ kind: 'static' })}>Static run with report</button>
      </div>
    </form>
  );
}
