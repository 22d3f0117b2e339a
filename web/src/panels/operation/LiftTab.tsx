// Lines and davits of the selected stage: the program's tables of lines.
import { Table } from '../../components/Table';
import { withTwin } from '../../logic/show';
import { chooseLine, chosenLine } from '../../state/moorings';
import { operation, stageLay } from '../../state/operation';
import { calmLay } from '../../state/shown';
import { NotSolved } from './NotSolved';

const names = ['lines', 'line_ends'];

export function LiftTab() {
  const lay = stageLay.value ?? calmLay.value;
  if (!lay) return <NotSolved />;
  const tables = Object.entries(lay.tables ?? {}).filter(([name]) => names.includes(name));
  const known = (name: string): boolean => lay.lines.some((line) => line.name === name);
  return (
    <div class="lifttab">
      {stageLay.value || !operation.value ? null : <p class="brief">Select a stage to see its lines.</p>}
      {tables.map(([name, table]) => (
        <Table key={name} table={table} sortable copyable file={name} numberTitle={(number, { unit }) => withTwin(number, unit)}
          rowAction={(line) => (known(line) ? { act: () => chooseLine(line), title: 'Show this line', chosen: chosenLine.value === line } : undefined)} />
      ))}
      {tables.length === 0 ? <p class="empty">There are no lines other than the pipe.</p> : null}
    </div>
  );
}
