// The curves of a lay table.
import { LayTableCharts } from '../../components/LayTableCharts';
import type { LayTableData } from '../data';
import type { DrawFigure } from '../figures';

export const layTableFigures: Record<string, DrawFigure> = {
  lay_table: ({ data }) => <LayTableCharts table={(data as { lay_table: LayTableData }).lay_table} />,
};
