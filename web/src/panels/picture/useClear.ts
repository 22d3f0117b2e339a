// Names in the picture avoid everything over it that is marked with data-clear.
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
    const container = box.current;
    let last = '';
    const update = (): void => {
      const taken = measured(container), key = JSON.stringify(taken);
      if (key === last) return;
      last = key;
      cards.value = taken;
      view.current?.keepClear(taken);
    };
    const sizes = new ResizeObserver(update);
    const watch = (): void => { sizes.disconnect(); for (const element of container.querySelectorAll('[data-clear]')) sizes.observe(element); update(); };
    // cards appear and disappear; changes of their content are detected by their size
    const changes = new MutationObserver(watch);
    changes.observe(container, { childList: true });
    sizes.observe(container);
    watch();
    return () => { sizes.disconnect(); changes.disconnect(); };
  }, [ready]);
}
