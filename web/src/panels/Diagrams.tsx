// The diagrams of the dock: each shows the quantity selected in its menu, along the pipe.
import { useEffect, useRef } from 'preact/hooks';
import { signal } from '@preact/signals';
import { along, lineShape, lineTension, reactions, shape, type ChartData } from '../charts/data';
import { quantities, quantity } from '../logic/show';
import { onLines } from '../logic/views';
import { opened } from '../state/model';
import { calmLay, ofRun, shownFailure, shownScene, shownStage } from '../state/shown';
import { cursor, slots } from '../state/look';
import { calmState, chosenLine } from '../state/moorings';
import { envelopes, runChecks, runSummary } from '../state/runs';
import { Plot } from './Plot';

/** Number of diagrams side by side in the dock. */
const width = signal(900);
const shownSlots = (): number => Math.max(1, Math.min(4, Math.round(width.value / 440)));

function statics(what: string): ChartData | null {
  const s = calmLay.value;
  if (!s) return null;
  if (s.pipe.s.length === 0) {
    const named = <T extends { name: string }>(list: T[]): T | undefined => list.find((l) => l.name === chosenLine.value) ?? list[0];
    const alone = named(s.lines), line = alone ?? named(calmState.value?.moorings.filter((l) => !l.parted) ?? []);
    if (alone && what === 'effective_tension') return lineTension(alone);
    return line && (what === 'elevation' || what === 'plan') ? lineShape(line, shownScene.value, what === 'plan') : null;
  }
  if (what === 'elevation' || what === 'plan') return shape(s, shownScene.value, what === 'plan', ofRun.value ? null : shownStage.value?.parts ?? null);
  if (what === 'reactions') return s.supports.length ? reactions(s, ofRun.value ? runSummary.value?.dynamic : undefined) : null;
  if (!quantities.some((q) => q.key === what && s.pipe[q.key]?.length)) return null;
  return ofRun.value ? along(what, s, envelopes.value, runChecks.value ?? s.checks) : along(what, s, null, s.checks);
}

/** Reason why a diagram along the pipe is empty. */
function empty(): string {
  const s = calmLay.value;
  if (!s) return 'No solution yet.';
  if (s.pipe.s.length) return 'The model has no roller boxes.';
  if (!s.lines.length && !onLines(s)) return 'The model has neither pipe nor lines.';
  return s.lines.length ? 'Lines have elevation, plan and effective tension only.' : 'The model has no pipe. Elevation and plan show a mooring line.';
}

function Diagram({ index }: { index: number }) {
  const asked = slots.value[index] ?? 'elevation', lay = calmLay.value;
  const unknown = !['elevation', 'plan', 'reactions'].includes(asked) && !quantity(asked);
  // without a pipe: quantities of lines
  const lines = lay !== null && lay.lines.length > 0 && lay.pipe.s.length === 0;
  const what = unknown || (lines && !['elevation', 'plan'].includes(asked)) ? 'effective_tension' : asked;
  const choose = (value: string): void => { const next = [...slots.value]; next[index] = value; slots.value = next; };
  return (
    <Plot
      data={statics(what)}
      empty={empty()}
      legend
      old={shownFailure.value !== null}
      cursor={cursor.value}
      onHover={(s) => { cursor.value = s; }}
      title="Drag to zoom, double-click to reset"
    >
      <select aria-label={`Diagram ${index + 1}`} value={what} onChange={(e) => choose(e.currentTarget.value)}>
        <option value="elevation">Elevation</option>
        <option value="plan">Plan</option>
        {quantities.map((q) => <option key={q.key} value={q.key}>{q.name}</option>)}
        <option value="reactions">Box reactions</option>
      </select>
    </Plot>
  );
}

export function Diagrams() {
  const box = useRef<HTMLElement>(null);
  useEffect(() => {
    const observer = new ResizeObserver(() => { width.value = box.current?.clientWidth ?? width.value; });
    observer.observe(box.current!);
    return () => observer.disconnect();
  }, []);
  const count = shownSlots();
  return (
    <section ref={box} class="diagrams" style={{ gridTemplateColumns: `repeat(${count}, minmax(0, 1fr))` }} aria-label="Diagrams">
      {Array.from({ length: count }, (_, i) => <Diagram key={`${opened.value} ${i}`} index={i} />)}
    </section>
  );
}
