// Names in the picture keep clear of what stands over it: everything marked with data-clear.
import type { RefObject } from 'preact';
import { useEffect } from 'preact/hooks';
import type { Rect } from '../../logic/labelPlaces';
import type { View3D } from '../../view/view3d';
import { cards } from './moment';

function measured(box: HTMLElement): Rect[] {
  const from = box.getBoundingClientRect();
  return [...box.querySelectorAll('[data-clear]')].map((element) => {
    const r = element.getBoundingClientRect();
    return { x0: r.left - from.left, y0: r.top - from.top, x1: r.right - from.left, y1: r.bottom - from.top };
  }).filter((r) => r.x1 > r.x0);
}

export function useClear(box: RefObject<HTMLElement>, view: RefObject<View3D | null>, ready: boolean): void {
  useEffect(() => {
    if (!box.current) return undefined;
    const own = box.current;
    let last = '';
    const tell = (): void => {
      const taken = measured(own), key = JSON.stringify(taken);
      if (key === last) return;
      last = key;
      cards.value = taken;
      view.current?.keepClear(taken);
    };
    const sizes = new ResizeObserver(tell);
    const watch = (): void => { sizes.disconnect(); for (const element of own.querySelectorAll('[data-clear]')) sizes.observe(element); tell(); };
    // cards come and go; what changes within them is told by their size
    const changes = new MutationObserver(watch);
    changes.observe(own, { childList: true });
    sizes.observe(own);
    watch();
    return () => { sizes.disconnect(); changes.disconnect(); };
  }, [ready]);
}
