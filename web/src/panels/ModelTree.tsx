// The model as a tree of objects: selecting one shows its properties; a menu duplicates, deletes or shows it in the YAML.
import { signal } from '@preact/signals';
import { copyItem } from '../logic/firstItems';
import { absentObjects, findNode, isItem, objectTitle, partsWithin, pathsAbove, summaryValue, topObjects, type FieldNode } from '../logic/modelTree';
import { leadToText } from '../state/lead';
import { byPath, diagnostics, setKeys } from '../state/model';
import { sections, shownObject } from '../state/selection';
import { concerned } from '../state/findings';
import { sayError } from '../state/notices';
import { object, selectObject } from '../state/workspace';
import { openMenu, openMenuBelow, type MenuItem } from './Menu';
import { addObject } from './addObject';
import '../styles/tree.css';

/** Expanded objects; by default those of the first level with few parts. */
const unfolded = signal<ReadonlySet<string>>(new Set(['environment', 'supports']));

function setUnfolded(path: string, open: boolean): void {
  const next = new Set(unfolded.value);
  if (open) next.add(path); else next.delete(path);
  unfolded.value = next;
}

const isOpen = (path: string): boolean => unfolded.value.has(path) || pathsAbove(shownObject.value).includes(path);

async function write(path: string, value: unknown): Promise<void> {
  try { await setKeys([{ path, value }]); } catch (error) { sayError(error); }
}

function menuItems(node: FieldNode): MenuItem[] {
  const list = isItem(node) ? node.path.replace(/\[\d+\]$/, '') : '';
  return [
    ...(list ? [{ name: 'Duplicate', act: () => void write(`${list}[${byPath.value.get(list)?.count ?? 0}]`, copyItem(node)) }] : []),
    { name: 'Delete', disabled: !node.given, act: () => { if (object.value.startsWith(node.path)) selectObject(''); void write(node.path, null); } },
    { name: 'Show in YAML', disabled: !node.given, act: () => leadToText(node.path) },
    { name: 'Copy path', act: () => void navigator.clipboard.writeText(node.path).catch(sayError) },
  ];
}

/** The most severe diagnostic of an object and its contents. */
function findMark(path: string): 'bad' | 'warn' | '' {
  const within = (key: string): boolean => key === path || key.startsWith(`${path}.`) || key.startsWith(`${path}[`);
  const said = diagnostics.value.filter((d) => within(d.key));
  if (said.some((d) => d.severity === 'error')) return 'bad';
  const marks = [...concerned.value].filter(([key]) => within(key)).map(([, severity]) => severity);
  if (marks.includes('serious')) return 'bad';
  return said.length || marks.includes('caution') ? 'warn' : '';
}

const marks = { bad: 'has an error or a serious finding', warn: 'has a finding', '': '' };

function Branch({ node, level }: { node: FieldNode; level: number }) {
  const within = partsWithin(node), open = within.length > 0 && isOpen(node.path), chosen = shownObject.value === node.path;
  const value = summaryValue(node, byPath.value), mark = findMark(node.path);
  return (
    <li role="none">
      <div
        role="treeitem"
        aria-level={level}
        aria-selected={chosen}
        aria-expanded={within.length ? open : undefined}
        tabIndex={chosen ? 0 : -1}
        class="branch"
        data-object={node.path}
        style={{ '--level': level - 1 }}
        title={node.field?.text}
        onClick={(e) => {
          if ((e.target as Element).classList.contains('twig')) setUnfolded(node.path, !open);
          else { selectObject(node.path); setUnfolded(node.path, true); }
        }}
        onContextMenu={(e) => { e.preventDefault(); openMenu(menuItems(node), e.clientX, e.clientY); }}
      >
        <span class="twig" aria-hidden="true">{within.length ? (open ? '▾' : '▸') : ''}</span>
        <span class="objectname">{objectTitle(node)}</span>
        {mark ? <i class={`mark ${mark}`} title={marks[mark]}><span class="hidden">{marks[mark]}</span></i> : null}
        <span class="telling">{value}</span>
      </div>
      {open ? <ul role="group">{within.map((child) => <Branch key={child.path} node={child} level={level + 1} />)}</ul> : null}
    </li>
  );
}

/** Keys of a tree: arrows move, right and left expand and collapse, Enter selects, the menu key opens the menu. */
function walk(e: KeyboardEvent): void {
  const item = (e.target as Element).closest<HTMLElement>('[role=treeitem]');
  if (!item) return;
  const path = item.dataset.object!, all = [...item.closest('[role=tree]')!.querySelectorAll<HTMLElement>('[role=treeitem]')];
  const go = (to: HTMLElement | undefined): void => { to?.focus(); to?.click(); };
  const index = all.indexOf(item), open = item.getAttribute('aria-expanded') === 'true';
  const node = findNode(sections.value, path);
  switch (e.key) {
    case 'ArrowDown': go(all[index + 1]); break;
    case 'ArrowUp': go(all[index - 1]); break;
    case 'Home': go(all[0]); break;
    case 'End': go(all.at(-1)); break;
    case 'ArrowRight': if (open) go(all[index + 1]); else setUnfolded(path, true); break;
    case 'ArrowLeft': if (open && unfolded.value.has(path)) setUnfolded(path, false); else go(all.find((el) => el.dataset.object === pathsAbove(path).at(-1))); break;
    case 'Enter': document.querySelector<HTMLElement>('.properties :is(input, select, button)')?.focus(); break;
    case 'Delete': if (node?.given) void write(path, null); break;
    case 'ContextMenu': case 'F10': if (node && (e.key !== 'F10' || e.shiftKey)) openMenuBelow(menuItems(node), item); break;
    default: return;
  }
  e.preventDefault();
}

export function ModelTree() {
  const absent = absentObjects(sections.value).filter((n) => n.path !== 'seek' && n.path !== 'sensitivities');
  return (
    <div class="modeltree">
      <ul role="tree" aria-label="Objects of the model" onKeyDown={walk}>
        {topObjects(sections.value).map((node) => <Branch key={node.path} node={node} level={1} />)}
      </ul>
      {absent.length ? (
        <button
          type="button"
          class="add"
          aria-haspopup="menu"
          onClick={(e) => openMenuBelow(absent.map((node) => ({ name: objectTitle(node), title: node.field?.text, act: () => void addObject(node) })), e.currentTarget)}
        >
          + add to the model
        </button>
      ) : null}
    </div>
  );
}
