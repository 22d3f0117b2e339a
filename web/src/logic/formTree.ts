// The list of fields as a tree for the form.

export interface Leaf { path: string; kind: string; given: boolean; required?: boolean; count?: number }
export interface Node<F extends Leaf> { path: string; label: string; field: F | null; children: Node<F>[]; given: boolean }

export function parts(path: string): string[] {
  return path.replaceAll('[', '.[').split('.').filter(Boolean);
}

const labels: Record<string, string> = { hs: 'Hs', tp: 'Tp', x: 'x', z: 'z', youngs_modulus: "Young's modulus", poissons_ratio: "Poisson's ratio" };

/** "outside_diameter" becomes "outside diameter"; list items are counted from 1. */
export function label(part: string): string {
  const item = /^\[(\d+)\]$/.exec(part);
  if (item) return String(Number(item[1]) + 1);
  return labels[part] ?? part.replaceAll('_', ' ');
}

export function tree<F extends Leaf>(fields: F[]): Node<F>[] {
  const root: Node<F> = { path: '', label: '', field: null, children: [], given: true };
  const known = new Map<string, Node<F>>([['', root]]);
  const nodeAt = (path: string): Node<F> => {
    const have = known.get(path);
    if (have) return have;
    const list = parts(path);
    const last = list[list.length - 1]!;
    const up = path.slice(0, path.length - last.length).replace(/\.$/, '');
    const node: Node<F> = { path, label: label(last), field: null, children: [], given: false };
    known.set(path, node);
    nodeAt(up).children.push(node);
    return node;
  };
  for (const f of fields) {
    const node = nodeAt(f.path);
    node.field = f;
    node.given = f.given;
  }
  const settle = (node: Node<F>): boolean => {
    let given = node.given;
    for (const c of node.children) given = settle(c) || given;
    node.given = given;
    return given;
  };
  settle(root);
  return root.children;
}
