// The diagrams at the bottom: each shows the quantity selected in its menu, along the pipe or over time.
import { useEffect, useRef, useState } from 'preact/hooks';
import { signal } from '@preact/signals';
import { Chart } from '../charts/chart';
import { along, colours, lineShape, lineTension, reactions, shape, type ChartData } from '../charts/data';
import { shownLines } from '../charts/marks';
import { display, quantities, quantity } from '../logic/show';
import { onLines } from '../logic/views';
import { columnName } from '../logic/tensioner';
import { byPath, opened } from '../state/model';
import { shownStage } from '../state/operation';
import { calmLay, ofRun, shownFailure, shownScene } from '../state/shown';
import { cursor, slots, theme } from '../state/look';
import { active, seek, time } from '../state/animation';
import { calmState, chosenLine } from '../state/moorings';
import { columns, envelopes, fetchSeries, runChecks, runName, runSummary, selected } from '../state/runs';
import { nearest } from '../logic/series';

const width = signal(innerWidth);
addEventListener('resize', () => { width.value = innerWidth; });
const shownSlots = (): number => (width.value >= 2600 || width.value < 1100 ? 4 : width.value >= 1500 ? 3 : 2);
/** Below 1,100 px the diagrams have a tab of their own and stand one above the other. */
const stacked = (): boolean => width.value < 1100;

function range(): [number, number] | null {
  const low = byPath.value.get('tensioner.range[0]')?.si, high = byPath.value.get('tensioner.range[1]')?.si;
  return typeof low === 'number' && typeof high === 'number' ? [low / 1e3, high / 1e3] : null;
}

function statics(what: string): ChartData | null {
  const s = calmLay.value;
  if (!s) return null;
  if (s.pipe.s.length === 0) {
    const named = <T extends { name: string }>(list: T[]): T | undefined => list.find((l) => l.name === chosenLine.value) ?? list[0];
    const alone = named(s.lines), line = alone ?? named(calmState.value?.moorings.filter((l) => !l.parted) ?? []);
    if (alone && what === 'effective_tension') return lineTension(alone);
    return line && (what === 'elevation' || what === 'plan') ? lineShape(line, shownScene.value, what === 'plan') : null;
  }
  if (what === 'elevation' || what === 'plan') return shape(s, shownScene.value, what === 'plan', ofRun.value ? null : shownStage.value?.parts ?? null);
  if (what === 'reactions') return s.supports.length ? reactions(s, runSummary.value?.dynamic) : null;
  return quantities.some((q) => q.key === what && s.pipe[q.key]?.length) ? along(what, s, ofRun.value ? envelopes.value : null, (ofRun.value ? runChecks.value : null) ?? s.checks) : null;
}

/** Why a diagram along the pipe is empty. */
function empty(): string {
  const s = calmLay.value;
  if (!s) return 'No solution yet.';
  if (s.pipe.s.length) return 'The model has no roller boxes.';
  if (!s.lines.length && !onLines(s)) return 'The model has neither pipe nor lines. Histories of a run are in this menu.';
  return s.lines.length ? 'Elevation, plan and effective tension are known of lines.' : 'The model has no pipe. Elevation and plan are those of a mooring line.';
}

/** Histories come as least and greatest per pixel, for the stretch that is shown and no other. */
function useHistory(what: string, zoom: [number, number] | null, pixels: number): ChartData | null {
  const [data, setData] = useState<ChartData | null>(null);
  const run = selected.value;
  const column = columns.value.find((c) => `history:${c.name}` === what);
  // while a run goes on its diagram follows, in steps
  const stage = run?.state === 'running' ? Math.floor((run.progress ?? 0) * 40) : run?.state;
  useEffect(() => {
    if (!column || !run || (!run.has_results && run.state !== 'running')) { setData(null); return undefined; }
    let gone = false;
    void fetchSeries(run.id, [column.name], zoom?.[0] ?? null, zoom?.[1] ?? null, pixels).then((answer) => {
      const s = answer[column.name];
      if (gone || !s) return;
      const [unit, factor] = display(column.unit);
      setData({
        title: columnName(column.name), xName: 'time [s]', yName: `${columnName(column.name).toLowerCase().replace('von mises', 'von Mises').replace(/ \(.*/, '')} [${unit}]`, x: s.t, s: s.t, marks: [], level: [],
        lines: [{ name: 'largest', colour: colours.now, values: s.max.map((v) => v * factor), band: true }, { name: 'least', colour: colours.now, values: s.min.map((v) => v * factor), band: true }],
      });
    }).catch(() => undefined);
    return () => { gone = true; };
  }, [what, run?.id, stage, zoom?.[0], zoom?.[1], pixels, column?.name]);
  return data;
}

function Legend({ data }: { data: ChartData }) {
  if (data.lines.length < 2) return null;
  return (
    <ul class="chartlegend" aria-label="Lines">
      {shownLines(data).map((l) => (
        <li key={l.name}><i class={l.band ? 'band' : l.width === -1 ? 'barkey' : l.dash ? 'dashed' : ''} style={{ '--line': l.colour }} />{l.name}</li>
      ))}
    </ul>
  );
}

