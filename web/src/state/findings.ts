// Diagnostics of the model and findings of the results, the serious ones first, each with its location.
import { computed } from '@preact/signals';
import type { Finding } from '../api/results';
import { bullet, bullets, type Bullet } from '../logic/findings';
import { byPath, diagnostics } from './model';
import { runSummary } from './runs';
import { calmLay, shownRun } from './shown';

/** Findings of the selected run, otherwise of the stage or the live statics. */
const said = computed<readonly Finding[]>(() => {
  if (!shownRun.value) return calmLay.value?.findings ?? [];
  const run = runSummary.value;
  return run ? [...(run.dynamic?.findings ?? []), ...(run.findings ?? [])] : [];
});

const boxNames = computed(() => calmLay.value?.supports.map((box) => box.name) ?? []);

export const shownFindings = computed<Bullet[]>(() => [
  ...(shownRun.value ? [] : diagnostics.value.filter((d) => d.severity === 'warning').map((d) => bullet(d.message, [], d.key))),
  ...bullets(said.value, boxNames.value),
]);

/** Path of the object of the model with a result name. */
export function pathOfName(name: string): string {
  for (const [path, field] of byPath.value) if (field.value === name && path.endsWith('].name')) return path.slice(0, -'.name'.length);
  if (byPath.value.has(name)) return name; // "pipe"
  // boxes without a name are numbered: "stinger 8"
  const [, structure, number] = /^(ramp|stinger) (\d+)$/.exec(name) ?? [];
  if (!structure) return '';
  const path = `supports.${structure}.boxes[${Number(number) - 1}]`;
  return byPath.value.has(`${path}.x`) ? path : `supports.${structure}`;
}

/** Objects of the model with findings. */
export const concerned = computed(() => {
  const out = new Map<string, Finding['severity']>();
  for (const finding of said.value) {
    const path = finding.object ? pathOfName(finding.object) : '';
    if (path && out.get(path) !== 'serious' && finding.severity !== 'note') out.set(path, finding.severity);
  }
  return out;
});
