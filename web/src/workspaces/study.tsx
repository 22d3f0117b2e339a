// The workspace of studies: lay tables, studies of many cases, operability, one key at a time.
import { Curves } from '../panels/study/Curves';
import { StudyMiddle } from '../panels/study/StudyMiddle';
import { StudyStrip } from '../panels/study/StudyStrip';
import { CasesTab, GoverningTab, StudyFileTab, TableTab } from '../panels/study/tabs';
import { pictureShown } from '../state/studies';
import type { WorkspaceParts } from './workspace';

export const study: WorkspaceParts = {
  id: 'study',
  title: 'Study',
  Strip: StudyStrip,
  Middle: StudyMiddle,
  picture: pictureShown,
  tabs: [
    { id: 'curves', title: 'Curves', View: Curves },
    { id: 'table', title: 'Table', View: TableTab },
    { id: 'governing', title: 'Governing', View: GoverningTab },
    { id: 'cases', title: 'Cases', View: CasesTab },
    { id: 'file', title: 'Study file', View: StudyFileTab },
  ],
};