function Slot({ index }: { index: number }) {
  const box = useRef<HTMLDivElement>(null);
  const chart = useRef<Chart | null>(null);
  const [zoom, setZoom] = useState<[number, number] | null>(null);
  const [read, setRead] = useState('');
  const [pixels, setPixels] = useState(600);
  const asked = slots.value[index] ?? 'elevation';
  const history = asked.startsWith('history:');
  const missing = history ? !columns.value.some((c) => `history:${c.name}` === asked) : !['elevation', 'plan', 'reactions'].includes(asked) && !quantity(asked);
  // without a pipe: what is known of lines
  const lay = calmLay.value, lines = lay !== null && lay.lines.length > 0 && lay.pipe.s.length === 0 && !history;
  const what = missing || (lines && !['elevation', 'plan'].includes(asked)) ? 'effective_tension' : asked;
  const inTime = what.startsWith('history:');
  const fetched = useHistory(what, zoom, pixels);
  const data = inTime ? fetched : statics(what);
  const shade = (inTime && /:top_tension|:tensioner\/tension$/.test(what)) ? range() : null;
  const now = inTime && active.value ? time.value : null;

  useEffect(() => {
    const on = {
      hover: (_x: number | null, i: number | null) => {
        setRead(chart.current?.readAt(i) ?? '');
        if (!inTimeRef.current) cursor.value = i === null ? null : dataRef.current?.s[i] ?? null;
      },
      click: (x: number) => { if (inTimeRef.current && active.value) seek(x); },
      zoom: (low: number, high: number, whole: boolean) => { if (inTimeRef.current) setZoom(whole ? null : [low, high]); },
    };
    const c = new Chart(box.current!, on);
    chart.current = c;
    const observer = new ResizeObserver(() => { c.resize(); setPixels(Math.round(box.current!.clientWidth / 50) * 50); });
    observer.observe(box.current!);
    return () => { observer.disconnect(); c.destroy(); };
  }, []);
  const inTimeRef = useRef(inTime);
  inTimeRef.current = inTime;
  const dataRef = useRef(data);
  dataRef.current = data;

  useEffect(() => { if (data && chart.current) chart.current.set(data, { shade, now }); }, [data, theme.value, shade?.[0], shade?.[1]]);
  useEffect(() => chart.current?.setNow(now), [now]);
  const at = cursor.value;
  useEffect(() => {
    if (!inTime) { chart.current?.setCursor(at); if (!box.current?.matches(':hover')) setRead(at === null || !dataRef.current ? '' : chart.current?.readAt(nearest(dataRef.current.s, at)) ?? ''); }
  }, [at]);

  const model = opened.value;
  useEffect(() => { setZoom(null); chart.current?.showWhole(); }, [model]);

  const choose = (value: string): void => { setZoom(null); const next = [...slots.value]; next[index] = value; slots.value = next; };
  return (
    <figure class={`slot${shownFailure.value && !inTime ? ' old' : ''}`}>
      <figcaption>
        <select aria-label={`Diagram ${index + 1}`} value={what} onChange={(e) => choose(e.currentTarget.value)}>
          <optgroup label="Along the pipe">
            <option value="elevation">Elevation</option>
            <option value="plan">Plan</option>
            {quantities.map((q) => <option key={q.key} value={q.key}>{q.name}</option>)}
            <option value="reactions">Box reactions</option>
          </optgroup>
          {columns.value.length ? <optgroup label={`Time histories: ${selected.value ? runName(selected.value) : ''}`}>{columns.value.map((c) => <option key={c.name} value={`history:${c.name}`} title={c.text}>{columnName(c.name)}</option>)}</optgroup> : null}
        </select>
        <output class="read" aria-live="off" title={read}>{read}</output>
        <span class="exports">{(['png', 'svg', 'csv'] as const).map((kind) => <button key={kind} type="button" class="tiny" disabled={!data} title={`Save as ${kind.toUpperCase()}`} onClick={() => chart.current?.export(kind)}>{kind}</button>)}</span>
      </figcaption>
      {data ? <Legend data={data} /> : null}
      <div class="plot" ref={box} style={data ? undefined : { visibility: 'hidden' }} title={inTime ? 'Drag to zoom, double-click to reset, click to go to an instant' : 'Drag to zoom, double-click to reset'} />
      {data ? null : <p class="empty over">{inTime ? 'Loading…' : empty()}</p>}
    </figure>
  );
}

export function Diagrams() {
  const count = shownSlots();
  return <section class="diagrams" style={stacked() ? undefined : { gridTemplateColumns: `repeat(${count}, minmax(0, 1fr))` }} aria-label="Diagrams">{Array.from({ length: count }, (_, i) => <Slot key={i} index={i} />)}</section>;
}
