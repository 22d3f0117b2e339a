// The cable of the selected stage: tension along it and its utilisation.
import { bedHeight } from '../../logic/bed';
import { cableChart, cableCheck, cableState } from '../../logic/cable';
import { numberIn, unitName } from '../../logic/show';
import { tidy } from '../../logic/units';
import { CalculationSheet } from '../../components/CalculationSheet';
import { drawnSheet } from '../../logic/checks';
import { scene } from '../../state/live';
import { byPath } from '../../state/model';
import { chooseStage, operation, shownStage, stageLay } from '../../state/operation';
import { DataDiagram } from '../DataDiagram';
import { NotSolved } from './NotSolved';

function Rows({ rows }: { rows: [string, string, string][] }) {
  return <dl>{rows.map(([name, value, unit]) => <div key={name} class="kv"><dt>{name}</dt><dd>{value} <small>{unit}</small></dd></div>)}</dl>;
}

export function CableTab() {
  const lay = stageLay.value, stage = shownStage.value, around = scene.value;
  if (!operation.value) return <NotSolved />;
  if (!lay || !stage) return <p class="empty">No stage is shown. <button type="button" onClick={() => void chooseStage(operation.value!.stages.findIndex((s) => s.values))}>Show the first</button></p>;
  const cable = cableState(lay, stage.parts, (x, y) => (around ? bedHeight(around.seabed, x, y) : -Infinity));
  if (!cable) return <p class="empty">There is no cable in the line at this stage.</p>;
  const breaking = byPath.value.get('operation.cable.breaking_load')?.si ?? null, check = cableCheck(lay.checks);
  const kN = (value: number): [string, string] => [numberIn(value, 'N'), unitName('N')], m = (value: number): [string, string] => [numberIn(value, 'm'), unitName('m')];
  const ends: [string, string] = stage.parts!.cable_at_far_end ? ['at the head', 'at the far end'] : ['at the winch', 'at the head'];
  const rows: [string, string, string][] = [
    ['length out', ...m(cable.length)], [`tension ${ends[0]}`, ...kN(cable.near)], [`tension ${ends[1]}`, ...kN(cable.far)], ['maximum tension', ...kN(cable.largest)], ['on the seabed', ...m(cable.onBed)],
    ...(breaking ? [['breaking load', ...kN(breaking)], ['of breaking load', tidy((100 * cable.largest) / breaking, 3), '%']] as [string, string, string][] : []),
    ...(check?.utilisation !== undefined ? [['utilisation, with the safety factor', tidy(check.utilisation, 3), '']] as [string, string, string][] : []),
  ];
  return (
    <div class="cabletab">
      <div class="cablevalues">
        <Rows rows={rows} />
        {breaking ? null : <p class="note">Without operation.cable.breaking_load the cable is not checked.</p>}
        {check?.sheet.length ? <details><summary>Calculation sheet</summary><CalculationSheet lines={drawnSheet(check.sheet)} /></details> : null}
      </div>
      <DataDiagram data={cableChart(cable, breaking, check)} />
    </div>
  );
}
