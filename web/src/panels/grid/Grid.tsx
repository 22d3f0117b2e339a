// An editable table, operated as a spreadsheet: cells are selected, typed into, copied, pasted and cleared; the effect
// of that is defined by its owner.
import type { ComponentChildren } from 'preact';
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { csvText } from '../../components/tableText';
import { download } from '../../components/download';
import { tabText } from '../../logic/gridClipboard';
import { clamped, moved, rectangle, spotRange, tabbed, type Range, type Rectangle } from '../../logic/gridSelection';
import { isPlaced, sortedRows, type ViewColumn, type ViewRow } from '../../logic/gridView';
import { GridHead, type Sorting } from './GridHead';
import { GridRow } from './GridRow';
import { headText, isElsewhere, isTyped, spotUnder, type GridCell, type PastePlace } from './gridParts';
import '../../styles/grid.css';

export interface GridProps {
  /** Distinguishes it from other grids on the page. */
  id: string;
  label: string;
  columns: ViewColumn[];
  rows: ViewRow[];
  chosen: string;
  choose: (row: ViewRow) => void;
  edit: (cells: GridCell[]) => void;
  paste: (text: string, place: PastePlace | null) => void;
  chooseUnit: (column: ViewColumn, unit: string) => void;
  /** Discards drafts of cells: Escape in an unreadable one. */
  drop: (cells: GridCell[]) => void;
  move: (rows: ViewRow[], step: 1 | -1) => void;
  /** Results are outdated. */
  isOld: boolean;
  /** Buttons above; they receive the selected rows. */
  tools: (state: { rows: ViewRow[]; sorted: ViewRow[] | null; copy: (heads: boolean) => void; save: () => void }) => ComponentChildren;
  /** Messages and questions below the tools. */
  notes?: ComponentChildren;
}

/** Delay [ms] after the last key until picture and properties follow the active row. */
const followTime = 150;

