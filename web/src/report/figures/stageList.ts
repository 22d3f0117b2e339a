// Common functions of the figures of operation stages.
import { viridis } from '../../components/colourScale';
import { Highlight } from '../../components/highlight';
import { fixed, type Units } from '../../components/units';
import type { StagesData, StagesReport } from '../data';

export const readStages = (data: unknown): StagesData => (data as StagesReport).stages;

/** Common to all panels of one report. */
const highlights = new WeakMap<StagesData, Highlight>();

export function stageHighlight(stages: StagesData): Highlight {
  const known = highlights.get(stages);
  if (known) return known;
  const made = new Highlight();
  highlights.set(stages, made);
  return made;
}

/** From light to dark. */
export const stageColour = ({ list }: StagesData, i: number): string => viridis(0.86 * (1 - i / Math.max(list.length - 1, 1)));

export const solvedStages = ({ list }: StagesData): number[] => [...list.keys()].filter((i) => list[i]!.line !== null);

const withUnit = (value: number, digits: number, unit: string): string => `${fixed(value, digits)}${unit ? ` ${unit}` : ''}`;

const uncapitalised = (text: string): string => text.slice(0, 1).toLowerCase() + text.slice(1);

/** Summary of a stage in a line of text. */
export function describeStage({ list, curves, out }: StagesData, i: number, units: Units): string {
  const stage = list[i]!;
  if (!stage.line) return `Stage ${stage.name}: no solution. ${stage.why}`;
  const known = curves.filter((curve) => curve.key !== 'use' && curve.values[i] !== null).slice(0, 6);
  const values = known.map(({ name, values: all, digits, unit }) => `${uncapitalised(name)} ${withUnit(all[i]!, digits, unit)}`).join(', ');
  const progress = stage.out === null ? '' : `, ${uncapitalised(out)} ${units.shown(stage.out, 'm', 1)}`;
  const use = stage.use === null ? '' : `; utilisation ${fixed(stage.use, 2)}, ${stage.governing}`;
  return `Stage ${stage.name}${progress}: ${values}${use}`;
}
