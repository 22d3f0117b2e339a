// The pointer over a drawing.
import type { RefObject } from 'preact';
import { useEffect } from 'preact/hooks';
import type { Pixel } from './labels';

/** Position of an event in the coordinates of a drawing. */
export function pixelIn(svg: SVGSVGElement, event: MouseEvent): Pixel {
  const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM()!.inverse());
  return [place.x, place.y];
}

/** Follows the pointer over the drawing that contains an element; null when it leaves. */
export function usePointer(element: RefObject<SVGGraphicsElement>, listener: (pixel: Pixel | null, click: boolean) => void): void {
  useEffect(() => {
    const svg = element.current?.ownerSVGElement;
    if (!svg) return undefined;
    const move = (event: MouseEvent) => listener(pixelIn(svg, event), event.type === 'click');
    const leave = () => listener(null, false);
    svg.addEventListener('pointermove', move);
    svg.addEventListener('click', move);
    svg.addEventListener('pointerleave', leave);
    return () => {
      svg.removeEventListener('pointermove', move);
      svg.removeEventListener('click', move);
      svg.removeEventListener('pointerleave', leave);
    };
  });
}
