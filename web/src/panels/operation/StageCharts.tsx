// Diagrams of all stages over the length paid out; a click selects the stage.
import { useMemo } from 'preact/hooks';
import { stageCharts } from '../../logic/stageCharts';
import { chooseStage, chosenStage, operation, outdated } from '../../state/operation';
import { DataDiagram } from '../DataDiagram';
import { NotSolved } from './NotSolved';

export function StageCharts() {
  const solved = operation.value, all = useMemo(() => (solved ? stageCharts(solved) : null), [solved]);
  if (!all) return <NotSolved />;
  const position = chosenStage.value >= 0 ? all.x[chosenStage.value]! : null;
  return (
    <div class="diagramgrid">
      {all.charts.map((chart) => <DataDiagram key={chart.title} data={chart} position={position} old={outdated.value} onPick={(i) => void chooseStage(all.stages[i]!)} />)}
    </div>
  );
}
