// Motions of the vessel and tensions of its lines over a run: extremes, and the parts of slow drift and waves.
import type { MotionName, MotionSpread } from '../api/types';
import { display } from '../logic/show';
import { tidy } from '../logic/units';
import { calmState } from '../state/moorings';
import { extremes } from '../state/offsets';
import { runSummary } from '../state/runs';
import { stormHistories } from '../state/storm';
import { showDockTab } from '../state/workspace';

const showHistory = (name: string): void => {
  stormHistories.value = [name, ...stormHistories.value.filter((shown) => shown !== name)];
  showDockTab('storm', 'histories');
};

interface Shown { name: string; history: string; unit: string; parts: MotionSpread | undefined }

/** Degrees of freedom of dynamic positioning, and their units. */
const thrusts: [string, string, string][] = [['surge', 'DP surge', 'N'], ['sway', 'DP sway', 'N'], ['yaw', 'DP yaw', 'N m']];

function Row({ name, history, unit, parts, apart }: Shown & { apart: boolean }) {
  const of = parts ?? extremes.value[history];
  if (!of) return null;
  const [shown, factor] = display(unit), value = (v: number, digits = 3): string => tidy(Number((v * factor).toFixed(3)), digits);
  const hours = parts && parts.most_probable_min !== null && parts.most_probable_max !== null ? `, most probable in three hours ${value(parts.most_probable_min)} to ${value(parts.most_probable_max)}` : '';
  const title = parts ? `Mean ${value(parts.mean)}${hours} ${shown}. Show its history` : 'Show its history';
  return (
    <tr>
      <th scope="row"><button type="button" class="linkname" title={title} onClick={() => showHistory(history)}>{name}</button> <small>{shown}</small></th>
      <td>{value(of.min)}</td><td>{value(of.max)}</td>{parts ? <><td>{value(parts.slow.std, 2)}</td><td>{value(parts.wave.std, 2)}</td></> : apart ? <><td /><td /></> : null}
    </tr>
  );
}

const motions: [MotionName, string][] = [['surge', 'm'], ['sway', 'm'], ['heave', 'm'], ['roll', 'rad'], ['pitch', 'rad'], ['yaw', 'rad']];

export function MooringsInTime() {
  const run = runSummary.value?.dynamic;
  const rows: Shown[] = [
    ...motions.map(([name, unit]) => ({ name, history: `vessel/${name}`, unit, parts: run?.vessel?.[name] })),
    ...thrusts.map(([freedom, name, unit]) => ({ name, history: `thrust/${freedom}`, unit, parts: undefined })),
    ...(calmState.value?.moorings ?? []).map((l) => ({ name: l.name, history: `mooring/${l.name}/fairlead_tension`, unit: 'N', parts: run?.moorings?.find((m) => m.name === l.name)?.fairlead_tension })),
  ].filter((r) => r.parts ?? extremes.value[r.history]);
  if (rows.length === 0) return null;
  const apart = rows.some((r) => r.parts);
  const atLimit = (run?.thrust ?? []).filter((t) => t.time_at_limit > 0);
  const events = (run?.moorings ?? []).flatMap((m) => m.events.map((e) => ({ ...e, name: m.name }))).sort((a, b) => a.time - b.time);
  return (
    <>
      <table class="minmax overtime" aria-label="Moorings over time">
        <thead><tr><th scope="col">over time</th><th scope="col">min</th><th scope="col">max</th>{apart ? <><th scope="col" title="Standard deviation of the low-frequency part">LF std</th><th scope="col" title="Standard deviation of the wave-frequency part">WF std</th></> : null}</tr></thead>
        <tbody>{rows.map((r) => <Row key={r.history} {...r} apart={apart} />)}</tbody>
      </table>
      {atLimit.length ? <p class="brief">Dynamic positioning at its limit: {atLimit.map((t) => `${t.name} for ${tidy(t.time_at_limit, 3)} s`).join(', ')}.</p> : null}
      {run?.vessel?.confidence ? <p class="brief">{run.vessel.confidence}</p> : null}
      {events.length ? <details><summary>{events.length === 1 ? '1 event' : `${events.length} events`}</summary><ul class="events">{events.map((e, i) => <li key={i}>{tidy(e.time, 5)} s: {e.name} {e.what}</li>)}</ul></details> : null}
    </>
  );
}
