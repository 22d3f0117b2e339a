// The lay table over one key: its rows, each of which can be opened in Lay.
import { Table, type RowAction } from '../../components/Table';
import type { LayTable } from '../../api/types';
import { layRowKeys, layRowName, layRows } from '../../logic/laytable';
import { withTwin } from '../../logic/show';
import { openInLay, triedValues } from '../../state/studies';

export function LayRows({ of }: { of: LayTable }) {
  const names = of.rows.map((_, i) => layRowName(of, i));
  const action = (name: string): RowAction | undefined => {
    const set = triedValues(layRowKeys(of, names.indexOf(name)));
    return set && Object.keys(set).length ? { act: () => openInLay(set), title: 'Open this row in Lay with trial values; the model is not changed' } : undefined;
  };
  return <Table table={{ ...layRows(of), title: '' }} sortable copyable rowAction={action} numberTitle={(number, { unit }) => withTwin(number, unit)} />;
}
