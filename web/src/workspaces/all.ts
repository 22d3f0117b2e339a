// The workspaces in the order of the header.
import { lay } from './lay';
import { operation } from './operation';
import { report } from './report';
import { runs } from './runs';
import { storm } from './storm';
import { study } from './study';
import type { WorkspaceParts } from './workspace';

export const workspaces: readonly WorkspaceParts[] = [lay, operation, storm, study, runs, report];
