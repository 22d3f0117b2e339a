// Fields of a lay table: its rows and columns, and the limits of a case.
import type { AxisRequest } from '../../logic/studyFile';
import { grid, lay, limits, setGrid, setLay, setTableOver, tableOver, type TableOver } from '../../state/studies';
import { StripField } from './StripField';

const overs: [TableOver, string][] = [['grid', 'depths by tensions'], ['tension', 'tension'], ['lay_back', 'lay-back'], ['depth', 'water depth']];

interface EndsProps { id: string; label: string; axis: Pick<AxisRequest, 'from' | 'to' | 'count'>; set: (part: Partial<AxisRequest>) => void; counted: string }

/** From, to and number of values under one label. */
function Ends({ id, label, axis, set, counted }: EndsProps) {
  const field = (key: 'from' | 'to' | 'count', name: string) => (
    <input
      id={key === 'from' ? id : undefined} class={key === 'count' ? 'count' : 'short'} aria-label={`${label}, ${name}`} title={name} value={axis[key]}
      inputMode={key === 'count' ? 'numeric' : undefined} autocomplete="off" onInput={(e) => set({ [key]: e.currentTarget.value })}
    />
  );
  return (
    <StripField id={id} label={label}>
      <span class="ends">{field('from', 'from')}<i>…</i>{field('to', 'to')}<i>in</i>{field('count', counted)}</span>
    </StripField>
  );
}

function Limits() {
  const { utilisation, clearance, reserved } = limits.value;
  const set = (part: Partial<typeof limits.value>): void => { limits.value = { ...limits.value, ...part }; };
  return (
    <>
      <StripField id="lt-utilisation" label="utilisation up to">
        <input
          id="lt-utilisation" class="count" inputMode="decimal" value={utilisation} autocomplete="off"
          onChange={(e) => { const value = Number(e.currentTarget.value); if (value > 0) set({ utilisation: value }); else e.currentTarget.value = String(utilisation); }}
        />
      </StripField>
      <StripField id="lt-clearance" label="tip clearance from" title="Clearance of the pipe above the last stinger box, in the unit of the table">
        <input
          id="lt-clearance" class="count" inputMode="decimal" value={clearance ?? ''} placeholder="any" autocomplete="off"
          onChange={(e) => { const value = Number.parseFloat(e.currentTarget.value); set({ clearance: Number.isFinite(value) ? value : null }); }}
        />
      </StripField>
      <StripField id="lt-reserved" label="counts as passing">
        <select id="lt-reserved" value={reserved ? 'yes' : 'no'} onChange={(e) => set({ reserved: e.currentTarget.value === 'yes' })}>
          <option value="no">passes</option>
          <option value="yes">passes, also with reservations</option>
        </select>
      </StripField>
    </>
  );
}

export function TableFields() {
  const { rows, columns } = grid.value;
  return (
    <>
      <StripField id="lt-over" label="over">
        <select id="lt-over" value={tableOver.value} onChange={(e) => setTableOver(e.currentTarget.value as TableOver)}>
          {overs.map(([id, name]) => <option key={id} value={id}>{name}</option>)}
        </select>
      </StripField>
      {tableOver.value === 'grid' ? (
        <>
          <Ends id="lt-rows" label="rows: water depth" counted="number" axis={rows} set={(part) => setGrid({ rows: { ...rows, ...part } })} />
          <Ends id="lt-columns" label="columns: tension" counted="number" axis={columns} set={(part) => setGrid({ columns: { ...columns, ...part } })} />
          <Limits />
        </>
      ) : (
        <Ends
          id="lt-from" label="from … to, in steps" counted="steps" axis={{ from: lay.value.from, to: lay.value.to, count: lay.value.steps }}
          set={({ from, to, count }) => setLay({ ...(from === undefined ? {} : { from }), ...(to === undefined ? {} : { to }), ...(count === undefined ? {} : { steps: count }) })}
        />
      )}
    </>
  );
}
