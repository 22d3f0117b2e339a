// Buttons that copy a table and save it as CSV or as a workbook.
import { useState } from 'preact/hooks';
import type { TableData } from '../components/document';
import { download } from '../components/download';
import { tableCsv, tableText } from '../components/tableText';
import { makeSheet, workbook } from '../components/workbook';

export function TableTools({ table, file }: { table: () => TableData; file: string }) {
  const [state, setState] = useState('');
  const copy = (): Promise<void> => navigator.clipboard.writeText(tableText(table())).then(() => setState('copied'), () => setState('not permitted by the browser'));
  return (
    <span class="tools" onMouseLeave={() => setState('')}>
      <span role="status">{state}</span>
      <button type="button" class="tiny" title="Copy the table as tab-separated text" onClick={() => void copy()}>copy</button>
      <button type="button" class="tiny" title="Save the table as CSV" onClick={() => download(`${file}.csv`, new Blob([tableCsv(table())], { type: 'text/csv' }))}>csv</button>
      <button type="button" class="tiny" title="Save the table as XLSX" onClick={() => download(`${file}.xlsx`, workbook([makeSheet(table())]))}>xlsx</button>
    </span>
  );
}
