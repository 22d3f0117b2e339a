// Keys of an operation on the line: those of its type, summaries of their values, and the changes that design it.
import type { Change, Field, OperationStage } from '../api/types';
import type { FirstOperation } from './firstOperation';
import { tidy } from './units';

export type Fields = ReadonlyMap<string, Pick<Field, 'value' | 'si' | 'given' | 'kind' | 'count' | 'default'>>;

export interface OperationType { id: FirstOperation; name: string; text: string; out: 'cable_out' | 'pipe_out' | 'passed' | 'ahead' | 'ballast' | '' }

export const operationTypes: readonly OperationType[] = [
  { id: 'abandonment', name: 'Abandonment', text: 'the pipe is sealed with a head and lowered to the seabed on a cable', out: 'cable_out' },
  { id: 'recovery', name: 'Recovery', text: 'the pipe is recovered with the cable', out: 'cable_out' },
  { id: 'lay_down', name: 'Lay-down', text: 'the end of the line is lowered to the seabed on a cable', out: 'cable_out' },
  { id: 'start_up', name: 'Start-up', text: 'the pipe is pulled off the vessel by a cable to an anchor', out: 'pipe_out' },
  { id: 'move', name: 'Move ahead', text: 'the vessel moves ahead by one joint', out: 'ahead' },
  { id: 'shore_pull', name: 'Shore pull', text: 'a remote winch pulls the pipe along the seabed', out: 'pipe_out' },
  { id: 'hold_back', name: 'Hold-back', text: 'the vessel pulls the pipe back against the winch', out: 'pipe_out' },
  { id: 'passage', name: 'Passage', text: 'a structure in the pipe passes over the stinger', out: 'passed' },
  { id: 'ballast', name: 'Ballast', text: 'a tank of the stinger is flooded', out: 'ballast' },
  { id: 'lift', name: 'Davit lift', text: 'davits haul in and pay out, stage by stage', out: '' },
];

export const operationType = (id: string): OperationType | undefined => operationTypes.find((type) => type.id === id);

/** These types have the same keys: only the type has to be changed. */
const alike: readonly (readonly string[])[] = [['abandonment', 'recovery', 'lay_down'], ['shore_pull', 'hold_back']];
export const sameKeys = (a: string, b: string): boolean => a === b || alike.some((group) => group.includes(a) && group.includes(b));

const leaf = (fields: Fields, path: string): string => { const value = fields.get(path)?.value; return value === null || value === undefined ? '' : String(value); };
const leaves = (fields: Fields, group: string, keys: string[]): string => keys.map((key) => leaf(fields, `operation.${group}.${key}`)).filter(Boolean).join(', ');

export const headText = (fields: Fields): string => leaves(fields, 'head', ['length', 'weight_in_air']);
export const cableText = (fields: Fields): string => leaves(fields, 'cable', ['diameter', 'breaking_load', 'length']);

export const isStageList = (fields: Fields): boolean => fields.get('operation.stages')?.kind === 'list' && fields.get('operation.stages')?.given === true;

/** Number of stages in the model; 0 if there are none yet. */
export function stageCount(fields: Fields): number {
  if (isStageList(fields)) return fields.get('operation.stages')?.count ?? 0;
  if (!fields.get('operation.stages.from')?.given) return 0;
  return (fields.get('operation.stages.steps')?.si ?? 10) + 1;
}

const outLabels: Record<string, string> = { cable_out: 'cable out', pipe_out: 'pipe out', passed: 'passed', ahead: 'ahead', ballast: 'flooded' };

/** First and last value of a key over the listed stages, as written. */
function ends(fields: Fields, key: string): [string, string] {
  const count = stageCount(fields);
  return [leaf(fields, `operation.stages[0].${key}`), leaf(fields, `operation.stages[${count - 1}].${key}`)];
}

