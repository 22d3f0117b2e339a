// A list of the model as a table, with the results of its rows.
import { useState } from 'preact/hooks';
import type { ComponentChildren } from 'preact';
import { isList, isRow, listAround, structureAround } from '../../logic/gridTables';
import { parts, label } from '../../logic/formTree';
import { findArcErrors, rampEnd, generatedBoxes, readArcRequest, writtenOut } from '../../logic/gridGenerate';
import type { Pasted } from '../../logic/gridPaste';
import { diagnosticsByKey, isPlaced, type ViewColumn, type ViewList, type ViewRow } from '../../logic/gridView';
import { dropDrafts, drafts, schema, writeChanges } from '../../state/gridEdit';
import { allColumns, askColumns, chooseUnit, dropCells, editCells, pasteAt, pasteTable, readTable, useGridTable, type GridTable } from '../../state/gridTable';
import { byPath, diagnostics, writing } from '../../state/model';
import { say } from '../../state/notices';
import { shownFailure } from '../../state/shown';
import { object, selectObject, showDockTab } from '../../state/workspace';
import { Generate } from './Generate';
import { Grid } from './Grid';
import type { PastePlace } from './gridParts';
import { GridTools, moveRows } from './GridTools';
import { PasteOffer, pastedText } from './PasteOffer';

/** True if the object at a path is a list, which has a table. */
export const hasGrid = (path: string): boolean => path !== '' && isList(path, byPath.value, schema.value);

/** A row of boxes on an arc: its values, and its conversion to a list. */
function ArcNote({ list, generate }: { list: ViewList; generate: () => void }) {
  const structure = structureAround(list.path), request = readArcRequest(byPath.value, structure), end = structure === 'supports.stinger' ? rampEnd(byPath.value) : null;
  const boxes = findArcErrors(request, end).length === 0 ? generatedBoxes(request, end) : [];
  return (
    <div class="gridstrip">
      <p>The {list.title} is defined as a row: {request.count} boxes at a spacing of {request.spacing} on a radius of {request.radius}.</p>
      <button type="button" onClick={generate}>Change …</button>
      <button type="button" disabled={boxes.length === 0} onClick={() => void writeChanges(writtenOut(structure, request, boxes, byPath.value.get(`${structure}.radius`)?.given ?? false))}>Convert to a list</button>
    </div>
  );
}

function Said({ list }: { list: ViewList }) {
  const d = diagnosticsByKey(diagnostics.value).get(list.path);
  return d ? <p class={d.severity === 'error' ? 'failuretext' : 'note'} role={d.severity === 'error' ? 'alert' : undefined}>{d.message}</p> : null;
}

/** Cells with unreadable text; they are not in the model. */
function Unread({ rows }: { rows: ViewRow[] }) {
  const bad = rows.flatMap((row) => row.cells.filter((cell) => cell.state === 'bad').map(() => row));
  if (bad.length === 0) return null;
  const drop = (): void => dropDrafts([...drafts.value].filter(([path, d]) => d.message && rows.some((row) => path === row.id || path.startsWith(`${row.id}.`))).map(([path]) => path));
  return (
    <div class="gridstrip bad" role="alert">
      <p>{bad.length === 1 ? '1 cell is' : `${bad.length} cells are`} not in the model: correct or discard the text.</p>
      <button type="button" onClick={() => selectObject(bad[0]!.id)}>Show</button>
      <button type="button" onClick={drop}>Discard</button>
    </div>
  );
}

interface TableProps {
  id: string;
  label: string;
  lists: ViewList[];
  /** Effect of selecting a row in addition to its object: the position along the pipe. */
  choose?: (row: ViewRow) => void;
  tools?: ComponentChildren;
}

/** Pasted rows that name their list are added to it. */
function takeNamed(table: GridTable, pasted: Pasted, lists: ViewList[]): boolean {
  const named = lists.map((list) => ({ list, rows: pasted.rows.filter((row) => row.list.toLowerCase() === list.title.toLowerCase()) })).filter((p) => p.rows.length > 0);
  if (named.length === 0 || named.reduce((sum, p) => sum + p.rows.length, 0) !== pasted.rows.length) return false;
  for (const { list, rows } of named) void pasteTable(list.path, allColumns(table), { ...pasted, rows }, 'replace');
  return true;
}

