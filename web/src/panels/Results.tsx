// Key results of statics.
import { numberIn, shownUnit, text, unitName } from '../logic/show';
import { tidy, tidyLength, twin } from '../logic/units';
import { calm, failure } from '../state/live';
import { bullet, bullets } from '../logic/findings';
import { cursor } from '../state/look';
import { diagnostics } from '../state/model';
import { stageName } from '../logic/operation';
import { chosenStage, shownStage, stageLay } from '../state/operation';
import type { KeyResults, Region, StingerSectionState, Verdict } from '../api/types';
import { LaidPipe, Route } from './Ground';
import { LineTable, MooringResults } from './Moorings';
import { Sensitivities } from './Sensitivities';
import { SeekButton } from './SeekDialog';
import { Findings } from './Findings';
import { Tables } from './Tables';

/** `result`: its path in summary.json, of a value that can be sought. */
export function Value({ name, value, unit, title, result }: { name: string; value: number | null | undefined; unit: string; title?: string; result?: string }) {
  if (value === null || value === undefined) return null;
  const shown = unitName(unit);
  return (
    <div class="kv" title={`${title ?? ''} ${twin(text(value, unit, 6))}`.trim()}>
      <dt>{name}{result ? <SeekButton goal={{ name, result, unit: shown, si: value }} /> : null}</dt><dd>{unit === 'm' ? tidyLength(value * shownUnit(unit).factor) : numberIn(value, unit)} <small>{shown}</small></dd>
    </div>
  );
}

function RegionBlock({ name, r }: { name: string; r: Region | null }) {
  if (!r || r.von_mises === 0) return null; // no steel there: a cable alone reaches the bed
  const level = r.utilisation > 1 ? 'over' : r.utilisation > 0.87 ? 'near' : 'good';
  return (
    <div class={`region ${level}`}>
      <button type="button" class="regionhead" title="Show the location" onClick={() => { cursor.value = r.s; }}>
        <span>{name}</span><b>{tidy(100 * r.utilisation, 3)} %</b><small> of yield</small>
      </button>
      <div class="bar" role="presentation"><i style={{ width: `${Math.min(100, 100 * r.utilisation)}%` }} /></div>
      <dl>
        <Value name="von Mises" value={r.von_mises} unit="Pa" result={`static.${name.toLowerCase()}.max_von_mises`} />
        <Value name="bending" value={r.bending_stress} unit="Pa" result={`static.${name.toLowerCase()}.max_bending_stress`} />
        <div class="kv"><dt>strain</dt><dd>{tidy(100 * r.strain, 3)} <small>%</small></dd></div>
      </dl>
    </div>
  );
}

/** The one verdict on what is shown, with its reasons. */
export function VerdictCard({ verdict }: { verdict: Verdict }) {
  return <div class={`verdict ${verdict.kind.replace(' ', '-')}`} title={verdict.because}><b>{verdict.words}</b></div>;
}

export function Results() {
  const s = stageLay.value ?? calm.value;
  if (!s) return <section class="results"><h2>Results</h2><p class="empty">{failure.value ? '' : 'Static results appear here as soon as the model is complete.'}</p></section>;
  const k = s.key;
  const ofModel = diagnostics.value.filter((d) => d.severity === 'warning').map((d) => bullet(d.message, [], d.key));
  return (
    <section class={`results${failure.value && !shownStage.value ? ' old' : ''}`} aria-label="Key results">
      <h2>Results {shownStage.value ? <small>stage {stageName(shownStage.value, chosenStage.value)}</small> : failure.value ? <small>last valid solution</small> : <small>statics</small>}</h2>
      {s.verdict && s.verdict.kind !== 'not judged' ? <VerdictCard verdict={s.verdict} /> : null}
      {k ? (
        <>
          <RegionBlock name="Overbend" r={k.overbend} />
          <RegionBlock name="Tower" r={k.tower} />
          <RegionBlock name="Sagbend" r={k.sagbend} />
          <KeyValues k={k} boxes={s.supports.length > 0} />
          {(s.stinger ?? []).map((one, i) => <Stinger key={i} section={one} only={s.stinger?.length === 1} index={i} />)}
          {s.seabed ? <LaidPipe bed={s.seabed} /> : null}
          {s.route ? <Route route={s.route} /> : null}
          <Sensitivities />
        </>
      ) : null}
      <MooringResults />
      <LineTable lines={s.lines} />
      <Findings list={[...ofModel, ...bullets(s.findings, s.supports.map((b) => b.name))]} />
      <Tables lay={s} />
    </section>
  );
}

/** One section of a stinger on hinges. Results of several are sought by their place in the list. */
function Stinger({ section, only, index }: { section: StingerSectionState; only: boolean; index: number }) {
  const path = only ? 'static.stinger' : `static.stinger.sections[${index}]`;
  return (
    <dl>
      <Value name={section.name ? `angle of ${section.name}` : 'stinger angle'} value={section.angle} unit="rad" result={`${path}.angle`} title="Positive when the tip goes down from where it is drawn." />
      <Value name="hinge force" value={section.hinge_force} unit="N" result={`${path}.hinge_force.magnitude`} />
      <Value name={section.at_stop ? 'moment of the stop' : 'holding moment'} value={section.stop_moment === 0 ? null : section.stop_moment} unit="N m" result={`${path}.stop_moment`} />
      <Value name="stinger period" value={section.natural_period > 0 ? section.natural_period : null} unit="s" title="Of small turns about the hinge." />
      <Value name="tank draught" value={section.tanks.length > 0 ? section.draught : null} unit="m" />
    </dl>
  );
}

function KeyValues({ k, boxes }: { k: KeyResults; boxes: boolean }) {
  return (
      <dl>
        <Value name="top tension" value={k.top_tension} unit="N" result="static.top_tension" />
        <Value name="bottom tension" value={k.bottom_tension} unit="N" result="static.bottom_tension" />
        <Value name="lay-back" value={k.lay_back} unit="m" result="static.lay_back" title="Horizontal distance from stern shoe to touchdown." />
        <Value name="departure angle" value={k.departure_angle} unit="rad" result="static.departure_angle" />
        <Value name="tip clearance" value={k.stinger_tip_clearance} unit="m" result="static.stinger_tip_clearance" title="Clearance of the pipe over the last stinger roller." />
        <Value name="stinger radius" value={k.stinger_fitted_radius} unit="m" title="Of the circle fitted to the stinger's boxes, by least squares of their distances from it." />
        <Value name="largest reaction" value={boxes ? k.largest_reaction : null} unit="N" result="static.largest_reaction.value" title="Of a single roller." />
      </dl>
  );
}
