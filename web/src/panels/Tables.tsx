// Result tables of the program, each folded below its title.
import { useRef, useState } from 'preact/hooks';
import type { Lay } from '../api/types';
import type { TableData } from '../components/document';
import { Table, type RowAction } from '../components/Table';
import { withTwin } from '../logic/show';
import { pathOfName } from '../state/findings';
import { cursor } from '../state/look';
import { chooseLine, chosenLine } from '../state/moorings';
import { selectObject } from '../state/workspace';

type Tables = [file: string, table: TableData][];

/** If two tables have the same title, that of the run, which includes the static values. */
function tablesIn({ tables, run_tables }: Lay): Tables | undefined {
  const all = [...Object.entries(tables ?? {}), ...Object.entries(run_tables ?? {}).map(([name, table]) => [`run_${name}`, table] as const)];
  return tables && [...new Map(all.map(([file, table]) => [table.title, [file, table]] as const)).values()] as Tables;
}

/** Names of lines select the line, those of roller boxes show their location. */
function actionIn(lay: Lay, name: string): RowAction | undefined {
  const box = lay.supports.find((support) => support.name === name);
  if (box) return { act: () => { cursor.value = box.s; selectObject(pathOfName(name)); }, title: 'Show the location' };
  const lines = [...lay.lines, ...(lay.moorings?.rest.moorings ?? [])];
  if (!lines.some((line) => line.name === name)) return undefined;
  return { act: () => chooseLine(name), title: 'Show this line', chosen: chosenLine.value === name };
}

interface TableProps { file: string; table: TableData; lay: Lay }

function OpenTable({ file, table, lay }: TableProps) {
  return (
    <Table
      table={table}
      sortable
      copyable
      file={file}
      rowAction={(first) => actionIn(lay, first)}
      numberTitle={(number, { unit }) => withTwin(number, unit)}
    />
  );
}

/** Long tables are drawn only when they are unfolded. */
function FoldedTable({ file, table, lay }: TableProps) {
  const [open, setOpen] = useState(false);
  return (
    <details onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>{table.title}</summary>
      {open ? <OpenTable file={file} table={{ ...table, title: '' }} lay={lay} /> : null}
    </details>
  );
}

/** All tables, folded; `names`: these only, unfolded. */
export function Tables({ lay, names }: { lay: Lay | null; names?: string[] }) {
  const known = useRef<Tables>([]);
  const tables = lay && tablesIn(lay);
  if (tables) known.current = tables;
  if (!lay || known.current.length === 0) return null;
  return (
    <section class={`tables${tables ? '' : ' old'}`} aria-label="Tables of results">
      {known.current.map(([file, table]) => (names ? names.includes(file) ? <OpenTable key={table.title} file={file} table={table} lay={lay} /> : null : <FoldedTable key={table.title} file={file} table={table} lay={lay} />))}
    </section>
  );
}
