// Values of the selected object: a roller, a box, a position on the pipe, or a line.
import type { Support } from '../../api/types';
import { rollerRows } from '../../logic/elevation';
import { nearest } from '../../logic/series';
import { numberIn, quantities, unitName } from '../../logic/show';
import { tidy } from '../../logic/units';
import { cursor, picked } from '../../state/look';
import { chosenLine } from '../../state/moorings';
import { drawnMoment } from '../../state/picture';
import { chosenBox } from '../../state/chosenBox';
import { calmLay } from '../../state/shown';
import { LineValues } from '../Moorings';

function Value({ name, value, unit }: { name: string; value: string; unit: string }) {
  return <div class="kv"><dt>{name}</dt><dd>{value} <small>{unit}</small></dd></div>;
}

const inUnits = (name: string, value: number, si: string, digits?: number) => <Value key={name} name={name} value={numberIn(value, si, digits)} unit={unitName(si)} />;

const shortName = (name: string): string =>
  name.toLowerCase().replace('effective ', '').replace('bending moment', 'moment').replace('von mises stress', 'von Mises').replace('utilisation of ', '');

function RollerValues() {
  const p = picked.value;
  if (p?.kind !== 'roller') return null;
  const r = p.roller, clear = r.separation > 0;
  return (
    <dl class="values" data-clear>
      <div class="kv"><dt>{r.support.name}, row {r.row + 1}</dt><dd>{r.position}</dd></div>
      {inUnits('reaction', r.reaction, 'N')}
      {clear && r.reaction > 0 ? null : inUnits(clear ? 'clear by' : 'indentation', Math.abs(r.separation), 'mm', 3)}
    </dl>
  );
}

/** Reaction of every row, or its gap without contact. */
function BoxValues({ box }: { box: Support }) {
  const moment = drawnMoment.value, reaction = moment?.reactions.get(box.name);
  return (
    <dl class="values" data-clear>
      <div class="kv"><dt>{box.name}</dt><dd>{box.contact || moment ? '' : 'clear'}</dd></div>
      {reaction === undefined ? null : inUnits('present reaction', reaction, 'N')}
      {inUnits(moment ? 'static reaction' : 'reaction', box.reaction, 'N')}
      {moment ? null : rollerRows(box).map((row, i) => {
        const sum = row.reduce((all, r) => all + r.reaction, 0), gap = Math.min(...row.map((r) => r.separation));
        const sides = row.filter((r) => r.position !== 'bottom' && r.reaction > 0).map((r) => r.position);
        const name = `row ${i + 1}${sides.length ? `, ${sides.join(', ')}` : ''}`;
        return sum > 0 ? inUnits(name, sum, 'N') : inUnits(`${name}, clear by`, gap, 'mm', 3);
      })}
    </dl>
  );
}

function PipeValues({ index }: { index: number }) {
  const { pipe } = calmLay.value!;
  return (
    <dl class="values" data-clear>
      {inUnits('s from tensioner', pipe.s[index]!, 'm', 5)}
      {inUnits('height', pipe.z[index]!, 'm')}
      {quantities.filter((q) => pipe[q.key]?.length).map((q) => (
        <Value key={q.key} name={shortName(q.name)} value={tidy((pipe[q.key] as number[])[index]! * q.factor, 4)} unit={q.unit === '–' ? '' : q.unit} />
      ))}
    </dl>
  );
}

export function Values() {
  const lay = calmLay.value, p = picked.value, place = cursor.value;
  const line = p?.kind === 'line' ? p.name : chosenLine.value;
  if (line) return <LineValues name={line} />;
  if (!lay || lay.pipe.s.length === 0) return null;
  if (place !== null) return <PipeValues index={nearest(lay.pipe.s, place)} />;
  if (p?.kind === 'roller') return <RollerValues />;
  const box = lay.supports.find((s) => s.name === chosenBox.value);
  if (box) return <BoxValues box={box} />;
  return p?.kind === 'station' ? <PipeValues index={p.index} /> : null;
}
