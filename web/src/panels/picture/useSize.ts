// Size of an element in whole pixels, kept up to date.
import type { RefObject } from 'preact';
import { useEffect, useState } from 'preact/hooks';

export function useSize(box: RefObject<HTMLElement>): { width: number; height: number } {
  const [size, setSize] = useState({ width: 0, height: 0 });
  useEffect(() => {
    const measure = (): void => { const r = box.current!.getBoundingClientRect(); setSize({ width: Math.floor(r.width), height: Math.floor(r.height) }); };
    const observer = new ResizeObserver(measure);
    observer.observe(box.current!);
    return () => observer.disconnect();
  }, []);
  return size;
}
