// Frame of the tabs of the storm's dock: size, mark of outdated results, and a message if
// there are no results yet.
import type { ComponentChildren } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { isStudy } from '../../logic/runs';
import { selected } from '../../state/runs';
import { staleKeys, storms } from '../../state/storm';

/** Number of diagrams side by side in a dock of this width. */
export const plotCount = (width: number): number => (width >= 1700 ? 4 : width >= 1150 ? 3 : width >= 560 ? 2 : 1);

/** Current width of an element. */
export function useWidth(): [preact.RefObject<HTMLDivElement>, number] {
  const box = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(800);
  useEffect(() => {
    const observer = new ResizeObserver(() => setWidth(box.current?.clientWidth ?? 800));
    observer.observe(box.current!);
    return () => observer.disconnect();
  }, []);
  return [box, width];
}

/** Reason why there is nothing to show. */
export function emptyText(): string {
  const run = selected.value;
  if (!run) return storms.value.length ? 'Choose a run above, or run the storm.' : 'Results appear here after the first run of a storm.';
  if (run.state === 'queued') return 'Waiting for the previous run.';
  if (run.state === 'running' && isStudy(run)) return 'Results of a seed are shown as soon as it has ended.';
  if (run.state === 'running') return 'Available when the run has ended. Histories are shown while it runs.';
  if (run.state === 'failed') return 'The run failed and has no results.';
  return run.has_results ? 'The run has no such results.' : 'The run has no results.';
}

export function TabFrame({ children, ready = true }: { children: ComponentChildren; ready?: boolean }) {
  return <div class={`stormtab${staleKeys.value ? ' stale' : ''}`}>{ready ? children : <p class="empty">{emptyText()}</p>}</div>;
}
