// Popovers of the storm strip: the keys of the model, and a command for what is missing.
import { useState } from 'preact/hooks';
import type { Change, Field } from '../../api/types';
import { label, parts, tree, type Node } from '../../logic/formTree';
import { askedOfWaves, motionKind } from '../../logic/motion';
import { firstRange, hullDiffers, libraryHull, seedsTyped, seedsValue } from '../../logic/storm';
import { waveGroups } from '../../logic/waves';
import { byPath, fields, setKeys } from '../../state/model';
import { sayError } from '../../state/notices';
import { scaleHull, seeds } from '../../state/storm';
import { FieldRow } from '../FieldRow';
import { Motion } from '../Motion';
import { useUpdate } from '../useUpdate';

const write = (changes: Change[]): void => { void setKeys(changes).catch(sayError); };

const isValue = (field: Field): boolean => field.kind !== 'map' && field.kind !== 'list';
const rowNames: Record<string, string> = { 'tensioner.range[0]': 'range from', 'tensioner.range[1]': 'range to' };

/** Rows of given and possible keys. */
function Keys({ paths }: { paths: string[] }) {
  const known = paths.map((path) => byPath.value.get(path)).filter((field): field is Field => field !== undefined && isValue(field));
  return <>{known.map((field) => <FieldRow key={field.path} field={field} name={rowNames[field.path]} />)}</>;
}

/** Keys of one group of waves. */
function GroupFields({ group }: { group: string }) {
  const type = byPath.value.get(`${group}.type`)?.value;
  const paths = (keys: string[]): string[] => keys.map((key) => `${group}.${key}`);
  const irregular = !['none', 'airy', 'stokes5', 'elevation'].includes(String(type));
  const more = irregular ? [...(type === 'jonswap' ? ['gamma'] : []), 'spreading', 'components'] : type === 'elevation' ? [] : ['phase'];
  return (
    <>
      <Keys paths={paths(['type', ...askedOfWaves(type)])} />
      {type === 'none' || more.length === 0 ? null : <details><summary>more</summary><Keys paths={paths(more)} /></details>}
    </>
  );
}

export function SeaFields() {
  const groups = waveGroups(byPath.value);
  if (groups.length === 1 && !byPath.value.get(`${groups[0]}.type`)?.given) {
    const add = (): void => write([{ path: 'environment.waves', value: { type: 'jonswap', hs: '2 m', tp: '8 s' } }]);
    return <p class="brief">The model has no waves. <button type="button" onClick={add}>Add a JONSWAP sea</button></p>;
  }
  return <>{groups.map((group) => <GroupFields key={group} group={group} />)}</>;
}

export function DirectionFields() {
  return (
    <>
      <Keys paths={[...waveGroups(byPath.value).map((group) => `${group}.from`), 'vessel.heading']} />
      <p class="brief">Azimuths clockwise from north: direction the waves come from, and heading of the bow.</p>
    </>
  );
}

/** Keys of a group of the motion, as rows. */
function Members({ node }: { node: Node<Field> }) {
  if (node.field && node.children.length === 0 && isValue(node.field)) return <FieldRow field={node.field} />;
  return (
    <details open={node.given}>
      <summary>{label(parts(node.path).at(-1)!)}</summary>
      {node.children.map((child) => <Members key={child.path} node={child} />)}
    </details>
  );
}

const hullTitle = "RAOs of the box barge BGL-1, scaled by Froude's law: sway and roll with the beam, all other motions with the length";

/** Scaled RAOs of the library hull. */
function LibraryHull() {
  const [busy, setBusy] = useState(false);
  const file = String(byPath.value.get('vessel.motion.raos')?.value ?? '');
  const present = motionKind(byPath.value) === 'raos' && libraryHull(file) !== null;
  const scale = async (): Promise<void> => {
    setBusy(true);
    try { await setKeys([{ path: 'vessel.motion', value: { raos: await scaleHull() } }]); } catch (error) { sayError(error); } finally { setBusy(false); }
  };
  if (present && !hullDiffers(byPath.value)) {
    return <p class="note">Library hull: RAOs of the box barge BGL-1, scaled to this vessel by Froude's law. Results state this as an assumption.</p>;
  }
  return (
    <div class="acts">
      <button type="button" disabled={busy} title={hullTitle} onClick={() => void scale()}>
        {present ? 'Scale the library hull again' : 'Library hull, scaled to this vessel'}
      </button>
    </div>
  );
}

export function MotionFields() {
  const node = tree(fields.value).flatMap((group) => group.children).find((child) => child.path === 'vessel.motion');
  if (!node) return <p class="brief">The model has no vessel.</p>;
  return <><Motion node={node} show={(member) => <Members node={member} />} /><LibraryHull /></>;
}

export function TensionerFields() {
  const range = byPath.value.get('tensioner.range[0]')?.given, first = firstRange(byPath.value);
  return (
    <>
      <Keys paths={['tension', 'mode', 'range[0]', 'range[1]', 'delay', 'velocity', 'acceleration', 'travel'].map((key) => `tensioner.${key}`)} />
      {range || !first ? null : (
        <div class="acts"><button type="button" onClick={() => write(first)}>Control within {(first[0]!.value as string[]).join(' to ')}</button></div>
      )}
    </>
  );
}

export function DurationFields() {
  return <Keys paths={['duration', 'build_up', 'output_step', 'impacts'].map((key) => `analysis.dynamic.${key}`)} />;
}

export function SeedsFields() {
  const present = seedsTyped(seeds.value);
  const [typed, setTyped] = useState(present);
  useUpdate(() => { setTyped(present); }, [present]);
  const value = seedsValue(typed);
  const send = (): void => { if (value !== null && typed.trim() !== present) write([{ path: 'analysis.dynamic.seeds', value }]); };
  return (
    <>
      <div class={`row${value === null ? ' wrong' : ''}`}>
        <label for="storm-seeds">seeds</label>
        <input
          id="storm-seeds"
          value={typed}
          aria-invalid={value === null}
          onInput={(e) => setTyped(e.currentTarget.value)}
          onBlur={send}
          onKeyDown={(e) => { if (e.key === 'Enter') send(); }}
        />
        <span class="twin">{typeof value === 'number' ? (value === 1 ? '1 run' : `${value} runs`) : value ? `${value.length} runs` : ''}</span>
        {value === null ? <p class="failuretext">Enter a number of seeds, or a list such as "3, 7-9".</p> : null}
      </div>
      <p class="brief">Each seed is a different realisation of the same spectrum. Extreme statistics require ten or more.</p>
    </>
  );
}
