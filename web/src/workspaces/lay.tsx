// Lay: the statics of the open model, live.
import { AlongPipe } from '../panels/AlongPipe';
import { Checks } from '../panels/Checks';
import { BoxesGrid } from '../panels/grid/BoxesGrid';
import { hasTable, ObjectTable } from '../panels/grid/ListGrid';
import { Diagrams } from '../panels/Diagrams';
import { LaidPipe, Route } from '../panels/Ground';
import { LineTable, MooringResults } from '../panels/Moorings';
import { PinnedBar } from '../panels/PinnedBar';
import { Sensitivities } from '../panels/Sensitivities';
import { StingerSections } from '../panels/StingerSections';
import { Tables } from '../panels/Tables';
import { Yaml } from '../panels/Yaml';
import { byPath } from '../state/model';
import { calmLay } from '../state/shown';
import type { DockTab, WorkspaceParts } from './workspace';

const laid = (): boolean => calmLay.value === null || calmLay.value.pipe.s.length > 0;

/** Results on the seabed, and the route. */
function Ground() {
  const { seabed, route } = calmLay.value ?? {};
  return <div class="padded">{seabed ? <LaidPipe bed={seabed} /> : null}{route ? <Route route={route} /> : null}</div>;
}

export const diagrams: DockTab = { id: 'diagrams', title: 'Diagrams', View: Diagrams };
export const boxes: DockTab = {
  id: 'boxes',
  title: 'Boxes',
  shown: () => byPath.value.get('supports')?.given ?? false,
  View: BoxesGrid,
};
/** The selected list, or that of the selected object. */
export const table: DockTab = { id: 'objecttable', title: 'Table', shown: hasTable, View: ObjectTable };
export const checks: DockTab = { id: 'checks', title: 'Checks', shown: () => (calmLay.value?.checks.length ?? 0) > 0, View: Checks };
export const alongPipe: DockTab = { id: 'along', title: 'Along the pipe', shown: laid, View: () => <AlongPipe /> };
export const moorings: DockTab = { id: 'moorings', title: 'Moorings', shown: () => calmLay.value?.moorings != null, View: () => <div class="padded"><MooringResults /></div> };
export const lines: DockTab = { id: 'lines', title: 'Lines', shown: () => (calmLay.value?.lines.length ?? 0) > 0, View: () => <div class="padded"><LineTable lines={calmLay.value?.lines ?? []} /></div> };
export const ground: DockTab = { id: 'ground', title: 'On the seabed', shown: () => !!(calmLay.value?.seabed ?? calmLay.value?.route), View: Ground };
export const stinger: DockTab = { id: 'stinger', title: 'Stinger', shown: () => (calmLay.value?.stinger?.length ?? 0) > 0, View: () => <div class="padded"><StingerSections /></div> };
export const tables: DockTab = { id: 'tables', title: 'Tables', View: () => <div class="padded"><Tables lay={calmLay.value} /></div> };

export const lay: WorkspaceParts = {
  id: 'lay',
  title: 'Lay',
  Bar: PinnedBar,
  tabs: [
    diagrams, boxes, table, checks, alongPipe, stinger, ground, moorings, lines,
    { id: 'sensitivities', title: 'Sensitivities', shown: laid, View: () => <div class="padded"><Sensitivities /></div> },
    tables,
    { id: 'yaml', title: 'YAML', View: Yaml },
  ],
};
