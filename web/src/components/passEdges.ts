// Where in a map of cells passing ends.

type Cell = { state: string } | null | undefined;

/** Edges between a cell that passes and a neighbour that does not: their corner (column, row) and which way they run. */
export function passEdges(cells: readonly (readonly Cell[])[]): [i: number, j: number, right: 0 | 1, up: 0 | 1][] {
  const edges: [number, number, 0 | 1, 0 | 1][] = [];
  const differ = (a: Cell, b: Cell): boolean => Boolean(a && b) && (a!.state === 'passed') !== (b!.state === 'passed');
  cells.forEach((row, j) => row.forEach((cell, i) => {
    if (differ(cell, row[i + 1])) edges.push([i + 1, j, 0, 1]);
    if (differ(cell, cells[j + 1]?.[i])) edges.push([i, j + 1, 1, 0]);
  }));
  return edges;
}
