// A history of the selected run as a diagram, fetched for the visible range only.
import { useEffect, useState } from 'preact/hooks';
import { colours, type ChartData } from '../charts/data';
import { display } from '../logic/show';
import { columnName } from '../logic/tensioner';
import { columns, fetchSeries, selected } from '../state/runs';

/** Points are the minimum and maximum of each pixel; during a run the diagram is updated in steps. */
export function useHistory(name: string, zoom: [number, number] | null, pixels: number): ChartData | null {
  const [data, setData] = useState<ChartData | null>(null);
  const run = selected.value;
  const column = columns.value.find((c) => c.name === name);
  const stage = run?.state === 'running' ? Math.floor((run.progress ?? 0) * 40) : run?.state;
  useEffect(() => {
    if (!column || !run || (!run.has_results && run.state !== 'running')) { setData(null); return undefined; }
    let gone = false;
    void fetchSeries(run.id, [column.name], zoom?.[0] ?? null, zoom?.[1] ?? null, pixels).then((answer) => {
      const s = answer[column.name];
      if (gone || !s) return;
      const [unit, factor] = display(column.unit);
      const shown = (values: number[]): number[] => values.map((v) => v * factor);
      const axis = columnName(column.name).toLowerCase().replace('von mises', 'von Mises').replace(/ \(.*/, '');
      setData({
        title: columnName(column.name), xName: 'time [s]', yName: `${axis} [${unit}]`, x: s.t, s: s.t, marks: [], level: [],
        lines: [
          { name: 'largest', colour: colours.current, values: shown(s.max), band: true },
          { name: 'least', colour: colours.current, values: shown(s.min), band: true },
        ],
      });
    }).catch(() => undefined);
    return () => { gone = true; };
  }, [name, run?.id, stage, zoom?.[0], zoom?.[1], pixels, column?.name]);
  return data;
}