export function Grid(props: GridProps) {
  const { id, columns } = props;
  const [range, setRange] = useState<Range | null>(null);
  const [editing, setEditing] = useState<{ row: string; text: string } | null>(null);
  const [sorting, setSorting] = useState<Sorting | null>(null);
  const table = useRef<HTMLTableElement>(null);
  const leaving = useRef(false);
  const dragging = useRef(false);
  const lastChosen = useRef('');
  const following = useRef(0);

  const sortColumn = sorting ? columns.findIndex((c) => c.id === sorting.column) : -1;
  const rows = useMemo(() => (sortColumn < 0 ? props.rows : sortedRows(props.rows, sortColumn, sorting!.descending)), [props.rows, sortColumn, sorting]);
  const inside = range && clamped(range, rows.length, columns.length);
  const box = inside && rectangle(inside);
  const selected = box ? rows.slice(box.top, box.bottom + 1) : [];

  /** `later`: the rest of the page follows after the delay. */
  const select = (next: Range, later = false): void => {
    setRange(next);
    const row = rows[next.focus.row];
    clearTimeout(following.current);
    if (!row || next.anchor.row !== next.focus.row) return;
    const follow = (): void => { lastChosen.current = row.id; if (row.id !== props.chosen) props.choose(row); };
    if (later) following.current = window.setTimeout(follow, followTime);
    else follow();
  };
  useEffect(() => () => clearTimeout(following.current), []);

  // selected elsewhere: the same row here
  useEffect(() => {
    if (props.chosen === lastChosen.current) return;
    lastChosen.current = props.chosen;
    const row = rows.findIndex((r) => r.id === props.chosen || props.chosen.startsWith(`${r.id}.`));
    if (row >= 0 && inside?.focus.row !== row) setRange(spotRange({ row, column: inside?.focus.column ?? 0 }));
  }, [props.chosen]);

  useEffect(() => {
    if (!inside) return;
    document.getElementById(`${id}-${inside.focus.row}-${inside.focus.column}`)?.scrollIntoView?.({ block: 'nearest', inline: 'nearest' });
  }, [inside?.focus.row, inside?.focus.column]);

  const cellsIn = (r: Rectangle): GridCell[] => rows.slice(r.top, r.bottom + 1).flatMap((row) => columns.slice(r.left, r.right + 1).map((column, i) => ({ row, column, text: row.cells[r.left + i]!.text })));

  const copied = (heads: boolean, r: Rectangle): string[][] => {
    const shown = columns.slice(r.left, r.right + 1);
    const body = rows.slice(r.top, r.bottom + 1).map((row) => shown.map((_c, i) => row.cells[r.left + i]!.text));
    return heads ? [shown.map(headText), ...body] : body;
  };
  const whole: Rectangle = { top: 0, bottom: rows.length - 1, left: 0, right: columns.length - 1 };
  const copy = (heads: boolean): void => { void navigator.clipboard?.writeText(tabText(copied(heads, box && (box.top < box.bottom || box.left < box.right) ? box : whole))); };
  const save = (): void => download(`${props.label}.csv`, new Blob([csvText(copied(true, whole))], { type: 'text/csv' }));

  const paste = (text: string): void => {
    if (!box) { props.paste(text, null); return; }
    const all = box.top === 0 && box.bottom === rows.length - 1 && box.left === 0 && box.right === columns.length - 1 && rows.length > 1;
    props.paste(text, { rows: rows.slice(box.top), column: box.left, rectangle: box, all });
  };

  const latest = useRef(paste);
  latest.current = paste;
  useEffect(() => {
    const take = (e: ClipboardEvent): void => {
      if (e.defaultPrevented || !table.current || !isElsewhere(table.current)) return;
      const text = e.clipboardData?.getData('text/plain') ?? '';
      if (!/[\t\n,;]/.test(text.trim())) return;
      e.preventDefault();
      props.paste(text, null);
    };
    document.addEventListener('paste', take);
    return () => document.removeEventListener('paste', take);
  }, [props.paste]);

  const canEdit = inside !== null && columns[inside.focus.column]!.editable && rows[inside.focus.row]!.cells[inside.focus.column]!.state !== 'fixed';
  const begin = (text: string | null): void => {
    if (!inside || !canEdit) return;
    const cell = rows[inside.focus.row]!.cells[inside.focus.column]!;
    setRange(spotRange(inside.focus));
    setEditing({ row: rows[inside.focus.row]!.id, text: text ?? (cell.state === 'standard' ? '' : cell.text) });
  };

  const commit = (text: string, key: string, shift: boolean): void => {
    setEditing(null);
    const row = rows.find((r) => r.id === editing?.row);
    if (!inside || !row) return;
    const column = columns[inside.focus.column]!, cell = row.cells[inside.focus.column]!;
    if (text.trim() !== (cell.state === 'standard' ? '' : cell.text)) props.edit([{ row, column, text }]);
    if (!key) return;
    table.current?.focus({ preventScroll: true });
    const next = key === 'Tab' ? tabbed(inside, shift, rows.length, columns.length) : moved(inside, shift ? 'ArrowUp' : 'ArrowDown', {}, rows.length, columns.length);
    if (next) select(next, true);
  };
  const cancel = (): void => { setEditing(null); table.current?.focus({ preventScroll: true }); };

  const clear = (): void => { if (box) props.edit(cellsIn(box).filter((c) => c.column.editable && !isPlaced(c.row)).map((c) => ({ ...c, text: '' }))); };

  const escape = (): void => {
    const bad = box ? cellsIn(box).filter((c) => c.row.cells[columns.indexOf(c.column)]!.state === 'bad') : [];
    if (bad.length) props.drop(bad);
    else leaving.current = true;
    if (inside) setRange(spotRange(inside.focus));
  };

  const keyDown = (e: KeyboardEvent): void => {
    if (!inside) return;
    const control = e.ctrlKey || e.metaKey;
    if (e.key === 'Tab') {
      const next = leaving.current ? null : tabbed(inside, e.shiftKey, rows.length, columns.length);
      leaving.current = false;
      if (next) { e.preventDefault(); select(next, true); }
      return;
    }
    leaving.current = false;
    const arrow = e.key === 'ArrowUp' || e.key === 'ArrowDown';
    if (e.altKey && arrow) { e.preventDefault(); props.move(selected, e.key === 'ArrowUp' ? -1 : 1); return; }
    const next = e.altKey ? null : moved(inside, e.key, { control, shift: e.shiftKey }, rows.length, columns.length);
    if (next) { e.preventDefault(); select(next, true); return; }
    if (control && e.key.toLowerCase() === 'a') { e.preventDefault(); setRange({ anchor: { row: 0, column: 0 }, focus: { row: rows.length - 1, column: columns.length - 1 } }); return; }
    if (control && e.shiftKey && e.key.toLowerCase() === 'c') { e.preventDefault(); copy(true); return; }
    if (e.key === 'Enter' || e.key === 'F2') { e.preventDefault(); begin(null); return; }
    if (e.key === 'Escape') { escape(); return; }
    if (e.key === 'Delete' || e.key === 'Backspace') { e.preventDefault(); clear(); return; }
    if (isTyped(e) && canEdit) { e.preventDefault(); begin(e.key); }
  };

  const pointerDown = (e: PointerEvent): void => {
    const spot = spotUnder(e.target);
    if (!spot || e.button !== 0 || (e.target as Element).closest('input, button')) return;
    e.preventDefault();
    if (editing !== null) table.current?.querySelector<HTMLInputElement>('input.editor')?.blur();
    table.current?.focus({ preventScroll: true });
    dragging.current = true;
    const first = { row: spot.row, column: spot.column ?? 0 }, last = { row: spot.row, column: spot.column ?? columns.length - 1 };
    select(e.shiftKey && inside ? { anchor: inside.anchor, focus: last } : { anchor: first, focus: last });
  };
  const pointerMove = (e: PointerEvent): void => {
    if (!dragging.current || !inside) return;
    if (!(e.buttons & 1)) { dragging.current = false; return; }
    const spot = spotUnder(e.target);
    if (!spot) return;
    const focus = { row: spot.row, column: spot.column ?? columns.length - 1 };
    if (focus.row !== inside.focus.row || focus.column !== inside.focus.column) setRange({ anchor: inside.anchor, focus });
  };

  const sort = (c: ViewColumn): void => setSorting(sorting?.column !== c.id ? { column: c.id, descending: false } : sorting.descending ? null : { column: c.id, descending: true });
  const active = inside && rows[inside.focus.row]?.cells[inside.focus.column];
  return (
    <div class="gridbox">
      <div class="gridtools">{props.tools({ rows: selected, sorted: sorting ? rows : null, copy, save })}</div>
      {props.notes}
      <div class={`gridscroll${props.isOld ? ' old' : ''}`}>
        <table
          ref={table}
          role="grid"
          tabIndex={0}
          aria-label={props.label}
          aria-multiselectable="true"
          aria-rowcount={rows.length + 1}
          aria-colcount={columns.length}
          aria-activedescendant={inside ? `${id}-${inside.focus.row}-${inside.focus.column}` : undefined}
          aria-description="Enter or F2 edits, Escape and then Tab leaves the table"
          onKeyDown={keyDown}
          onFocus={() => { if (!inside && rows.length) setRange(spotRange({ row: 0, column: 0 })); }}
          onPointerDown={pointerDown}
          onPointerMove={pointerMove}
          onPointerUp={() => { dragging.current = false; }}
          onDblClick={(e) => { if (spotUnder(e.target)?.column != null) begin(null); }}
          onCopy={(e) => {
            if (!box || (e.target as Element).closest('input')) return;
            e.preventDefault();
            e.clipboardData?.setData('text/plain', tabText(copied(false, box)));
          }}
          onPaste={(e) => {
            if ((e.target as Element).closest('input')) return;
            e.preventDefault();
            paste(e.clipboardData?.getData('text/plain') ?? '');
          }}
        >
          <GridHead
            columns={columns}
            sorting={sorting}
            sort={sort}
            chooseUnit={props.chooseUnit}
            selectAll={() => { setRange({ anchor: { row: 0, column: 0 }, focus: { row: rows.length - 1, column: columns.length - 1 } }); table.current?.focus(); }}
          />
          <tbody>
            {rows.map((row, i) => {
              const within = box !== null && i >= box.top && i <= box.bottom, isEdited = editing?.row === row.id;
              const isActive = editing ? isEdited : inside?.focus.row === i;
              return (
                <GridRow
                  key={row.id}
                  row={row}
                  columns={columns}
                  number={i}
                  left={within ? box.left : -1}
                  right={within ? box.right : -1}
                  active={isActive && inside ? inside.focus.column : -1}
                  editing={isEdited ? editing.text : null}
                  chosen={row.id === props.chosen}
                  grid={id}
                  commit={isActive ? commit : nothing}
                  cancel={isActive ? cancel : nothing}
                />
              );
            })}
          </tbody>
        </table>
      </div>
      <p class={`gridsaid ${active?.severity ?? ''}`} role="status">{active ? active.message || columns[inside.focus.column]!.info : ''}</p>
    </div>
  );
}

const nothing = (): void => undefined;
