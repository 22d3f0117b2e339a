// Caption at the lower left of the picture: time and vessel motion in a run, or the stage of an operation.
import { fixedIn, text, unitName } from '../../logic/show';
import { stagePlace } from '../../logic/operation';
import { histories, shown as frame, valueAt } from '../../state/animation';
import { reached } from '../../state/events';
import { calmState, stage } from '../../state/moorings';
import { chosenStage, operation } from '../../state/operation';
import { ofRun, shownScene, shownStage } from '../../state/shown';

const rollAngle = (pose: readonly number[]): number => Math.atan2(pose[10]!, pose[11]!);

/** Motion relative to the static pose. */
function motion(pose: readonly number[]): string[] {
  const rest = shownScene.value?.vessel?.pose;
  if (!rest) return [];
  return [`roll ${fixedIn(rollAngle(pose) - rollAngle(rest), 'rad', 1)}°`, `heave ${fixedIn(pose[2]! - rest[2]!, 'm', 2)} ${unitName('m')}`];
}

function ofMoment(): string[] | null {
  const f = frame.value;
  if (!f) return null;
  const h = histories.value, tension = valueAt(h['tensioner/tension'] ?? h['top_tension'], f.time);
  return [`t = ${f.time.toFixed(1)} s`, ...motion(f.pose), ...(tension === null ? [] : [`tension ${text(tension, 'N', 4)}`])];
}

function ofStage(): string[] | null {
  if (ofRun.value) return null;
  const current = shownStage.value, all = operation.value;
  if (current && all) {
    const { values } = current;
    const out = current.out === null ? [] : [`${all.out_name.toLowerCase()} ${text(current.out, 'm', 4)}`];
    const head = values?.head_z ?? null;
    const heights = head === null ? [] : [`head ${text(Math.abs(head), 'm', 3)} ${head < 0 ? 'below' : 'above'} the water`];
    return [`stage ${stagePlace(current, chosenStage.value, all.stages.length)}`, ...out, ...heights];
  }
  const moored = calmState.value;
  return moored && stage.value >= 0 ? [`stage ${moored.name || stage.value + 1}`] : null;
}

export function Caption() {
  const parts = ofMoment() ?? ofStage(), event = reached.value;
  if (!parts) return null;
  return (
    <div class="caption" data-clear>
      {parts.join(' · ')}
      {event ? <p class="reached"><b>{event.title}</b>{event.detail ? `, ${event.detail}` : ''}</p> : null}
    </div>
  );
}
