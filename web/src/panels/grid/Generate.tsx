// Boxes of a structure from radius, number and spacing, with the numbers that come of it before they are written.
import { useMemo, useState } from 'preact/hooks';
import { arcFaults, rampEnd, rowChanges, wishedBoxes, wishFrom, writtenOut, type ArcPlace, type ArcWish } from '../../logic/gridGenerate';
import { display } from '../../logic/show';
import { twin } from '../../logic/units';
import { writeChanges } from '../../state/gridEdit';
import { byPath } from '../../state/model';

const fields: [key: keyof ArcWish, name: string, title: string][] = [
  ['radius', 'radius', 'Of the arc that the boxes stand on'],
  ['count', 'boxes', 'Number of boxes'],
  ['spacing', 'spacing', 'From box to box along the arc'],
  ['length', 'box length', 'Length of each box along the pipe; needed with more than one roller row'],
  ['x', 'first x', 'First box, astern of the stern shoe; empty: one spacing behind the ramp'],
  ['z', 'first z', 'First box, above the stern shoe; empty: one spacing behind the ramp'],
  ['incline', 'first incline', 'Of the arc at the first box, positive downwards astern; empty: as the ramp ends'],
];

function Preview({ boxes }: { boxes: ArcPlace[] }) {
  const [unit, factor] = display('m');
  const text = (metres: number): string => (metres * factor).toFixed(3);
  const degrees = (rad: number): string => ((rad * 180) / Math.PI).toFixed(2);
  return (
    <div class="preview">
      <table aria-label="Boxes to be written">
        <thead><tr><th>box</th><th>x [{unit}]</th><th>z [{unit}]</th><th>incline [deg]</th></tr></thead>
        <tbody>
          {boxes.map((box, i) => <tr key={i}><th scope="row">{i + 1}</th><td>{text(box.x)}</td><td>{text(box.z)}</td><td>{degrees(box.incline)}</td></tr>)}
        </tbody>
      </table>
    </div>
  );
}

export function Generate({ structure, close }: { structure: string; close: () => void }) {
  const [wish, setWish] = useState<ArcWish>(() => wishFrom(byPath.value, structure));
  const end = structure === 'supports.stinger' ? rampEnd(byPath.value) : null;
  const faults = useMemo(() => new Map(arcFaults(wish, end).map((f) => [f.key, f.text])), [wish, end]);
  const boxes = faults.size === 0 ? wishedBoxes(wish, end) : [];
  const write = async (asRow: boolean): Promise<void> => {
    const changes = asRow ? rowChanges(structure, wish) : writtenOut(structure, wish, boxes, byPath.value.get(`${structure}.radius`)?.given ?? false);
    if (await writeChanges(changes)) close();
  };
  const name = structure.replace('supports.', '');
  return (
    <form class="gridstrip generate" aria-label={`Generate ${name}`} onSubmit={(e) => { e.preventDefault(); if (boxes.length) void write(true); }} onKeyDown={(e) => { if (e.key === 'Escape') close(); }}>
      <div class="wishes">
        {fields.map(([key, label, title]) => (
          <label key={key} title={title}>
            {label}
            <input
              value={wish[key]}
              placeholder={key === 'x' || key === 'z' || key === 'incline' ? 'from the ramp' : ''}
              autocomplete="off"
              autofocus={key === 'radius'}
              aria-invalid={faults.has(key)}
              onInput={(e) => setWish({ ...wish, [key]: e.currentTarget.value })}
            />
            <small>{faults.get(key) ?? twin(wish[key])}</small>
          </label>
        ))}
        <p class="brief">The boxes of the {name} are replaced; undo brings them back. A row keeps radius and spacing as keys that can be varied.</p>
        <footer>
          <button type="submit" class="main" disabled={boxes.length === 0}>Write as a row</button>
          <button type="button" disabled={boxes.length === 0} onClick={() => void write(false)}>Write as a list</button>
          <button type="button" onClick={close}>Cancel</button>
        </footer>
      </div>
      <Preview boxes={boxes} />
    </form>
  );
}
