// The selected run: static values with minima and maxima over time, its findings, its state.
import { useState } from 'preact/hooks';
import type { Lay, Region, RegionSummary, Run, RunSummary, Spread } from '../api/types';
import { bullets, withoutPaths } from '../logic/findings';
import { display, numberIn, unitName } from '../logic/show';
import { tidy } from '../logic/units';
import { calmLay, ofRun } from '../state/shown';
import { cancelRun, runName, runSummary, select, selected } from '../state/runs';
import { FatigueResults } from './FatigueResults';
import { LineTable, MooringResults } from './Moorings';
import { Findings } from './Findings';
import { VerdictCard } from './Results';
import { Tables } from './Tables';

interface Row { name: string; unit: string; before: number | null | undefined; over: Spread | null | undefined }

const shown = (value: number | null | undefined, unit: string): string =>
  (value === null || value === undefined || !Number.isFinite(value) ? '–' : unit === '%' ? tidy(100 * value, 3) : numberIn(value, unit, Math.abs(value) >= 1e6 && unit === 'N' ? 4 : 3));

type RollerOverTime = { reaction: Spread };

/** The single roller that carries most, in the run, else in statics: the same roller in both columns. */
function reactionRow(lay: Lay, d: RunSummary['dynamic']): Row | null {
  const before = lay.supports.flatMap((box) => box.rollers.map((r, i) => ({ box: box.name, row: box.rollers.slice(0, i).filter((o) => o.position === r.position).length, position: r.position, static: r.reaction })));
  if (before.length === 0) return null;
  const over = (r: (typeof before)[number]): Spread | undefined => (d?.supports.find((box) => box.name === r.box)?.rows[r.row] as Record<string, RollerOverTime> | undefined)?.[r.position]?.reaction;
  const load = (r: (typeof before)[number]): number => over(r)?.max ?? r.static;
  const most = before.reduce((a, b) => (load(b) > load(a) ? b : a));
  return { name: `${most.box}, row ${most.row + 1} ${most.position}`, unit: 'N', before: most.static, over: over(most) };
}

const regionRows = (before: Region, over: RegionSummary | null | undefined): Row[] => [
  { name: 'von Mises', unit: 'Pa', before: before.von_mises, over: over?.max_von_mises },
  { name: 'bending', unit: 'Pa', before: before.bending_stress, over: over?.max_bending_stress },
  { name: 'strain', unit: '%', before: before.strain, over: over?.max_strain },
];

function Table() {
  const lay = calmLay.value;
  const d = runSummary.value?.dynamic;
  const k = lay?.key;
  if (!lay || !k || !ofRun.value) return null;
  const reaction = reactionRow(lay, d);
  const groups: [string, Row[]][] = [
    ...(k.overbend ? [['Overbend', regionRows(k.overbend, d?.overbend)] as [string, Row[]]] : []),
    ...(k.tower ? [['Tower', regionRows(k.tower, d?.tower)] as [string, Row[]]] : []),
    ['Sagbend', regionRows(k.sagbend, d?.sagbend)],
    ['Tension', [
      { name: 'top', unit: 'N', before: k.top_tension, over: d?.top_tension },
      { name: 'bottom', unit: 'N', before: k.bottom_tension, over: d?.bottom_tension },
    ]],
    ['Line', [
      { name: 'lay-back', unit: 'm', before: k.lay_back, over: d?.lay_back },
      { name: 'departure', unit: 'rad', before: k.departure_angle, over: d?.departure_angle },
      ...(k.stinger_tip_clearance === null ? [] : [{ name: 'tip clearance', unit: 'm', before: k.stinger_tip_clearance, over: d?.stinger_tip_clearance }]),
    ]],
    ...(reaction ? [['Largest reaction of a roller', [reaction]] as [string, Row[]]] : []),
  ];
  return (
    <table class="minmax">
      <thead><tr><th scope="col" /><th scope="col">static</th>{d ? <><th scope="col">min</th><th scope="col">max</th></> : null}</tr></thead>
      {groups.map(([name, rows]) => (
        <tbody key={name}>
          <tr class="group"><th scope="rowgroup" colSpan={d ? 4 : 2}>{name}</th></tr>
          {rows.map((r) => <tr key={r.name}><th scope="row">{r.name} <small>{r.unit === '%' ? '%' : unitName(r.unit)}</small></th><td>{shown(r.before, r.unit)}</td>{d ? <><td>{shown(r.over?.min, r.unit)}</td><td>{shown(r.over?.max, r.unit)}</td></> : null}</tr>)}
        </tbody>
      ))}
    </table>
  );
}

