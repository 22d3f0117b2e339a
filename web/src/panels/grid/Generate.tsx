// Boxes of a structure from radius, number and spacing, with a preview before they are written.
import { useMemo, useState } from 'preact/hooks';
import { findArcErrors, rampEnd, rowChanges, generatedBoxes, readArcRequest, writtenOut, type ArcPlace, type ArcRequest } from '../../logic/gridGenerate';
import { display } from '../../logic/show';
import { twin } from '../../logic/units';
import { writeChanges } from '../../state/gridEdit';
import { byPath } from '../../state/model';

const fields: [key: keyof ArcRequest, name: string, title: string][] = [
  ['radius', 'radius', 'Radius of the arc of the boxes'],
  ['count', 'boxes', 'Number of boxes'],
  ['spacing', 'spacing', 'Distance between boxes along the arc'],
  ['length', 'box length', 'Length of each box along the pipe; needed with more than one roller row'],
  ['x', 'first x', 'First box, astern of the stern shoe; empty: one spacing behind the ramp'],
  ['z', 'first z', 'First box, above the stern shoe; empty: one spacing behind the ramp'],
  ['incline', 'first incline', 'Incline of the arc at the first box, positive downwards astern; empty: that of the end of the ramp'],
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
  const [request, setRequest] = useState<ArcRequest>(() => readArcRequest(byPath.value, structure));
  const end = structure === 'supports.stinger' ? rampEnd(byPath.value) : null;
  const errors = useMemo(() => new Map(findArcErrors(request, end).map((f) => [f.key, f.text])), [request, end]);
  const boxes = errors.size === 0 ? generatedBoxes(request, end) : [];
  const write = async (asRow: boolean): Promise<void> => {
    const changes = asRow ? rowChanges(structure, request) : writtenOut(structure, request, boxes, byPath.value.get(`${structure}.radius`)?.given ?? false);
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
              value={request[key]}
              placeholder={key === 'x' || key === 'z' || key === 'incline' ? 'from the ramp' : ''}
              autocomplete="off"
              autofocus={key === 'radius'}
              aria-invalid={errors.has(key)}
              onInput={(e) => setRequest({ ...request, [key]: e.currentTarget.value })}
            />
            <small>{errors.get(key) ?? twin(request[key])}</small>
          </label>
        ))}
        <p class="brief">The boxes of the {name} are replaced; undo restores them. In a row, radius and spacing remain keys that can be varied.</p>
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
