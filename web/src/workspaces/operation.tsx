// Operations on the line: settings and stages above the picture, their results below.
import { CableTab } from '../panels/operation/CableTab';
import { LiftTab } from '../panels/operation/LiftTab';
import { OperationStrip } from '../panels/operation/OperationStrip';
import { StageCharts } from '../panels/operation/StageCharts';
import { StageTable } from '../panels/operation/StageTable';
import { Checks } from '../panels/Checks';
import { Diagrams } from '../panels/Diagrams';
import { StageBar } from '../panels/StageBar';
import { byPath } from '../state/model';
import { typeName } from '../state/operation';
import type { WorkspaceParts } from './workspace';

const hasCable = (): boolean => byPath.value.get('operation.cable')?.given === true;
const hasLines = (): boolean => typeName.value === 'lift' || byPath.value.get('lines')?.given === true;

export const operation: WorkspaceParts = {
  id: 'operation',
  title: 'Operation',
  Strip: OperationStrip,
  Bar: StageBar,
  tabs: [
    { id: 'stages', title: 'Stages', View: StageTable },
    { id: 'over', title: 'Diagrams over stages', View: StageCharts },
    { id: 'diagrams', title: 'Diagrams of the stage', View: Diagrams },
    { id: 'cable', title: 'Cable', shown: hasCable, View: CableTab },
    { id: 'lines', title: 'Lines and davits', shown: hasLines, View: LiftTab },
    { id: 'checks', title: 'Checks', View: Checks },
  ],
};
