// Commands of a field: reset to default, pin as slider, goal seek, sensitivity, show in YAML.
import type { Field } from '../api/types';
import { keyVariable } from '../logic/variables';
import { leadToText } from '../state/lead';
import { setLive } from '../state/live';
import { byPath, setKeys } from '../state/model';
import { say, sayError } from '../state/notices';
import { addPin, isPinned, removePin } from '../state/pins';
import { openSeek } from '../state/seek';
import { openKeySensitivity } from './KeySensitivity';
import { openMenu, type MenuItem } from './Menu';

async function reset(field: Field): Promise<void> {
  setLive(field.path, undefined);
  try { await setKeys([{ path: field.path, value: null }]); } catch (error) { sayError(error); }
}

async function copyPath(path: string): Promise<void> {
  try { await navigator.clipboard.writeText(path); say(`Copied ${path}`); } catch { say(path); }
}

function commands(field: Field, name: string): MenuItem[] {
  const path = field.path, pinned = isPinned(path);
  const number = keyVariable(field, byPath.value) !== null;
  const byDefault = field.default !== null && field.default !== undefined;
  const sought = number && field.kind !== 'integer';
  return [
    ...(number ? [{ name: pinned ? 'Unpin the slider' : 'Pin as slider', act: () => (pinned ? removePin(path) : addPin(path)) }] : []),
    ...(sought ? [
      { name: 'Goal seek …', act: () => openSeek({ key: path }) },
      { name: 'Sensitivity', act: () => openKeySensitivity(path, name) },
    ] : []),
    ...(byDefault ? [{ name: 'Reset to default', title: `Default: ${field.default}`, disabled: !field.given, act: () => { void reset(field); } }] : []),
    { name: 'Show in YAML', act: () => leadToText(path) },
    { name: 'Copy path', title: path, act: () => { void copyPath(path); } },
    ...(byDefault || field.required ? [] : [{ name: 'Remove from model', title: field.left_out, disabled: !field.given, act: () => { void reset(field); } }]),
  ];
}

export function openFieldMenu(field: Field, name: string, x: number, y: number): void { openMenu(commands(field, name), x, y); }
