// Code checks of the results shown: the governing check of each region, and all checks with their calculations.
import { useEffect, useState } from 'preact/hooks';
import { CalculationSheet } from '../components/CalculationSheet';
import { drawnSheet, governing, level, ranked, regionName } from '../logic/checks';
import { tidy } from '../logic/units';
import { cursor } from '../state/look';
import { shownFailure } from '../state/shown';
import { openedCheck, shownChecks } from '../state/verdict';
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
  const asked = openedCheck.value === check.id;
  const [open, setOpen] = useState(asked);
  useEffect(() => { if (asked) setOpen(true); }, [asked]);
  const title = `${check.code} ${check.clause}${check.remark ? `: ${check.remark}` : ''}`;
  const hasSheet = check.sheet.length > 0;
  return (
    <>
      <tr class={level(check)} title={title}>
        <td>{hasSheet ? <button type="button" class="fold" aria-expanded={open} title="Calculation of this check" onClick={() => { setOpen(!open); }}>{check.name}</button> : check.name}<small>{check.line || regionName(check.region)}, {check.code}</small></td>
        <td>{used(check)}</td>
        <td>{check.governing ? check.status : 'information'}</td>
      </tr>
      {open ? <tr><td colSpan={3}><CalculationSheet lines={drawnSheet(check.sheet)} /></td></tr> : null}
    </>
  );
}

/** All checks, the governing one first; each unfolds its calculation. */
export function Checks() {
  const checks = shownChecks.value;
  if (checks.length === 0) return <p class="empty">No code checks: the model has no pipe, or they are turned off.</p>;
  return (
    <section class={`checks padded${shownFailure.value ? ' old' : ''}`} aria-label="Code checks">
      <div class="governings">{governing(checks).map((c) => <Governing key={c.region} check={c} />)}</div>
      <table class="checks">
        <thead><tr><th scope="col">check</th><th scope="col">utilisation</th><th scope="col">result</th></tr></thead>
        <tbody>{ranked(checks).map((c) => <Row key={`${c.id} ${c.line} ${c.region} ${c.remark}`} check={c} />)}</tbody>
      </table>
      <p class="brief">A utilisation above 1 exceeds the check. Unfold a check to see its calculation, with clauses and sources.</p>
    </section>
  );
}
