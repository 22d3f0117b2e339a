// Key results of statics.
import { fromSi, tidy, write } from '../logic/units';
import { calm, failure } from '../state/live';
import { bullet, bullets } from '../logic/warnings';
import { cursor } from '../state/look';
import { diagnostics } from '../state/model';
import type { KeyResults, Region } from '../api/types';
import { LineTable, MooringResults } from './Moorings';
import { Warnings } from './Warnings';

function Value({ name, value, unit, title }: { name: string; value: number | null | undefined; unit: string; title?: string }) {
  if (value === null || value === undefined) return null;
  const other = { kN: 'kip', m: 'ft', MPa: 'ksi' }[unit];
  return (
    <div class="kv" title={`${title ?? ''} ${other ? write(value, other, 4) : ''}`.trim()}>
      <dt>{name}</dt><dd>{tidy(fromSi(value, unit), 4)} <small>{unit}</small></dd>
    </div>
  );
}

function RegionBlock({ name, r }: { name: string; r: Region | null }) {
  if (!r) return null;
  const level = r.utilisation > 1 ? 'over' : r.utilisation > 0.87 ? 'near' : 'good';
  return (
    <div class={`region ${level}`}>
      <button type="button" class="regionhead" title="Show the location" onClick={() => { cursor.value = r.s; }}>
        <span>{name}</span><b>{tidy(100 * r.utilisation, 3)} %</b><small> of yield</small>
      </button>
      <div class="bar" role="presentation"><i style={{ width: `${Math.min(100, 100 * r.utilisation)}%` }} /></div>
      <dl>
        <Value name="von Mises" value={r.von_mises} unit="MPa" />
        <Value name="bending" value={r.bending_stress} unit="MPa" />
        <div class="kv"><dt>strain</dt><dd>{tidy(100 * r.strain, 3)} <small>%</small></dd></div>
      </dl>
    </div>
  );
}

export function Results() {
  const s = calm.value;
  if (!s) return <section class="results"><h2>Results</h2><p class="empty">{failure.value ? '' : 'Static results appear here as soon as the model is complete.'}</p></section>;
  const k = s.key;
  const ofModel = diagnostics.value.filter((d) => d.severity === 'warning').map((d) => bullet(d.message, [], d.key));
  return (
    <section class={`results${failure.value ? ' old' : ''}`} aria-label="Key results">
      <h2>Results {failure.value ? <small>last valid solution</small> : <small>statics</small>}</h2>
      {k ? (
        <>
          <RegionBlock name="Overbend" r={k.overbend} />
          <RegionBlock name="Tower" r={k.tower} />
          <RegionBlock name="Sagbend" r={k.sagbend} />
          <KeyValues k={k} boxes={s.supports.length > 0} />
        </>
      ) : null}
      <MooringResults />
      <LineTable lines={s.lines} />
      <Warnings list={[...ofModel, ...bullets(s.warnings, s.supports.map((b) => b.name))]} />
    </section>
  );
}

function KeyValues({ k, boxes }: { k: KeyResults; boxes: boolean }) {
  return (
      <dl>
        <Value name="top tension" value={k.top_tension} unit="kN" />
        <Value name="bottom tension" value={k.bottom_tension} unit="kN" />
        <Value name="lay-back" value={k.lay_back} unit="m" title="Horizontal distance from stern shoe to touchdown." />
        <Value name="departure angle" value={k.departure_angle} unit="deg" />
        <Value name="tip clearance" value={k.stinger_tip_clearance} unit="m" title="Clearance of the pipe over the last stinger roller." />
        <Value name="largest reaction" value={boxes ? k.largest_reaction : null} unit="kN" />
      </dl>
  );
}
