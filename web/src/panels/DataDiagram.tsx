// A diagram of given data: zoom by dragging, values under the pointer, saved as PNG, SVG or CSV.
import { useEffect, useRef, useState } from 'preact/hooks';
import { Chart } from '../charts/chart';
import type { ChartData } from '../charts/data';
import { inkOnPage } from '../charts/ink';
import { theme } from '../state/look';
import '../styles/datadiagram.css';

interface Props {
  data: ChartData;
  /** Position of the vertical line. */
  position?: number | null;
  /** A click in the plot: index of the nearest point. */
  onPick?: (index: number) => void;
  /** True for outdated results. */
  old?: boolean;
  /** Content next to the title, such as a menu. */
  children?: preact.ComponentChildren;
}

function nearestIndex(x: readonly number[], value: number): number {
  return x.reduce((best, v, i) => (Math.abs(v - value) < Math.abs(x[best]! - value) ? i : best), 0);
}

function Legend({ data: { lines } }: { data: ChartData }) {
  if (lines.length < 2) return null;
  return <ul class="chartlegend" aria-label="Lines">{lines.map((l) => <li key={l.name}><i class={l.dash ? 'dashed' : ''} style={{ '--line': inkOnPage(l.colour, theme.value === 'dark') }} />{l.name}</li>)}</ul>;
}

export function DataDiagram({ data, position = null, onPick, old, children }: Props) {
  const box = useRef<HTMLDivElement>(null), chart = useRef<Chart | null>(null);
  const [read, setRead] = useState('');
  const latest = useRef({ data, onPick });
  latest.current = { data, onPick };
  useEffect(() => {
    const drawn = new Chart(box.current!, {
      hover: (_x, i) => setRead(drawn.readAt(i) ?? ''),
      click: (x) => latest.current.onPick?.(nearestIndex(latest.current.data.x, x)),
      zoom: () => undefined,
    });
    chart.current = drawn;
    const observer = new ResizeObserver(() => drawn.resize());
    observer.observe(box.current!);
    return () => { observer.disconnect(); drawn.destroy(); };
  }, []);
  useEffect(() => { chart.current?.set(data, { position }); }, [data, theme.value]);
  useEffect(() => { chart.current?.setPosition(position); }, [position]);
  return (
    <figure class={`slot datadiagram${old ? ' old' : ''}`} aria-label={data.title}>
      <figcaption>
        {children ?? <b>{data.title}</b>}
        <output class="read" aria-live="off" title={read}>{read}</output>
        <span class="exports">{(['png', 'svg', 'csv'] as const).map((kind) => <button key={kind} type="button" class="tiny" title={`Save as ${kind.toUpperCase()}`} onClick={() => chart.current?.export(kind)}>{kind}</button>)}</span>
      </figcaption>
      <Legend data={data} />
      <div class="plot" ref={box} title={onPick ? 'Drag to zoom, double-click to reset, click to choose' : 'Drag to zoom, double-click to reset'} />
    </figure>
  );
}
