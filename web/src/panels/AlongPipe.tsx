// Results along the pipe, a row for each station; a click on its position shows it in picture and diagrams.
import { useMemo } from 'preact/hooks';
import type { TableData } from '../components/document';
import { Table } from '../components/Table';
import { quantities, shownUnit } from '../logic/show';
import type { Lay } from '../api/types';
import { cursor } from '../state/look';
import { calmLay, shownFailure } from '../state/shown';

const places = [['s', 's from tensioner'], ['x', 'x'], ['y', 'y'], ['z', 'z']] as const;

export function stationTable({ pipe }: Lay): TableData {
  const length = shownUnit('m'), shown = quantities.filter((q) => pipe[q.key]?.length === pipe.s.length);
  const lists = [...places.map(([key]) => ({ list: pipe[key], factor: length.factor })), ...shown.map((q) => ({ list: pipe[q.key] as number[], factor: q.factor }))];
  return {
    title: 'Along the pipe',
    look: 'dense',
    columns: [
      ...places.map(([, title]) => ({ title, unit: length.unit, digits: 2 })),
      ...shown.map((q) => ({ title: q.name, unit: q.unit === '–' ? '' : q.unit, digits: q.unit === '–' || q.unit === '%' ? 3 : 1 })),
    ],
    rows: pipe.s.map((_s, i) => lists.map(({ list, factor }) => { const value = list[i]; return value === undefined || !Number.isFinite(value) ? null : value * factor; })),
  };
}

export function AlongPipe() {
  const lay = calmLay.value;
  const table = useMemo(() => (lay ? stationTable(lay) : null), [lay]);
  if (!table) return <p class="empty">No solution yet.</p>;
  const factor = shownUnit('m').factor;
  return (
    <div class={`padded${shownFailure.value ? ' old' : ''}`}>
      <Table table={table} sortable copyable file="along-the-pipe" rowAction={(place) => ({ act: () => { cursor.value = Number(place) / factor; }, title: 'Show the location' })} />
    </div>
  );
}
