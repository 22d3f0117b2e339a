// The model as a tree of objects that can be selected, each with a summary value.
import type { Field } from '../api/types';
import { parts, type Node } from './formTree';
import { waveGroups } from './waves';

export type FieldNode = Node<Field>;

/** A group or list, with its items; a single value is a field of its object. */
export const isObject = (node: FieldNode): boolean => node.children.length > 0 || node.field?.kind === 'map' || node.field?.kind === 'list';
export const isItem = (node: FieldNode): boolean => /\[\d+\]$/.test(node.path);

/** Order of description of an installation; other groups follow in the order of the schema. */
const order = ['environment', 'pipe', 'vessel', 'tensioner', 'supports', 'rollers', 'moorings', 'station_keeping', 'bodies', 'lines', 'route', 'operation', 'checks', 'fatigue', 'analysis', 'report'];
const titles: Record<string, string> = {
  environment: 'Site', 'environment.seabed': 'Seabed', 'environment.current': 'Current', 'environment.waves': 'Sea', checks: 'Criteria', report: 'Document',
  lay_table: 'Lay table', 'vessel.motion': 'Motion in waves',
};

export function objectTitle(node: FieldNode): string {
  const named = node.children.find((child) => child.path === `${node.path}.name`)?.field?.value;
  if (isItem(node) && named) return String(named);
  const title = titles[node.path] ?? node.label;
  return title.charAt(0).toUpperCase() + title.slice(1);
}

const place = (node: FieldNode): number => { const index = order.indexOf(node.path); return index < 0 ? order.length : index; };

/** Objects of the first level that the model has, in the order of an installation. */
export const topObjects = (sections: FieldNode[]): FieldNode[] => sections.filter((n) => isObject(n) && (n.given || n.path === 'report')).sort((a, b) => place(a) - place(b));
/** Objects that the model could have in addition. */
export const absentObjects = (sections: FieldNode[]): FieldNode[] => sections.filter((n) => isObject(n) && !n.given && n.path !== 'report').sort((a, b) => place(a) - place(b));
/** Objects within an object; items that are single values are not objects. */
export const partsWithin = (node: FieldNode): FieldNode[] => node.children.filter((child) => child.given && isObject(child));

export function findNode(sections: FieldNode[], path: string): FieldNode | null {
  let nodes = sections, found: FieldNode | null = null;
  while (nodes.length > 0) {
    const next = nodes.find((n) => n.path === path || path.startsWith(`${n.path}.`) || path.startsWith(`${n.path}[`));
    if (!next) return found?.path === path ? found : null;
    found = next;
    if (next.path === path) return next;
    nodes = next.children;
  }
  return null;
}

/** The object that shows a key: the key itself if it is one, otherwise its nearest parent in the tree. */
export function objectOfKey(sections: FieldNode[], key: string): string {
  for (let path = key; path; path = path.replace(/(?:\.[^.[]*|\[\d+\]|^[^.[]*)$/, '')) {
    const node = findNode(sections, path);
    if (node && isObject(node)) return node.path;
  }
  return sections.some((n) => n.path === key) ? 'report' : '';
}

/** Default selection: the tensioner of a lay, otherwise the first object after the site. */
export function firstObject(sections: FieldNode[]): string {
  const top = topObjects(sections);
  return (top.find((n) => n.path === 'tensioner') ?? top[1] ?? top[0])?.path ?? '';
}

/** Paths above an object, from the first level downwards. */
export function pathsAbove(path: string): string[] {
  const out: string[] = [];
  let so = '';
  for (const part of parts(path)) { so += part.startsWith('[') || !so ? part : `.${part}`; out.push(so); }
  return out.slice(0, -1);
}

type Values = ReadonlyMap<string, Field>;
const counted = (n: number, singular: string): string => `${n} ${singular}${n === 1 ? '' : 's'}`;

function boxes(values: Values, structure: string): number {
  const list = values.get(`supports.${structure}.boxes`)?.count;
  return list ?? Number(values.get(`supports.${structure}.boxes.count`)?.value ?? 0);
}

/** Inches if the outside diameter is a size of line pipe. */
function pipeSize(values: Values): string {
  const outside = values.get('pipe.steel.outside_diameter'), wall = values.get('pipe.steel.wall_thickness');
  if (!outside?.given) return '';
  const inches = (outside.si ?? 0) / 0.0254, whole = Math.round(inches);
  const size = outside.si && Math.abs(inches - whole) < 0.01 ? `${whole} in` : String(outside.value);
  return wall?.given ? `${size} × ${String(wall.value)}` : size;
}

const waveNames: Record<string, string> = { hs: 'Hs ', tp: 'Tp ', tz: 'Tz ', height: '', period: '' };

/** "Hs 2 m, Tp 8 s" of a group of waves. */
function heightAndPeriod(values: Values, group: string): string {
  return ['hs', 'height', 'tp', 'tz', 'period'].map((key) => [key, text(values, `${group}.${key}`)] as const).filter(([, value]) => value)
    .map(([key, value]) => `${waveNames[key] ?? ''}${value}`).join(', ');
}

const summaries: Record<string, (values: Values) => string> = {
  environment: (v) => text(v, 'environment.water_depth'),
  'environment.seabed': (v) => text(v, 'environment.seabed.stiffness'),
  'environment.current': (v) => counted(v.get('environment.current')?.count ?? 0, 'row'),
  'environment.waves': (v) => waveGroups(v).map((group) => heightAndPeriod(v, group)).filter(Boolean).join('; '),
  pipe: pipeSize,
  vessel: (v) => text(v, 'vessel.name'),
  tensioner: (v) => [text(v, 'tensioner.tension'), text(v, 'tensioner.mode') || (v.get('tensioner.range')?.given ? 'controlled' : '')].filter(Boolean).join(', '),
  supports: (v) => counted(boxes(v, 'ramp') + boxes(v, 'stinger'), 'box').replace('boxs', 'boxes'),
  'supports.ramp': (v) => String(boxes(v, 'ramp') || ''),
  'supports.stinger': (v) => String(boxes(v, 'stinger') || ''),
  moorings: (v) => { const n = v.get('moorings.lines')?.count; return n ? counted(n, 'line') : ''; },
  operation: (v) => text(v, 'operation.type').replaceAll('_', ' '),
  'analysis.dynamic': (v) => text(v, 'analysis.dynamic.duration'),
  report: (v) => [text(v, 'report.document'), text(v, 'report.revision') && `rev ${text(v, 'report.revision')}`].filter(Boolean).join(' '),
};

function text(values: Values, path: string): string {
  const field = values.get(path);
  return field?.given && field.value !== null && field.value !== undefined ? String(field.value) : '';
}

/** Summary value of an object, as written in the model. */
export function summaryValue(node: FieldNode, values: Values): string {
  const known = summaries[node.path];
  if (known) return known(values);
  if (node.field?.kind === 'list') return node.field.count ? String(node.field.count) : '';
  const first = node.children.find((child) => child.given && !isObject(child) && !child.path.endsWith('.name'));
  return first?.field ? String(first.field.value ?? '').slice(0, 24) : '';
}
