// Cases of a study for its figures.
import type { StudyAxisData, StudyData, StudyGroupData } from '../data';

/** "hs" from "hs [m]". */
export const axisTitle = (axis: StudyAxisData): string => axis.name.replace(/ \[.*/, '');

export const valueText = (value: number | null | undefined): string =>
  (value === null || value === undefined ? 'no result' : String(Number(value.toPrecision(4))));

const isSolved = (group: StudyGroupData): boolean => group.state !== 'failed' && group.state !== 'open';

/** Groups with this result. */
export const groupsWith = (study: StudyData, output: number): StudyGroupData[] =>
  study.groups.filter((group) => isSolved(group) && group.mean[output] !== null);

const kVerdicts: Record<StudyGroupData['state'], string> = {
  passed: 'passed', reserved: 'passed with reservations', exceeded: 'a governing check is exceeded', 'not judged': 'solved, not judged',
  failed: 'no result', open: 'not run' };

/** Tooltip of a case. */
export function describeGroup(study: StudyData, group: StudyGroupData): string {
  return [
    `case ${group.case}`,
    ...study.inputs.map((input, i) => `${axisTitle(input)}: ${group.words[i]}`),
    ...(group.governing ? [`${group.governing}: ${valueText(group.utilisation)}`] : []),
    group.state === 'passed' && !group.governing ? 'solved' : kVerdicts[group.state],
  ].join('\n');
}

/** Groups with the same values of the keys that a map does not vary, and these values. */
export interface Facet { groups: StudyGroupData[]; title: string }

/** The two keys with the most values span a map; every combination of the others has a separate map. */
export function mapLayout(study: StudyData): { x: number; y: number; facets: Facet[] } {
  const count = (axis: number): number => study.inputs[axis]!.words.length;
  const [x, y, ...others] = [...study.axes].sort((a, b) => count(b) - count(a));
  const facets = new Map<string, Facet>();
  for (const group of study.groups) {
    const title = others.map((axis) => `${axisTitle(study.inputs[axis]!)} ${group.words[axis]}`).join(', ');
    const key = others.map((axis) => group.at[axis]).join(' ');
    if (!facets.has(key)) facets.set(key, { groups: [], title });
    facets.get(key)!.groups.push(group);
  }
  return { x: x!, y: y!, facets: [...facets.values()] };
}
