// Histories and envelopes of the compared runs in one diagram each.
import { useEffect, useMemo, useState } from 'preact/hooks';
import { signal } from '@preact/signals';
import type { Series } from '../../api/types';
import { envelopeChart, envelopeKeys, historyChart, runColours, type Compared, type EnvelopeKey } from '../../logic/runCompare';
import { quantity } from '../../logic/show';
import { columnName } from '../../logic/tensioner';
import { compared, runParts } from '../../state/compare';
import { fetchSeries, runName } from '../../state/runs';
import { DataDiagram } from '../DataDiagram';

/** Content of the diagrams: an envelope, or "history:" with its name. */
const slots = signal<readonly string[]>(['von_mises', 'effective_tension', 'history:top_tension']);
const pixels = 900;

function Choice({ index }: { index: number }) {
  const columns = compared.value.map((run) => runParts.value.get(run.id)?.columns ?? []).find((list) => list.length) ?? [];
  return (
    <select aria-label={`Diagram ${index + 1}`} value={slots.value[index]} onChange={(e) => { const next = e.currentTarget.value; slots.value = slots.value.map((slot, i) => (i === index ? next : slot)); }}>
      <optgroup label="Envelopes along the pipe">{envelopeKeys.map((key) => <option key={key} value={key}>{quantity(key)!.name}</option>)}</optgroup>
      {columns.length ? <optgroup label="Histories">{columns.map((c) => <option key={c.name} value={`history:${c.name}`} title={c.text}>{columnName(c.name)}</option>)}</optgroup> : null}
    </select>
  );
}

function Envelope({ index, of }: { index: number; of: EnvelopeKey }) {
  const list = compared.value, parts = runParts.value;
  const data = useMemo(() => envelopeChart(of, list.map((run, i) => ({ name: runName(run), colour: runColours[i]!, data: parts.get(run.id)?.envelopes ?? null }))), [of, list, parts]);
  return data.x.length ? <DataDiagram data={data}><Choice index={index} /></DataDiagram> : <Nothing index={index} text="None of the runs has an envelope." />;
}

function Nothing({ index, text }: { index: number; text: string }) {
  return <figure class="slot"><figcaption><Choice index={index} /></figcaption><p class="empty">{text}</p></figure>;
}

function History({ index, name }: { index: number; name: string }) {
  const list = compared.value, parts = runParts.value;
  const column = list.flatMap((run) => parts.get(run.id)?.columns ?? []).find((c) => c.name === name), ids = list.map((run) => run.id).join(' ');
  const [series, setSeries] = useState<ReadonlyMap<string, Series>>(new Map());
  useEffect(() => {
    let gone = false;
    const having = list.filter((run) => (run.has_results || run.state === 'running') && parts.get(run.id)?.columns.some((c) => c.name === name));
    void Promise.all(having.map((run) => fetchSeries(run.id, [name], null, null, pixels).then((answer) => [run.id, answer[name]] as const).catch(() => [run.id, undefined] as const)))
      .then((all) => { if (!gone) setSeries(new Map(all.filter((pair): pair is readonly [string, Series] => pair[1] !== undefined))); });
    return () => { gone = true; };
  }, [ids, name, parts]);
  const data = useMemo(() => (column ? historyChart(columnName(name), column.unit, list.map((run, i): Compared<Series> => ({ name: runName(run), colour: runColours[i]!, data: series.get(run.id) ?? null }))) : null), [column, series, list]);
  return data?.x.length ? <DataDiagram data={data}><Choice index={index} /></DataDiagram> : <Nothing index={index} text={column ? 'Loading…' : 'None of the runs has this history.'} />;
}

export function RunDiagrams() {
  if (compared.value.length === 0) return <p class="empty">Select up to four runs in the table above to overlay their diagrams.</p>;
  return (
    <div class="diagramgrid">
      {slots.value.map((slot, i) => (slot.startsWith('history:') ? <History key={i} index={i} name={slot.slice('history:'.length)} /> : <Envelope key={i} index={i} of={slot as EnvelopeKey} />))}
    </div>
  );
}
