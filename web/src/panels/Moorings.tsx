// Static offset of the hull on its moorings, natural periods, lines; and lines other than moorings.
import type { LineAtRest, MooringLine, VesselOffset } from '../api/types';
import { Table } from '../components/Table';
import { cellText } from '../components/tableText';
import { columnsFor, levelColours, lineCell, lineLevel, lineTable } from '../logic/moorings';
import { display, numberIn, unitName, withTwin } from '../logic/show';
import { tidy } from '../logic/units';
import { failure } from '../state/live';
import { aloneInTime, calmState, chooseLine, chosenLine, linesOfRun, stage } from '../state/moorings';
import { mode } from '../state/picture';
import { calmLay, ofRun } from '../state/shown';
import { MooringsInTime } from './MooringsInTime';

const short = ['fairlead_tension', 'utilisation', 'on_bed'];

/** Lines of the state shown; `wide`: all columns that carry information. */
export function MooringTable({ lines, wide, inTime = false }: { lines: readonly MooringLine[]; wide?: boolean; inTime?: boolean }) {
  const action = (name: string) => {
    const line = lines.find((l) => l.name === name)!;
    return {
      act: () => chooseLine(name),
      title: line.parted ? 'Parted' : line.slack ? 'Slack' : 'Show this line',
      chosen: chosenLine.value === name,
      colour: levelColours[lineLevel(line, inTime)],
    };
  };
  return (
    <Table
      table={lineTable(lines, inTime, wide ? undefined : short)}
      sortable
      copyable={wide}
      file={wide ? 'mooring-lines' : undefined}
      rowAction={action}
      numberTitle={(number, column) => `${column.description}: ${withTwin(number, column.unit)}`}
    />
  );
}

const offsets: [keyof VesselOffset, string, string][] = [['surge', 'm', 'forward'], ['sway', 'm', 'to port'], ['heave', 'm', 'up'], ['roll', 'rad', 'starboard down'], ['pitch', 'rad', 'bow down'], ['yaw', 'rad', 'bow to port']];

function Offsets({ of }: { of: VesselOffset }) {
  return (
    <dl class="offsets" aria-label="Vessel offset">
      {offsets.map(([key, unit, way]) => {
        const [name, factor] = display(unit), shown = Number(((of[key] as number) * factor).toFixed(3));
        return <div key={key} class="kv" title={`From the nominal position, positive ${way}`}><dt>{key}</dt><dd>{shown === 0 ? 0 : shown} <small>{name}</small></dd></div>;
      })}
    </dl>
  );
}

function Periods({ of, on }: { of: VesselOffset; on: string }) {
  if (of.natural_periods.length === 0) return null;
  return <dl class="offsets" aria-label="Natural periods">{of.natural_periods.map((p) => <div key={p.mode} class="kv" title={`Natural period of ${p.mode} ${on}`}><dt>T {p.mode}</dt><dd>{tidy(p.period, 3)} <small>s</small></dd></div>)}</dl>;
}

/** Stages of the operation; the scene and the plan follow. */
export function StageChoice() {
  const m = calmLay.value?.moorings;
  if (!m || m.stages.length === 0) return null;
  return (
    <label class="stage">stage
      <select aria-label="Stage of the operation" value={String(stage.value)} onChange={(e) => { stage.value = Number(e.currentTarget.value); }}>
        <option value="-1">equilibrium</option>
        {m.stages.map((s, i) => <option key={i} value={String(i)}>{s.name || `stage ${i + 1}`}</option>)}
      </select>
    </label>
  );
}

