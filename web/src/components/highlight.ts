// The highlighted item of a list: the one under the pointer, otherwise the selected one.
import { useEffect, useState } from 'preact/hooks';

export class Highlight {
  private readonly listeners = new Set<() => void>();
  private chosen: number | null = null;
  private pointed: number | null = null;

  get current(): number | null {
    return this.pointed ?? this.chosen;
  }

  point(index: number | null): void {
    if (index === this.pointed) return;
    this.pointed = index;
    this.listeners.forEach((listener) => listener());
  }

  /** Selects an item; selecting it again clears the selection. */
  choose(index: number): void {
    this.chosen = this.chosen === index ? null : index;
    this.pointed = null;
    this.listeners.forEach((listener) => listener());
  }

  listen(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => { this.listeners.delete(listener); };
  }
}

/** The highlighted item; the component is drawn again when it changes. */
export function useHighlighted(highlight: Highlight): number | null {
  const [current, setCurrent] = useState(highlight.current);
  useEffect(() => highlight.listen(() => setCurrent(highlight.current)), [highlight]);
  return current;
}
