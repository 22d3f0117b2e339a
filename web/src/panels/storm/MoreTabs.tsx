// Envelopes along the pipe, code checks and moorings of the run.
import { signal } from '@preact/signals';
import { along } from '../../charts/data';
import { quantities } from '../../logic/show';
import { cursor } from '../../state/look';
import { envelopes, runChecks, runSummary } from '../../state/runs';
import { calmLay, ofRun } from '../../state/shown';
import { Checks } from '../Checks';
import { MooringsInTime } from '../MooringsInTime';
import { Plot } from '../Plot';
import { plotCount, TabFrame, useWidth } from './TabFrame';

const known = quantities.filter((q) => ['effective_tension', 'bending_moment', 'bending_stress', 'von_mises', 'strain'].includes(q.key));
const shown = signal<string[]>(['von_mises', 'effective_tension', 'strain', 'bending_moment']);

function Envelope({ index }: { index: number }) {
  const key = shown.value[index]!, lay = calmLay.value;
  const data = lay && ofRun.value ? along(key, lay, envelopes.value, runChecks.value ?? lay.checks) : null;
  const choose = (next: string): void => { shown.value = shown.value.map((old, i) => (i === index ? next : old)); };
  return (
    <Plot data={data} empty="Loading…" legend cursor={cursor.value} onHover={(s) => { cursor.value = s; }} title="Drag to zoom, double-click to reset">
      <select aria-label={`Envelope ${index + 1}`} value={key} onChange={(e) => choose(e.currentTarget.value)}>
        {known.map((q) => <option key={q.key} value={q.key}>{q.name}</option>)}
      </select>
    </Plot>
  );
}

export function EnvelopesTab() {
  const [box, width] = useWidth();
  const count = plotCount(width), ready = ofRun.value && (calmLay.value?.pipe.s.length ?? 0) > 0;
  return (
    <TabFrame>
      <div class="stormplots" ref={box} style={{ gridTemplateColumns: `repeat(${count}, minmax(0, 1fr))` }}>
        {ready ? Array.from({ length: count }, (_, i) => <Envelope key={i} index={i} />) : <TabFrame ready={false}>{null}</TabFrame>}
      </div>
    </TabFrame>
  );
}

export function ChecksTab() {
  return <TabFrame ready={(runChecks.value?.length ?? 0) > 0}><Checks /></TabFrame>;
}

export const hasMoorings = (): boolean => runSummary.value?.dynamic?.moorings !== undefined || runSummary.value?.dynamic?.vessel !== undefined;

export function MooringsTab() {
  return <TabFrame ready={hasMoorings()}><MooringsInTime /></TabFrame>;
}
