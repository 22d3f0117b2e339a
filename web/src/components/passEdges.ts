// Boundary of the passing cells in a map.

type Cell = { state: string } | null | undefined;

/** Edges between a passing cell and a neighbour that does not pass: corner (column, row) and direction. */
export function passEdges(cells: readonly (readonly Cell[])[]): [i: number, j: number, right: 0 | 1, up: 0 | 1][] {
  const edges: [number, number, 0 | 1, 0 | 1][] = [];
  const differ = (a: Cell, b: Cell): boolean => Boolean(a && b) && (a!.state === 'passed') !== (b!.state === 'passed');
  cells.forEach((row, j) => row.forEach((cell, i) => {
    if (differ(cell, row[i + 1])) edges.push([i + 1, j, 0, 1]);
    if (differ(cell, cells[j + 1]?.[i])) edges.push([i, j + 1, 1, 0]);
  }));
  return edges;
}
