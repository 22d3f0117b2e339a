// A diagram with heading, values under the pointer and exports.
import type { ComponentChildren } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { Chart, type Extra } from '../charts/chart';
import type { ChartData } from '../charts/data';
import { inkOnPage } from '../charts/ink';
import { shownLines } from '../charts/marks';
import { nearest } from '../logic/series';
import { theme } from '../state/look';

interface Props {
  data: ChartData | null;
  /** Selection of the quantity, at the left of the heading. */
  children: ComponentChildren;
  empty: string;
  extra?: Extra;
  /** Arc length at the cursor, shared with other diagrams. */
  cursor?: number | null;
  title?: string;
  onHover?: (position: number | null) => void;
  onClick?: (x: number) => void;
  onZoom?: (range: [number, number] | null) => void;
  onWidth?: (pixels: number) => void;
  legend?: boolean;
  /** True for outdated values. */
  old?: boolean;
}

function Legend({ data }: { data: ChartData }) {
  return (
    <ul class="chartlegend" aria-label="Lines">
      {shownLines(data).map((line) => {
        const look = line.band ? 'band' : line.width === -1 ? 'barkey' : line.dash ? 'dashed' : '';
        return <li key={line.name}><i class={look} style={{ '--line': inkOnPage(line.colour, theme.value === 'dark') }} />{line.name}</li>;
      })}
    </ul>
  );
}

export function Plot(props: Props) {
  const { data, extra = {}, cursor } = props;
  const box = useRef<HTMLDivElement>(null), chart = useRef<Chart | null>(null);
  const latest = useRef(props);
  latest.current = props;
  const [read, setRead] = useState('');
  useEffect(() => {
    const drawn = new Chart(box.current!, {
      hover: (_x, i) => { setRead(drawn.readAt(i) ?? ''); latest.current.onHover?.(i === null ? null : latest.current.data?.s[i] ?? null); },
      click: (x) => latest.current.onClick?.(x),
      zoom: (low, high, whole) => latest.current.onZoom?.(whole ? null : [low, high]),
    });
    chart.current = drawn;
    const observer = new ResizeObserver(() => { drawn.resize(); latest.current.onWidth?.(Math.round(box.current!.clientWidth / 50) * 50); });
    observer.observe(box.current!);
    return () => { observer.disconnect(); drawn.destroy(); };
  }, []);
  useEffect(() => { if (data) chart.current?.set(data, extra); }, [data, theme.value, extra.shade?.[0], extra.shade?.[1]]);
  useEffect(() => chart.current?.setPosition(extra.position ?? null), [extra.position]);
  useEffect(() => {
    if (cursor === undefined) return;
    chart.current?.setCursor(cursor);
    if (box.current?.matches(':hover')) return;
    const places = latest.current.data?.s;
    setRead(cursor === null || !places ? '' : chart.current?.readAt(nearest(places, cursor)) ?? '');
  }, [cursor]);
  return (
    <figure class={`slot${props.old ? ' old' : ''}`}>
      <figcaption>
        {props.children}
        <output class="read" aria-live="off" title={read}>{read}</output>
        <span class="exports">
          {(['png', 'svg', 'csv'] as const).map((kind) => (
            <button key={kind} type="button" class="tiny" disabled={!data} title={`Save as ${kind.toUpperCase()}`} onClick={() => chart.current?.export(kind)}>{kind}</button>
          ))}
        </span>
      </figcaption>
      {data && props.legend && data.lines.length > 1 ? <Legend data={data} /> : null}
      <div class="plot" ref={box} style={data ? undefined : { visibility: 'hidden' }} title={props.title} />
      {data ? null : <p class="empty over">{props.empty}</p>}
    </figure>
  );
}
