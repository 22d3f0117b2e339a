// Heads of a grid: a click sorts, the unit can be selected, groups of results have a common head.
import type { ViewColumn } from '../../logic/gridView';

export interface Sorting { column: string; descending: boolean }

interface Props {
  columns: ViewColumn[];
  sorting: Sorting | null;
  sort: (column: ViewColumn) => void;
  chooseUnit: (column: ViewColumn, unit: string) => void;
  selectAll: () => void;
}

function groupsIn(columns: ViewColumn[]): [title: string, span: number][] {
  const groups: [string, number][] = [];
  for (const { group } of columns) {
    const last = groups.at(-1);
    if (last?.[0] === group) ++last[1];
    else groups.push([group, 1]);
  }
  return groups;
}

function Unit({ column, choose }: { column: ViewColumn; choose: (unit: string) => void }) {
  if (!column.unit) return null;
  if (column.units.length < 2) return <span class="unit">[{column.unit}]</span>;
  return (
    <select class="unit" value={column.unit} aria-label={`Unit of ${column.title}`} title="Unit of this column; the model keeps its own units" onChange={(e) => choose(e.currentTarget.value)}>
      {[...column.units].sort().map((unit) => <option key={unit} value={unit}>[{unit}]</option>)}
    </select>
  );
}

export function GridHead({ columns, sorting, sort, chooseUnit, selectAll }: Props) {
  const groups = groupsIn(columns);
  const sortOrder = (c: ViewColumn): 'ascending' | 'descending' | 'none' => (sorting?.column === c.id ? (sorting.descending ? 'descending' : 'ascending') : 'none');
  return (
    <thead>
      {groups.length > 1 ? (
        <tr class="groups">
          <td />
          {groups.map(([title, span]) => <th colSpan={span} scope="colgroup">{title}</th>)}
        </tr>
      ) : null}
      <tr aria-rowindex={1}>
        <th class="corner"><button type="button" tabIndex={-1} aria-label="Select all" title="Select all (Ctrl A)" onClick={selectAll} /></th>
        {columns.map((c) => (
          <th key={c.id} scope="col" aria-sort={sortOrder(c)} class={`${c.isText ? 't' : 'n'}${c.editable ? '' : ' result'}`} title={c.info}>
            <button type="button" class="sort" tabIndex={-1} onClick={() => sort(c)}>
              {c.title}
            </button>
            <Unit column={c} choose={(unit) => chooseUnit(c, unit)} />
          </th>
        ))}
      </tr>
    </thead>
  );
}
