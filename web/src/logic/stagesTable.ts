// The stages of an operation as a table with numbers, for files.
import type { Operation } from '../api/types';
import type { TableData } from '../components/document';
import { stageColumns, columnUnit, stageName, whyNot } from './operation';
import { shownUnit } from './show';

export function stagesTable(of: Operation): TableData {
  const columns = stageColumns(of);
  const factor = (unit: string): number => (unit === '%' ? 100 : unit === '' ? 1 : shownUnit(unit).factor);
  return {
    title: 'Stages', look: 'plain',
    columns: [{ title: 'stage', words: true }, ...columns.map((c) => ({ title: c.name, unit: columnUnit(c) || undefined, digits: c.digits })), { title: 'check', words: true }, { title: 'remark', words: true }],
    rows: of.stages.map((stage, i) => [
      stageName(stage, i), ...columns.map((c) => { const value = c.value(stage); return value === null ? null : value * factor(c.unit); }), stage.values?.check ?? '', whyNot(stage)]),
  };
}
