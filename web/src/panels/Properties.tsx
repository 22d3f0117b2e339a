// Properties of the selected object, from the fields of the program: collapsible groups, lists with add and remove.
import { signal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { copyItem, firstItem } from '../logic/firstItems';
import { parts, tree } from '../logic/formTree';
import { findNode, isObject, objectTitle, summaryValue, type FieldNode } from '../logic/modelTree';
import { askedOfWaves } from '../logic/motion';
import { byPath, diagnostics, errors, fields, setKeys } from '../state/model';
import { lead, leadToDiagnostic } from '../state/lead';
import { dialog } from '../state/look';
import { shownObject } from '../state/selection';
import { sayError } from '../state/notices';
import { FieldRow } from './FieldRow';
import { hasGrid, openTable } from './grid/ListGrid';
import { Motion } from './Motion';

const folded = signal<Record<string, boolean>>({ analysis: true, rollers: true });
const more = signal<Record<string, boolean>>({});
const flip = (s: typeof folded, path: string): void => { s.value = { ...s.value, [path]: !s.value[path] }; };

const simple = (n: FieldNode): boolean => n.field !== null && n.field.kind !== 'map' && n.field.kind !== 'list' && n.children.length === 0;
const plain = (n: FieldNode): boolean => simple(n) || (n.field !== null && n.children.length === 0);

async function act(path: string, value: unknown): Promise<void> {
  try { await setKeys([{ path, value }]); } catch (error) { sayError(error); }
}

/** Omitted keys that are shown because a given value requires them. */
function asked(path: string): string[] {
  if (/^environment\.waves(\[\d+\])?$/.test(path)) return askedOfWaves(byPath.value.get(`${path}.type`)?.value);
  // keys of a dynamic run are offered in models without one
  return path === 'vessel' ? ['motion'] : path === 'environment' ? ['waves'] : [];
}

/** Expands everything above a key, so that its field is visible. */
function unfold(key: string): void {
  const closed = { ...folded.value }, open = { ...more.value };
  let path = '';
  for (const part of parts(key)) {
    path += part.startsWith('[') || !path ? part : `.${part}`;
    closed[path] = false;
    open[path] = true;
  }
  // only the group of the key shows its omitted fields
  if (!byPath.value.get(key)?.given) open[`${key.replace(/\.[^.]*$/, '')}+`] = true;
  folded.value = closed;
  more.value = open;
}

function goToField(key: string): void {
  const place = document.getElementById(`f-${key}`) ?? document.querySelector<HTMLElement>(`[data-path="${CSS.escape(key)}"] .fold`);
  place?.scrollIntoView({ block: 'center' });
  place?.focus();
}

function Items({ node }: { node: FieldNode }) {
  const items = node.children.filter((c) => /\[\d+\]$/.test(c.path) && c.given);
  const last = items.at(-1);
  const first = firstItem(node.path, byPath.value.get('environment.water_depth')?.si ?? 0, String(byPath.value.get('operation.type')?.value ?? ''));
  return (
    <>
      {items.map((item) => {
        const named = item.children.find((c) => c.path.endsWith('.name'))?.field?.value;
        const open = more.value[item.path];
        if (simple(item)) return <FieldRow key={item.path} field={item.field!} name={item.label} />;
        const summary = item.children.filter((c) => c.given && simple(c) && !c.path.endsWith('.name')).slice(0, 2).map((c) => `${c.label} ${c.field!.value}`).join(', ');
        return (
          <div key={item.path} class="item">
            <div class="itemhead">
              <button type="button" class="fold" aria-expanded={!!open} title={open ? undefined : summary} onClick={() => flip(more, item.path)}>{named ? String(named) : `${node.label} ${item.label}`}<span class="brief">{open ? '' : summary}</span></button>
              <button type="button" class="tiny" title="Remove" aria-label={`Remove ${named ? String(named) : item.label}`} onClick={() => void act(item.path, null)}>✕</button>
            </div>
            {open ? <Members nodes={item.children} path={item.path} /> : null}
          </div>
        );
      })}
      <button type="button" class="add" disabled={!last && first === null} title={last ? 'Add a copy of the last item' : first === null ? 'Write the first item in the YAML' : 'Add the first item'} onClick={() => void act(`${node.path}[${items.length}]`, last ? copyItem(last) : first)}>+ add</button>
    </>
  );
}

function Members({ nodes, path }: { nodes: FieldNode[]; path: string }) {
  const wanted = asked(path).map((key) => `${path}.${key}`);
  const given = nodes.filter((n) => n.given || n.field?.required || wanted.includes(n.path));
  const rest = nodes.filter((n) => !given.includes(n));
  const open = more.value[`${path}+`];
  return (
    <>
      {given.map((n) => <Entry key={n.path} node={n} />)}
      {rest.length ? (
        <>
          <button type="button" class="more" aria-expanded={!!open} onClick={() => flip(more, `${path}+`)}>{open ? '▾ Hide' : `▸ Show ${rest.length} optional ${rest.length === 1 ? 'field' : 'fields'}`}</button>
          {open ? rest.map((n) => <Entry key={n.path} node={n} />) : null}
        </>
      ) : null}
    </>
  );
}

/** Diagnostics of a whole group or list. */
function Diagnostics({ path }: { path: string }) {
  return <>{diagnostics.value.filter((d) => d.key === path).map((d) => <p key={d.message} class={d.severity === 'error' ? 'failuretext' : 'note'} role={d.severity === 'error' ? 'alert' : undefined}>{d.message}</p>)}</>;
}

function Entry({ node }: { node: FieldNode }) {
  if (node.path === 'vessel.motion') return <div data-path={node.path}><Motion node={node} show={(n) => <Entry node={n} />} /><Diagnostics path={node.path} /></div>;
  if (node.field && plain(node) && node.field.kind !== 'map' && node.field.kind !== 'list') return <FieldRow field={node.field} />;
  const open = !folded.value[node.path] && (node.given || more.value[node.path]);
  const list = node.field?.kind === 'list';
  const wrong = diagnostics.value.some((d) => d.severity === 'error' && (d.key === node.path || d.key.startsWith(`${node.path}.`) || d.key.startsWith(`${node.path}[`)));
  return (
    <div class={`group${node.given ? '' : ' absent'}`} data-path={node.path}>
      <button type="button" class={`fold${wrong ? ' wrong' : ''}`} aria-expanded={!!open} title={node.field?.text}
        onClick={() => flip(node.given ? folded : more, node.path)}>{node.label}{list && node.given ? <span class="brief">{node.field!.count ?? ''}</span> : null}{!node.given && node.field?.left_out ? <span class="brief">{node.field.left_out}</span> : null}</button>
      <Diagnostics path={node.path} />
      {open ? <div class="inner">{list ? <Items node={node} /> : <Members nodes={node.children} path={node.path} />}</div> : null}
    </div>
  );
}

/** Properties of the selected object: given fields first, then optional ones with their defaults. */
export function Properties() {
  const wanted = lead.value, path = shownObject.value;
  useEffect(() => {
    if (!wanted?.key) return undefined;
    unfold(wanted.key);
    // after the fields have been drawn with their groups expanded
    const timer = setTimeout(() => { goToField(wanted.key); if (lead.value === wanted) lead.value = null; }, 60);
    return () => clearTimeout(timer);
  }, [wanted]);
  const sections = tree(fields.value), first = errors.value[0];
  if (sections.length === 0) {
    return (
      <div class="empty">
        <p>{first ? `The text cannot be read: line ${first.line}: ${first.message}` : 'The model is empty.'}</p>
        {first ? <button type="button" onClick={() => leadToDiagnostic(first)}>Correct it in the YAML</button> : null}
      </div>
    );
  }
  const node = findNode(sections, path) ?? sections.find(isObject)!;
  const list = node.field?.kind === 'list';
  return (
    <form class="properties form" onSubmit={(e) => e.preventDefault()} aria-label={`Properties of ${objectTitle(node)}`} data-object={node.path}>
      <h2 title={node.field?.text}>{objectTitle(node)} <small>{summaryValue(node, byPath.value) || (node.given ? '' : node.field?.left_out ?? '')}</small></h2>
      <Diagnostics path={node.path} />
      {node.path === 'report' ? sections.filter((n) => simple(n) && n.path !== 'overbend').map((n) => <FieldRow key={n.path} field={n.field!} />) : null}
      {list || hasGrid(node.path) ? <button type="button" class="add" onClick={() => openTable(node.path)}>Open as a table</button> : null}
      {node.path === 'moorings' ? <button type="button" class="add" onClick={() => { dialog.value = 'spread'; }}>Mooring spread…</button> : null}
      {node.path === 'vessel.motion' ? <Motion node={node} show={(n) => <Entry node={n} />} /> : list ? <Items node={node} /> : <Members nodes={node.children} path={node.path} />}
    </form>
  );
}