const extremeName = (name: string): string => name.replace(/^(support|mooring)\//, '').replace(/_peak$/, '').replaceAll('_', ' ').replace('/', ', ');

/** Most probable extremes in three hours, and what they are worth. */
function Extremes() {
  const d = runSummary.value?.dynamic;
  const [open, setOpen] = useState(false);
  if (!d?.extremes.length) return null;
  return (
    <details class="extremes" onToggle={(e) => setOpen(e.currentTarget.open)}>
      <summary>Most probable in three hours</summary>
      {!open ? null : d.non_stationary ? <p class="brief">None: {d.non_stationary}.</p> : (
        <table class="minmax">
          <thead><tr><th scope="col" /><th scope="col">seen</th><th scope="col">in 3 h</th><th scope="col">quality</th></tr></thead>
          <tbody>
            {d.extremes.map((e) => {
              const [unit, factor] = display(e.units), value = (v: number | null): string => (v === null ? '–' : tidy(v * factor, 3));
              return (
                <tr key={`${e.name}${e.smallest ? ' least' : ''}`} title={e.remark || `95 % confidence: ${value(e.low)} to ${value(e.high)} ${unit}`}>
                  <th scope="row">{extremeName(e.name)}{e.smallest ? ', least' : ''} <small>{unit}</small></th><td>{value(e.observed)}</td><td>{value(e.estimate)}</td><td>{e.quality}</td>
                </tr>
              );
            })}
          </tbody>
        </table>
      )}
    </details>
  );
}

/** Without a pipe there is none to count. */
function impacts(d: NonNullable<RunSummary['dynamic']>): string {
  if (!calmLay.value?.key) return '';
  return d.impact_count === 1 ? ', 1 impact' : `, ${d.impact_count} impacts`;
}

export function Standing({ run }: { run: Run }) {
  const d = runSummary.value?.dynamic;
  switch (run.state) {
    case 'failed': return <p class="standing bad" role="alert"><b>This run failed.</b> {withoutPaths(run.message)}</p>;
    case 'queued': return <p class="standing">Waiting for the previous run.</p>;
    case 'running': return <p class="standing">Running: {Math.round(100 * run.progress)} %{run.time !== undefined ? `, t = ${tidy(run.time, 4)} s` : ''}. Results are available when it is finished. {run.parent ? null : <button type="button" onClick={() => void cancelRun(run.id)}>Cancel</button>}</p>;
    case 'cancelled': return <p class="standing warn"><b>Cancelled.</b> {d ? `Results of the first ${tidy(d.duration, 5)} s are shown.` : run.message}</p>;
    default: return d ? <p class="standing">{tidy(d.duration, 5)} s, seed {d.seed}{impacts(d)}</p> : null;
  }
}

export function RunResults() {
  const run = selected.value;
  if (!run) return null;
  const s = runSummary.value;
  const said = s ? [...(s.dynamic?.findings ?? []), ...(s.findings ?? [])] : [];
  const boxes = (calmLay.value?.supports ?? []).map((b) => b.name);
  const loading = run.has_results && !ofRun.value;
  const verdict = s?.dynamic?.verdict ?? s?.verdict;
  return (
    <section class="results ofrun" aria-label="Results of the run">
      <h2>{runName(run)} <small>{run.kind === 'dynamic' ? 'dynamic run' : 'static run'}</small></h2>
      {run.note ? <p class="note">{run.note}</p> : null}
      <Standing run={run} />
      {verdict && verdict.kind !== 'not judged' ? <VerdictCard verdict={verdict} /> : null}
      {loading ? <p class="brief">Loading…</p> : <><Table /><Extremes /><FatigueResults /><MooringResults /><LineTable lines={calmLay.value?.lines ?? []} /></>}
      <Findings list={bullets(said, boxes)} />
      {loading || !ofRun.value ? null : <Tables lay={calmLay.value} />}
      {run.parent ? <button type="button" class="back" onClick={() => select(run.parent!)}>Back to the study</button> : null}
      <button type="button" class="back" onClick={() => select(null)}>Back to the model</button>
    </section>
  );
}
