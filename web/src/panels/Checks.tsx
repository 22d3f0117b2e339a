// Code checks of the live statics, or of the run that is looked at.
import { useState } from 'preact/hooks';
import { CalculationSheet } from '../components/CalculationSheet';
import { drawnSheet, governing, level, ranked, regionName } from '../logic/checks';
import { tidy } from '../logic/units';
import { calm, failure } from '../state/live';
import { cursor } from '../state/look';
import { stageLay } from '../state/operation';
import { runChecks, selected } from '../state/runs';
import type { Check } from '../api/types';

const used = (c: Check): string => (c.utilisation === undefined ? '–' : tidy(c.utilisation, 3));

function Governing({ check }: { check: Check }) {
  return (
    <div class={`region ${level(check)}`}>
      <button type="button" class="regionhead" title={`${check.name}; ${check.code} ${check.clause}. Show its location`} onClick={() => { cursor.value = check.line ? null : check.at?.from_top ?? null; }}>
        <span>{regionName(check.region)}</span><b>{used(check)}</b>
      </button>
      <div class="bar" role="presentation"><i style={{ width: `${Math.min(100, 100 * (check.utilisation ?? 0))}%` }} /></div>
      <p class="brief">{check.name}{check.line ? `, ${check.line}` : ''}</p>
    </div>
  );
}

function Row({ check }: { check: Check }) {
  const [open, setOpen] = useState(false);
  const title = `${check.code} ${check.clause}${check.remark ? `: ${check.remark}` : ''}`;
  const there = check.sheet.length > 0;
  return (
    <>
      <tr class={level(check)} title={title}>
        <td>{there ? <button type="button" class="fold" aria-expanded={open} title="Calculation of this check" onClick={() => { setOpen(!open); }}>{check.name}</button> : check.name}<small>{check.line || regionName(check.region)}, {check.code}</small></td>
        <td>{used(check)}</td>
        <td>{check.governing ? check.status : 'information'}</td>
      </tr>
      {open ? <tr><td colSpan={3}><CalculationSheet lines={drawnSheet(check.sheet)} /></td></tr> : null}
    </>
  );
}

export function Checks() {
  const run = selected.value;
  const ofRun = run ? runChecks.value ?? [] : null;
  const checks = ofRun ?? stageLay.value?.checks ?? calm.value?.checks ?? [];
  if (checks.length === 0) return null;
  const deciding = governing(checks);
  const worst = ranked(deciding)[0];
  return (
    <section class={`results checks${failure.value && !ofRun ? ' old' : ''}`} aria-label="Code checks">
      <h2>Code checks <small>{ofRun ? `of ${run!.kind === 'dynamic' ? 'the run' : 'the static run'}` : 'statics'}</small></h2>
      {worst ? <Governing check={worst} /> : null}
      <details>
        <summary>All checks</summary>
        {deciding.map((c) => <Governing key={c.region} check={c} />)}
        <table class="checks"><tbody>{ranked(checks).map((c) => <Row key={`${c.id} ${c.line} ${c.region} ${c.remark}`} check={c} />)}</tbody></table>
        <p class="brief">Utilisation; above 1 is exceeded. Click a check for its calculation, with clauses and what confirms them.</p>
      </details>
    </section>
  );
}