export function MooringResults() {
  const state = calmState.value;
  if (!state) return null;
  const lines = state.moorings.length > 0, name = lines ? 'Moorings' : 'Station keeping';
  return (
    <section class={`moored${failure.value && !ofRun.value ? ' old' : ''}`} aria-label={name}>
      <h3>{name} <button type="button" class="link" onClick={() => { mode.value = mode.value === 'plan' ? '3d' : 'plan'; }}>{mode.value === 'plan' ? '3-D view' : 'plan'}</button></h3>
      <StageChoice />
      {lines ? <MooringTable lines={linesOfRun.value ?? state.moorings} inTime={linesOfRun.value !== null} /> : null}
      {linesOfRun.value ? <p class="brief">Tensions: maximum of the run. Other columns: static.</p> : null}
      <Offsets of={state.vessel} />
      <Periods of={state.vessel} on={lines ? 'on the moorings' : 'with station keeping'} />
      <MooringsInTime />
    </section>
  );
}

/** Object selected in the 3-D view. */
export function LineValues({ name }: { name: string }) {
  const moored = calmState.value?.moorings.find((l) => l.name === name);
  if (moored) {
    return (
      <dl class="values"><div class="kv"><dt>{name}</dt><dd>{moored.slack ? 'slack' : ''}</dd></div>
        {columnsFor([moored]).map((c) => <div key={c.key} class="kv"><dt>{c.name}</dt><dd>{cellText(lineCell(moored, c), c)} <small>{c.unit}</small></dd></div>)}
        <div class="kv"><dt>length</dt><dd>{numberIn(moored.length, 'm', 6)} <small>{unitName('m')}</small></dd></div></dl>
    );
  }
  const alone = calmLay.value?.lines.find((l) => l.name === name);
  if (!alone) return null;
  return (
    <dl class="values"><div class="kv"><dt>{name}</dt><dd /></div>
      <div class="kv"><dt>tension</dt><dd>{numberIn(alone.least_tension, 'N')} to {numberIn(alone.largest_tension, 'N')} <small>{unitName('N')}</small></dd></div>
      <div class="kv"><dt>length</dt><dd>{numberIn(alone.length, 'm', 6)} <small>{unitName('m')}</small></dd></div></dl>
  );
}

/** Lines other than moorings, in equilibrium and in the selected run. */
export function LineTable({ lines }: { lines: readonly LineAtRest[] }) {
  if (lines.length === 0) return null;
  const inTime = aloneInTime.value;
  const moved = (name: string): [string, number, number][] => {
    const run = inTime?.find((l) => l.name === name);
    return run ? [['first end', run.first_tension.min, run.first_tension.max], ['second end', run.second_tension.min, run.second_tension.max], ['anywhere', run.least_tension, run.largest_tension]] : [];
  };
  const rows: [string, (l: LineAtRest) => string, string][] = [
    ['first end', (l) => numberIn(l.first.tension, 'N'), 'N'], ['second end', (l) => numberIn(l.second.tension, 'N'), 'N'],
    ['largest', (l) => numberIn(l.largest_tension, 'N'), 'N'], ['least', (l) => numberIn(l.least_tension, 'N'), 'N'],
    ['length', (l) => numberIn(l.length, 'm', 5), 'm'], ['on the seabed', (l) => numberIn(l.on_bed, 'm'), 'm'],
  ];
  return (
    <section class="moored" aria-label="Lines">
      {lines.map((l) => (
        <div key={l.name}>
          <h3><button type="button" class="linkname" aria-pressed={chosenLine.value === l.name} onClick={() => chooseLine(l.name)}>{l.name}</button></h3>
          <dl>
            {rows.map(([name, text, unit]) => <div key={name} class="kv" title={unit === 'N' ? 'Static effective tension' : ''}><dt>{unit === 'N' ? `tension, ${name}` : name}</dt><dd>{text(l)} <small>{unitName(unit)}</small></dd></div>)}
            {moved(l.name).map(([name, least, largest]) => <div key={`${name} in time`} class="kv" title="Effective tension over the run"><dt>in time, {name}</dt><dd>{numberIn(least, 'N')} to {numberIn(largest, 'N')} <small>{unitName('N')}</small></dd></div>)}
            {l.utilisation === null ? null : <div class="kv"><dt>of breaking load</dt><dd>{tidy(100 * l.utilisation, 3)} <small>%</small></dd></div>}
          </dl>
        </div>
      ))}
    </section>
  );
}
