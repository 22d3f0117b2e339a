// Results of a study over two keys, a map for each result and combination of the other keys.
import { resultLimit, valueScale } from '../../components/colourScale';
import { HeatMap, stateLabels, type HeatCell } from '../../components/HeatMap';
import { axisPlaces } from '../../components/keyAxis';
import type { StudyData } from '../data';
import { describeGroup, groupsWith, mapLayout, valueText, type Facet } from './study_cases';

export const kMaxMultiples = 36;

type Output = StudyData['outputs'][number];

function facetCells(study: StudyData, [x, y]: [number, number], { groups }: Facet, output: Output): (HeatCell | null)[][] {
  const rows = study.inputs[y]!.words.map(() => study.inputs[x]!.words.map((): HeatCell | null => null));
  for (const group of groups) {
    const value = group.mean[output.at] ?? null;
    const state = value === null && group.state !== 'open' ? 'failed' : group.state;
    rows[group.at[y]!]![group.at[x]!] = { value, state, title: `${output.name}: ${valueText(value)}\n${describeGroup(study, group)}` };
  }
  return rows;
}

export function StudyMaps({ study }: { study: StudyData }) {
  const { x, y, facets } = mapLayout(study);
  const axis = (input: number) => ({ name: study.inputs[input]!.name, labels: axisPlaces(study.inputs[input]!).labels });
  const outputs = study.outputs.filter((output) => groupsWith(study, output.at).length > 0);
  const maps = outputs.flatMap((output) => facets.map((facet) => ({ output, facet })));
  const scales = new Map(outputs.map((output) => [output, valueScale(groupsWith(study, output.at).map((g) => g.mean[output.at]!), resultLimit(output.name))]));
  const legend = stateLabels(study.groups.map((group) => group.state));
  const rest = maps.length - kMaxMultiples;
  return (
    <>
      {maps.slice(0, kMaxMultiples).map(({ output, facet }, k) => (
        <HeatMap
          key={k} label={output.name} title={output.name} note={facet.title} x={axis(x)} y={axis(y)}
          cells={facetCells(study, [x, y], facet, output)} scale={scales.get(output)!}
        />
      ))}
      {legend ? <p class="small" style={{ gridColumn: '1 / -1' }}>{`Cells ${legend}.`}</p> : null}
      {rest > 0 ? <p class="small" style={{ gridColumn: '1 / -1' }}>{`${rest} more maps are not shown; the table of cases has their numbers.`}</p> : null}
    </>
  );
}