/** "95 m to 400 m" as "95 to 400 m". */
export function spanText(from: string, to: string, between = 'to'): string {
  const unit = /[a-zA-Z%/*^]+\d*$/.exec(to)?.[0] ?? '';
  return from === to ? to : `${unit && from.endsWith(unit) ? from.slice(0, -unit.length).trim() : from} ${between} ${to}`;
}

export function stagesText(fields: Fields): string {
  const count = stageCount(fields), type = operationType(leaf(fields, 'operation.type'));
  if (count === 0) return 'none yet';
  if (!type?.out) return `${count}, listed`;
  const [from, to] = isStageList(fields) ? ends(fields, type.out) : [leaf(fields, 'operation.stages.from'), leaf(fields, 'operation.stages.to')];
  return `${count}, ${outLabels[type.out]} ${spanText(from, to)}`;
}

const limitNames: [key: string, text: string][] = [
  ['utilisation', 'utilisation below'], ['sagbend_strain', 'sagbend strain below'], ['sagbend_stress', 'sagbend below'], ['roller_load', 'rollers below'], ['tip_clearance', 'tip clearance above'],
];

/** Limits on the sought tension. */
export function limitsText(fields: Fields): string {
  const given = limitNames.filter(([key]) => fields.get(`operation.stages.limits.${key}`)?.given).map(([key, text]) => `${text} ${leaf(fields, `operation.stages.limits.${key}`)}`);
  return given.length ? given.join(', ') : 'utilisation below 1';
}

export type TensionMode = 'hold' | 'force' | 'forces' | 'bottom' | 'seek' | 'listed';

export function tensionMode(fields: Fields): TensionMode {
  if (isStageList(fields)) return 'listed';
  const field = fields.get('operation.stages.tension'), value = leaf(fields, 'operation.stages.tension');
  if (field?.kind === 'list' && field.given) return 'forces';
  if (!value || value === 'hold') return 'hold';
  return value === 'seek' || value === 'bottom' ? value : 'force';
}

export function tensionText(fields: Fields): string {
  const held = leaf(fields, 'tensioner.tension') || leaf(fields, 'tensioner.range[0]');
  switch (tensionMode(fields)) {
    case 'hold': return held ? `constant, ${held}` : 'as in the lay';
    case 'force': return leaf(fields, 'operation.stages.tension');
    case 'bottom': return `bottom ${leaf(fields, 'operation.stages.bottom_tension') || '…'}`;
    case 'seek': return `seek: ${limitsText(fields)}`;
    case 'forces': {
      const count = fields.get('operation.stages.tension')?.count ?? 1;
      return spanText(leaf(fields, 'operation.stages.tension[0]'), leaf(fields, `operation.stages.tension[${count - 1}]`), '…');
    }
    default: {
      const [from, to] = ends(fields, 'tension');
      return from || to ? spanText(from || held, to || held, '…') : 'as in the lay';
    }
  }
}

/** True if the program can seek tensions for this type. */
export const canSeek = (type: string): boolean => !['', 'lift', 'ballast'].includes(type);

/** Default utilisation limit of a procedure. */
export const designUtilisation = 0.9;

/** Seeks the minimum permissible tension of every stage; listed stages become as many at even steps. */
export function designChanges(fields: Fields): Change[] {
  const limited = limitNames.some(([key]) => fields.get(`operation.stages.limits.${key}`)?.given);
  if (!isStageList(fields)) {
    const limits = limited ? [] : [{ path: 'operation.stages.limits', value: { utilisation: designUtilisation } }];
    return [{ path: 'operation.stages.tension', value: 'seek' }, ...limits];
  }
  const type = operationType(leaf(fields, 'operation.type')), count = stageCount(fields);
  const outs = Array.from({ length: count }, (_, i) => fields.get(`operation.stages[${i}].${type?.out ?? ''}`)?.si ?? Number.NaN).filter(Number.isFinite);
  if (!type?.out || outs.length < 2) return [];
  const metres = (v: number): string => `${tidy(v, 6)} m`;
  return [{ path: 'operation.stages', value: { from: metres(Math.min(...outs)), to: metres(Math.max(...outs)), steps: count - 1, tension: 'seek', limits: { utilisation: designUtilisation } } }];
}

/** End of a sought abandonment: one stage after the first with the head on the seabed; null if it already ends there. */
export function shortenedEnd(type: string, stages: readonly OperationStage[]): number | null {
  if (operationType(type)?.out !== 'cable_out') return null;
  const down = type === 'recovery' ? [...stages].reverse() : stages;
  const first = down.findIndex((_stage, i) => down.slice(i).every((later) => (later.values?.head_clearance ?? Infinity) < lying));
  return first < 0 || first >= down.length - 2 ? null : down[first + 1]!.out;
}

/** Clearance of the underside of the head below which it counts as on the seabed [m]. */
const lying = 0.3;

/** Index of a solved stage in the list of the model: a recovery is listed in reverse. */
export const listIndex = (type: string, stage: number, count: number): number => (type === 'recovery' ? count - 1 - stage : stage);

/** Solved stages at even steps as a list, each with the tension found. */
export function listChanges(type: string, stages: readonly OperationStage[]): Change[] {
  const out = operationType(type)?.out;
  if (!out) return [];
  const list = stages.map((stage, i) => ({
    ...(stage.name && stage.name !== `stage ${i + 1}` ? { name: stage.name } : {}),
    [out]: `${tidy(stage.out ?? 0, 6)} m`,
    ...(stage.tension === null ? {} : { tension: `${tidy(stage.tension / 1e3, 5)} kN` }),
  }));
  return [{ path: 'operation.stages', value: type === 'recovery' ? list.reverse() : list }];
}
