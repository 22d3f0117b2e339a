// Histories of the run side by side, and spectra of histories.
import { signal, type Signal } from '@preact/signals';
import { useEffect, useState } from 'preact/hooks';
import { get } from '../../api/client';
import { colours, type ChartData } from '../../charts/data';
import { display, unitName } from '../../logic/show';
import { firstHistories, shownFrequencies } from '../../logic/stormTables';
import { columnName } from '../../logic/tensioner';
import { tidy } from '../../logic/units';
import { active, seek, time } from '../../state/animation';
import { byPath } from '../../state/model';
import { columns, selected } from '../../state/runs';
import { stormHistories } from '../../state/storm';
import { useHistory } from '../useHistory';
import { Plot } from '../Plot';
import { emptyText, plotCount, TabFrame, useWidth } from './TabFrame';

const spectra = signal<string[]>([]);

/** Selected histories that the run has, completed with default ones. */
function chosenNames(chosen: readonly string[]): string[] {
  const names = columns.value.map((column) => column.name);
  const first = firstHistories(names).filter((name) => !chosen.includes(name));
  const list = chosen.filter((name) => name === '' || names.includes(name)).map((name) => name || first.shift() || '');
  return [...list, ...first].filter(Boolean);
}

interface ChoiceProps { label: string; name: string; index: number; chosen: Signal<string[]> }

function Choice({ label, name, index, chosen }: ChoiceProps) {
  const choose = (next: string): void => {
    const list = chosenNames(chosen.value);
    list[index] = next;
    chosen.value = list;
  };
  return (
    <select aria-label={`${label} ${index + 1}`} value={name} onChange={(e) => choose(e.currentTarget.value)}>
      {columns.value.map((column) => <option key={column.name} value={column.name} title={column.text}>{columnName(column.name)}</option>)}
    </select>
  );
}

/** Tension range of the tensioner, for histories of its tension. */
function range(name: string): [number, number] | null {
  if (!/^(top_tension|tensioner\/tension)$/.test(name)) return null;
  const low = byPath.value.get('tensioner.range[0]')?.si, high = byPath.value.get('tensioner.range[1]')?.si;
  const factor = display('N')[1];
  return typeof low === 'number' && typeof high === 'number' ? [low * factor, high * factor] : null;
}

export function History({ name, children }: { name: string; children: preact.ComponentChildren }) {
  const [zoom, setZoom] = useState<[number, number] | null>(null);
  const [pixels, setPixels] = useState(600);
  const data = useHistory(name, zoom, pixels);
  useEffect(() => setZoom(null), [name, selected.value?.id]);
  return (
    <Plot
      data={data}
      empty="Loading…"
      extra={{ shade: range(name), position: active.value ? time.value : null }}
      title="Drag to zoom, double-click to reset, click to go to a time"
      onClick={(x) => { if (active.value) seek(x); }}
      onZoom={setZoom}
      onWidth={setPixels}
    >
      {children}
    </Plot>
  );
}

export function Histories() {
  const [box, width] = useWidth();
  const names = chosenNames(stormHistories.value).slice(0, plotCount(width));
  return (
    <TabFrame>
      <div class="stormplots" ref={box} style={{ gridTemplateColumns: `repeat(${Math.max(1, names.length)}, minmax(0, 1fr))` }}>
        {names.map((name, i) => (
          <History key={i} name={name}><Choice label="History" name={name} index={i} chosen={stormHistories} /></History>
        ))}
        {names.length ? null : <p class="empty">{emptyText()}</p>}
      </div>
    </TabFrame>
  );
}

interface Spectrum { frequency: number[]; density: number[]; segments: number; std: number }

function spectrumData(name: string, si: string, { frequency, density, segments, std }: Spectrum): ChartData {
  const [unit, factor] = display(si), n = shownFrequencies(frequency, density);
  const x = frequency.slice(0, n), values = density.slice(0, n).map((d) => d * factor * factor);
  const peak = values.reduce((best, d, i) => (d > values[best]! ? i : best), 0);
  const period = x[peak] ? `, peak at ${tidy(1 / x[peak]!, 3)} s` : '';
  return {
    title: columnName(name), xName: 'frequency [Hz]', yName: `spectral density [(${unit})²/Hz]`, x, s: x, marks: [], level: [],
    lines: [{ name: `std ${tidy(std * factor, 4)} ${unitName(si)}${period}, ${segments} segment${segments === 1 ? '' : 's'}`, colour: colours.current, values }],
  };
}

/** Spectrum of a history of the selected run, updated when the run has ended. */
function useSpectrum(name: string): ChartData | null {
  const [data, setData] = useState<ChartData | null>(null);
  const run = selected.value, column = columns.value.find((c) => c.name === name);
  useEffect(() => {
    setData(null);
    if (!run || !column) return undefined;
    let gone = false;
    get<Spectrum>(`runs/${run.id}/spectrum?name=${encodeURIComponent(name)}`)
      .then((answer) => { if (!gone && answer.frequency.length) setData(spectrumData(name, column.unit, answer)); })
      .catch(() => undefined);
    return () => { gone = true; };
  }, [run?.id, run?.state, column?.name]);
  return data;
}

function SpectrumPlot({ name, index }: { name: string; index: number }) {
  const data = useSpectrum(name);
  return (
    <Plot data={data} empty="No spectrum: the run is too short." title="Drag to zoom, double-click to reset">
      <Choice label="Spectrum" name={name} index={index} chosen={spectra} />
      {data ? <small>{data.lines[0]!.name}</small> : null}
    </Plot>
  );
}

export function Spectra() {
  const [box, width] = useWidth();
  const names = chosenNames(spectra.value).slice(0, plotCount(width));
  return (
    <TabFrame>
      <div class="stormplots" ref={box} style={{ gridTemplateColumns: `repeat(${Math.max(1, names.length)}, minmax(0, 1fr))` }}>
        {names.map((name, i) => <SpectrumPlot key={i} name={name} index={i} />)}
        {names.length ? null : <p class="empty">{emptyText()}</p>}
      </div>
    </TabFrame>
  );
}
