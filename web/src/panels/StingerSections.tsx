// Sections of a hinged stinger: angle, hinge forces, tanks.
import { numberIn, shownUnit, text, unitName } from '../logic/show';
import { tidyLength, twin } from '../logic/units';
import type { StingerSectionState } from '../api/types';
import { calmLay } from '../state/shown';
import { SeekButton } from './SeekDialog';

/** `result`: path in summary.json, for goal seek. */
export function Value({ name, value, unit, title, result }: { name: string; value: number | null | undefined; unit: string; title?: string; result?: string }) {
  if (value === null || value === undefined) return null;
  const shown = unitName(unit);
  return (
    <div class="kv" title={`${title ?? ''} ${twin(text(value, unit, 6))}`.trim()}>
      <dt>{name}{result ? <SeekButton goal={{ name, result, unit: shown, si: value }} /> : null}</dt><dd>{unit === 'm' ? tidyLength(value * shownUnit(unit).factor) : numberIn(value, unit)} <small>{shown}</small></dd>
    </div>
  );
}

/** One section of a hinged stinger. With several sections, goal seek refers to them by index. */
function Section({ section, only, index }: { section: StingerSectionState; only: boolean; index: number }) {
  const path = only ? 'static.stinger' : `static.stinger.sections[${index}]`;
  return (
    <dl>
      <Value name={section.name ? `angle of ${section.name}` : 'stinger angle'} value={section.angle} unit="rad" result={`${path}.angle`} title="Positive if the tip is below its nominal position." />
      <Value name="hinge force" value={section.hinge_force} unit="N" result={`${path}.hinge_force.magnitude`} />
      <Value name={section.at_stop ? 'moment of the stop' : 'holding moment'} value={section.stop_moment === 0 ? null : section.stop_moment} unit="N m" result={`${path}.stop_moment`} />
      <Value name="stinger period" value={section.natural_period > 0 ? section.natural_period : null} unit="s" title="For small rotations about the hinge." />
      <Value name="tank draught" value={section.tanks.length > 0 ? section.draught : null} unit="m" />
    </dl>
  );
}

export function StingerSections() {
  const sections = calmLay.value?.stinger ?? [];
  return <section class="stingersections" aria-label="Sections of the stinger">{sections.map((section, i) => <Section key={i} section={section} only={sections.length === 1} index={i} />)}</section>;
}