export function ModelTable({ id, label: name, lists, choose, tools }: TableProps) {
  const table = useGridTable(lists);
  const [offer, setOffer] = useState<Pasted | null>(null);
  const [generating, setGenerating] = useState('');
  if (!table) return <p class="empty">{schema.value ? 'This object has no table.' : 'Reading the columns …'}</p>;
  const structures = [...new Set(lists.filter((l) => /^supports\.(ramp|stinger)\.boxes$/.test(l.path)).map((l) => structureAround(l.path)))].reverse();

  const paste = (text: string, place: PastePlace | null): void => {
    if (place && !place.all && !place.rows.some(isPlaced)) { const pasted = pasteAt(table, text, place); if (pasted.ignored.length) say(pastedText(pasted)); return; }
    const pasted = readTable(table, text);
    if (pasted.rows.length === 0) return;
    if (lists.length > 1 && takeNamed(table, pasted, lists)) say(`Pasted: ${pastedText(pasted)}`);
    else setOffer(pasted);
  };
  const take = async (list: string, mode: 'replace' | 'append'): Promise<void> => {
    const done = await pasteTable(list, allColumns(table), offer!, mode);
    if (done) { askColumns(table.key, offer!.columns.map((c) => c.id)); setOffer(null); }
  };
  return (
    <Grid
      id={id}
      label={name}
      columns={table.columns}
      rows={table.rows}
      chosen={object.value}
      choose={(row) => { selectObject(isPlaced(row) ? structureAround(row.id) : row.id); choose?.(row); }}
      edit={editCells}
      paste={paste}
      chooseUnit={(column: ViewColumn, unit) => chooseUnit(table.key, column, unit)}
      drop={dropCells}
      isOld={shownFailure.value !== null}
      move={(rows, step) => void moveRows(rows, step)}
      tools={({ rows, sorted, copy, save }) => (
        <GridTools table={table} list={lists.at(-1)!.path} selected={rows.filter((row) => !isPlaced(row))} sorted={sorted} copy={copy} save={save}>
          {structures.map((s) => <button key={s} type="button" onClick={() => setGenerating(s)} title="Boxes from radius, number and spacing">Generate {structures.length > 1 ? s.replace('supports.', '') : ''} …</button>)}
          {tools}
        </GridTools>
      )}
      notes={(
        <>
          {lists.map((list) => <Said key={list.path} list={list} />)}
          {lists.filter((list) => isRow(byPath.value, list.path)).map((list) => <ArcNote key={list.path} list={list} generate={() => setGenerating(structureAround(list.path))} />)}
          {generating ? <Generate key={generating} structure={generating} close={() => setGenerating('')} /> : null}
          {offer ? <PasteOffer pasted={offer} lists={lists} take={(list, mode) => void take(list, mode)} close={() => setOffer(null)} /> : null}
          <Unread rows={table.rows} />
          {table.rows.length === 0 && writing.value === 0 ? <p class="brief gridempty">No rows. Paste a table from a spreadsheet, or add a row.</p> : null}
          {lists.some((list) => (byPath.value.get(list.path)?.count ?? 0) > 200) ? <p class="note">The first 200 rows are shown; the others are in the YAML.</p> : null}
        </>
      )}
    />
  );
}

/** The list at a path of the model. */
export function ListGrid({ path }: { path: string }) {
  const title = parts(path).map(label).join(' ');
  return <ModelTable key={path} id={`grid-${path.replace(/[^\w]+/g, '-')}`} label={title} lists={[{ path, title }]} />;
}

/** The selected list, or the list of the selected object; boxes have a separate table. */
function objectList(): string {
  const path = object.value, list = hasGrid(path) ? path : listAround(path);
  return /\.boxes$/.test(list) && structureAround(list) ? '' : list;
}

export const hasTable = (): boolean => objectList() !== '';
export const ObjectTable = () => <ListGrid path={objectList()} />;

/** Shows the table of a list below the picture. */
export function openTable(path: string): void {
  selectObject(path);
  showDockTab('lay', objectList() ? 'objecttable' : 'boxes');
}
