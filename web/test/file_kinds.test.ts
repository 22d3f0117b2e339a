// Files are recognised by their content.
import { expect, test } from 'vitest';
import { isOrcaFlex, isYaml } from '../src/logic/fileKinds';

test('a text data file of OrcaFlex is recognised by its groups, in parts as well', () => {
  expect(isOrcaFlex('%YAML 1.1\n---\nGeneral:\n  UnitsSystem: SI\n')).toBe(true);
  expect(isOrcaFlex('%YAML 1.1\n---\n- includefile: types.yml\n')).toBe(true);
  expect(isOrcaFlex('VesselTypes:\n  - Name: Barge\n')).toBe(true);
});

test('a model is not taken for a file of another program', () => {
  expect(isOrcaFlex('overbend: 1\ntitle: a lay\n')).toBe(false);
  expect(isOrcaFlex('# General: notes\noverbend: 1\nenvironment:\n  water_depth: 30 m\n')).toBe(false);
  expect(isOrcaFlex('title: a\nlines:\n  - name: b\n')).toBe(false);
});

test('names of models end in yaml or yml', () => {
  expect(['a.yaml', 'b.YML', 'c.csv'].map(isYaml)).toEqual([true, true, false]);
});
