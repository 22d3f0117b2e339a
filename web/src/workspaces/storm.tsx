// The workspace of dynamics in waves: settings and Run above the picture, results over time below.
import { AnimationBar } from '../panels/AnimationBar';
import { Histories, Spectra } from '../panels/storm/Histories';
import { ChecksTab, EnvelopesTab, hasMoorings, MooringsTab } from '../panels/storm/MoreTabs';
import { StormBar } from '../panels/storm/StormBar';
import { StormStrip } from '../panels/storm/StormStrip';
import { Boxes, Extremes, Statistics } from '../panels/storm/StormTables';
import { byPath } from '../state/model';
import { runChecks, runSummary } from '../state/runs';
import type { WorkspaceParts } from './workspace';

/** A vessel without a pipe has no boxes in its summary. */
const hasBoxes = (): boolean => (runSummary.value?.dynamic ? (runSummary.value.dynamic.supports?.length ?? 0) > 0 : byPath.value.get('supports')?.given === true);
const hasPipe = (): boolean => byPath.value.get('pipe')?.given === true;

function Bar() {
  return <><AnimationBar /><StormBar /></>;
}

export const storm: WorkspaceParts = {
  id: 'storm',
  title: 'Storm',
  Strip: StormStrip,
  Bar,
  tabs: [
    { id: 'histories', title: 'Histories', View: Histories },
    { id: 'boxes', title: 'Boxes', shown: hasBoxes, View: Boxes },
    { id: 'statistics', title: 'Statistics', View: Statistics },
    { id: 'extremes', title: 'Extremes', View: Extremes },
    { id: 'spectra', title: 'Spectra', View: Spectra },
    { id: 'envelopes', title: 'Envelopes', shown: hasPipe, View: EnvelopesTab },
    { id: 'checks', title: 'Checks', shown: () => (runChecks.value?.length ?? 0) > 0, View: ChecksTab },
    { id: 'moorings', title: 'Moorings', shown: hasMoorings, View: MooringsTab },
  ],
};
