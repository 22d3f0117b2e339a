// The tables that the program makes of results, each behind its title.
import { useRef, useState } from 'preact/hooks';
import type { Lay } from '../api/types';
import type { TableData } from '../components/document';
import { Table, type RowAction } from '../components/Table';
import { withTwin } from '../logic/show';
import { cursor } from '../state/look';
import { chooseLine, chosenLine } from '../state/moorings';

type Tables = [file: string, table: TableData][];

/** Of those with one title that of the run, which has the values at rest as well. */
function tablesIn({ tables, run_tables }: Lay): Tables | undefined {
  const all = [...Object.entries(tables ?? {}), ...Object.entries(run_tables ?? {}).map(([name, table]) => [`run_${name}`, table] as const)];
  return tables && [...new Map(all.map(([file, table]) => [table.title, [file, table]] as const)).values()] as Tables;
}

/** Names of lines choose the line, those of roller boxes show where they are. */
function actionIn(lay: Lay, name: string): RowAction | undefined {
  const box = lay.supports.find((support) => support.name === name);
  if (box) return { act: () => { cursor.value = box.s; }, title: 'Show the location' };
  const lines = [...lay.lines, ...(lay.moorings?.rest.moorings ?? [])];
  if (!lines.some((line) => line.name === name)) return undefined;
  return { act: () => chooseLine(name), title: 'Show this line', chosen: chosenLine.value === name };
}

/** Long ones are drawn only when they are unfolded. */
function FoldedTable({ file, table, lay }: { file: string; table: TableData; lay: Lay }) {
  const [open, setOpen] = useState(false);
  return (
    <details onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>{table.title}</summary>
      {open ? (
        <Table
          table={{ ...table, title: '' }}
          sortable
          copyable
          file={file}
          rowAction={(first) => actionIn(lay, first)}
          numberTitle={(number, { unit }) => withTwin(number, unit)}
        />
      ) : null}
    </details>
  );
}

export function Tables({ lay }: { lay: Lay | null }) {
  const known = useRef<Tables>([]);
  const tables = lay && tablesIn(lay);
  if (tables) known.current = tables;
  if (!lay || known.current.length === 0) return null;
  return (
    <section class={`tables${tables ? '' : ' old'}`} aria-label="Tables of results">
      <h3>Tables</h3>
      {known.current.map(([file, table]) => <FoldedTable key={table.title} file={file} table={table} lay={lay} />)}
    </section>
  );
}
