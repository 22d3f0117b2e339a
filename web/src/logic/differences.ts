// Line-by-line comparison of two texts, side by side, with some context.

export interface Row { left: string | null; right: string | null; gap?: boolean }

const around = 2;
const mostCells = 4e6; // maximum size of the table below; the differing middle of longer texts is compared as a whole

/** Matching lines: the longest common subsequence between common beginning and end. */
function pairs(a: string[], b: string[]): Row[] {
  let head = 0;
  while (head < a.length && head < b.length && a[head] === b[head]) ++head;
  let tail = 0;
  while (tail < a.length - head && tail < b.length - head && a[a.length - 1 - tail] === b[b.length - 1 - tail]) ++tail;
  const same = (lines: string[]): Row[] => lines.map((l) => ({ left: l, right: l }));
  const l = a.slice(head, a.length - tail), r = b.slice(head, b.length - tail);
  return [...same(a.slice(0, head)), ...middle(l, r), ...same(a.slice(a.length - tail))];
}

function middle(a: string[], b: string[]): Row[] {
  const n = a.length, m = b.length, rows: Row[] = [];
  const long = n * m > mostCells;
  const width = m + 1;
  const common = new Uint16Array(long ? 0 : (n + 1) * width);
  if (!long) {
    for (let i = n - 1; i >= 0; --i) for (let j = m - 1; j >= 0; --j) {
      common[i * width + j] = a[i] === b[j] ? common[(i + 1) * width + j + 1]! + 1 : Math.max(common[(i + 1) * width + j]!, common[i * width + j + 1]!);
    }
  }
  const gone: string[] = [], come: string[] = [];
  const flush = (): void => {
    for (let k = 0; k < Math.max(gone.length, come.length); ++k) rows.push({ left: gone[k] ?? null, right: come[k] ?? null });
    gone.length = 0; come.length = 0;
  };
  let i = 0, j = 0;
  while (i < n || j < m) {
    if (!long && i < n && j < m && a[i] === b[j]) { flush(); rows.push({ left: a[i++]!, right: b[j++]! }); }
    else if (j >= m || (i < n && (long || common[(i + 1) * width + j]! >= common[i * width + j + 1]!))) gone.push(a[i++]!);
    else come.push(b[j++]!);
  }
  flush();
  return rows;
}

export function differences(left: string, right: string): Row[] {
  const all = pairs(left.split('\n'), right.split('\n'));
  const near = all.map((_r, i) => all.slice(Math.max(0, i - around), i + around + 1).some((r) => r.left !== r.right));
  const out: Row[] = [];
  all.forEach((row, i) => {
    if (near[i]) out.push(row);
    else if (out.length && !out[out.length - 1]!.gap) out.push({ left: null, right: null, gap: true });
  });
  if (out.at(-1)?.gap) out.pop();
  return out;
}
