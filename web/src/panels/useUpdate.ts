// An effect of changes alone. At the start an effect runs after the first picture: a text typed before it would be lost.
import { useEffect, useRef } from 'preact/hooks';

/** Runs `effect` when one of `values` has changed, not at the start. */
export function useUpdate(effect: () => void, values: readonly unknown[]): void {
  const started = useRef(false);
  useEffect(() => {
    if (started.current) effect();
    started.current = true;
  }, [...values]);
}
