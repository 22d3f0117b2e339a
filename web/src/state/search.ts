// Entries of the search: commands, objects and keys of the model, findings and errors, examples. Pages of the guide are
// not served by the program and therefore not included.
import { tree } from '../logic/formTree';
import { isItem, isObject, objectTitle, summaryValue, type FieldNode } from '../logic/modelTree';
import type { SearchEntry } from '../logic/search';
import { variableName } from '../logic/variables';
import { commands } from './commands';
import { followFinding } from './findingPlace';
import { shownFindings } from './findings';
import { leadTo, leadToDiagnostic } from './lead';
import { asking } from './look';
import { byPath, diagnostics, fields, info, openExample, unsaved } from './model';
import { drawer, selectObject } from './workspace';

export interface Place extends SearchEntry { act: () => void }

function commandPlaces(): Place[] {
  return commands.value.map((command) => ({ id: `command ${command.id}`, name: command.name, more: command.more, detail: command.keys, kind: 'command', weight: 6, act: command.act }));
}

function objectPlaces(): Place[] {
  const places = (nodes: readonly FieldNode[]): Place[] => nodes.filter((node) => isObject(node) && node.given).flatMap((node) => [{
    id: `object ${node.path}`,
    name: itemName(node),
    more: node.path,
    detail: summaryValue(node, byPath.value),
    kind: 'object' as const,
    weight: 8,
    act: () => { drawer.value = 'model'; selectObject(node.path); },
  }, ...places(node.children)]);
  return places(tree(fields.value));
}

/** Items without a name are numbered: "stinger 3". */
function itemName(node: FieldNode): string {
  if (!isItem(node) || byPath.value.get(`${node.path}.name`)?.value) return objectTitle(node);
  return variableName(node.path, byPath.value);
}

function keyPlaces(): Place[] {
  return fields.value.filter((f) => f.kind !== 'map' && f.kind !== 'list').map((field) => ({
    id: `key ${field.path}`,
    name: variableName(field.path, byPath.value),
    more: `${field.path} ${field.text}`,
    detail: String(field.value ?? (field.default !== null ? `${field.default} (default)` : '')),
    kind: 'key',
    weight: field.given ? 5 : 0,
    act: () => leadTo(field.path),
  }));
}

function findingPlaces(): Place[] {
  const ofModel = diagnostics.value.map((d, i): Place => ({ id: `diagnostic ${i}`, name: d.message, more: `${d.key} ${d.severity}`, detail: `line ${d.line}`, kind: 'finding', act: () => leadToDiagnostic(d) }));
  const ofLay = shownFindings.value.filter((b) => !b.key).map((b, i): Place => {
    const name = b.name || b.object;
    return { id: `finding ${i}`, name: name ? `${name}: ${b.full}` : b.full, more: b.code, detail: b.severity, kind: 'finding', act: () => followFinding(b) };
  });
  return [...ofModel, ...ofLay];
}

function examplePlaces(): Place[] {
  return (info.value?.examples ?? []).map((example) => ({
    id: `example ${example.name}`,
    name: example.title,
    more: `example ${example.name}`,
    detail: example.name,
    kind: 'example',
    act: () => { if (unsaved.value) asking.value = 'open'; else void openExample(example.name); },
  }));
}

export const searchPlaces = (): Place[] => [...commandPlaces(), ...objectPlaces(), ...keyPlaces(), ...findingPlaces(), ...examplePlaces()];
