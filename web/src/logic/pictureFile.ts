// The picture as one image: the 3-D view with its names, or a drawing, with the scale of the legend and the caption.
import type { ShownName } from '../view/labels';

const kept = ['fill', 'fill-opacity', 'stroke', 'stroke-width', 'stroke-opacity', 'stroke-dasharray', 'stroke-linejoin', 'opacity', 'font-size', 'font-weight', 'font-family', 'paint-order', 'text-anchor', 'visibility', 'display'] as const;

/** The drawing with its computed style embedded. */
export function standalone(svg: SVGSVGElement): string {
  const copy = svg.cloneNode(true) as SVGSVGElement;
  const from = [svg, ...svg.querySelectorAll<SVGElement>('*')], to = [copy, ...copy.querySelectorAll<SVGElement>('*')];
  from.forEach((element, i) => {
    const style = getComputedStyle(element);
    to[i]!.setAttribute('style', kept.map((name) => `${name}:${style.getPropertyValue(name)}`).join(';'));
  });
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  const { width, height } = svg.getBoundingClientRect();
  copy.setAttribute('width', String(width));
  copy.setAttribute('height', String(height));
  return new XMLSerializer().serializeToString(copy);
}

export function makeImage(text: string): Promise<HTMLImageElement> {
  return new Promise((done, fail) => {
    const image = new Image();
    image.onload = () => done(image);
    image.onerror = () => fail(new Error('The drawing could not be converted to an image'));
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
  });
}

export interface Colours { ink: string; soft: string; paper: string; top: string; low: string; family: string }

export function pageColours(): Colours {
  const style = getComputedStyle(document.documentElement), get = (name: string): string => style.getPropertyValue(`--${name}`).trim();
  return { ink: get('ink'), soft: get('soft'), paper: get('paper'), top: get('sky-top'), low: get('void'), family: getComputedStyle(document.body).fontFamily };
}

/** A canvas in CSS pixels, with the resolution of the screen. */
export function sheet(width: number, height: number): { canvas: HTMLCanvasElement; pen: CanvasRenderingContext2D } {
  const canvas = document.createElement('canvas'), ratio = Math.max(1, Math.min(2, devicePixelRatio));
  [canvas.width, canvas.height] = [width * ratio, height * ratio];
  const pen = canvas.getContext('2d')!;
  pen.scale(ratio, ratio);
  return { canvas, pen };
}

export function paintSky(pen: CanvasRenderingContext2D, { top, low }: Colours, width: number, height: number): void {
  const sky = pen.createLinearGradient(0, 0, 0, height);
  sky.addColorStop(0, top);
  sky.addColorStop(1, low);
  pen.fillStyle = sky;
  pen.fillRect(0, 0, width, height);
}

export function paintNames(pen: CanvasRenderingContext2D, { ink, soft, paper, family }: Colours, names: readonly ShownName[]): void {
  pen.font = `11px ${family}`;
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  for (const { text, x, middle, top, leader } of names) {
    const wide = pen.measureText(text).width + 10;
    pen.strokeStyle = soft;
    pen.beginPath();
    pen.moveTo(x, top + 18);
    pen.lineTo(x, top + 18 + leader);
    pen.stroke();
    pen.fillStyle = paper;
    pen.globalAlpha = 0.86;
    pen.fillRect(middle - wide / 2, top, wide, 18);
    pen.globalAlpha = 1;
    pen.fillStyle = ink;
    pen.fillText(text, middle, top + 9.5);
  }
}

export interface Key { title: string; stops: { offset: number; colour: string }[]; low: string; high: string }

/** Title, scale and ends at the upper right. */
export function paintKey(pen: CanvasRenderingContext2D, { ink, soft, paper, family }: Colours, key: Key, width: number): void {
  const [wide, x, y] = [190, width - 200, 10];
  pen.globalAlpha = 0.86;
  pen.fillStyle = paper;
  pen.fillRect(x, y, wide, 56);
  pen.globalAlpha = 1;
  pen.textBaseline = 'alphabetic';
  pen.fillStyle = ink;
  pen.textAlign = 'left';
  pen.font = `600 12px ${family}`;
  pen.fillText(key.title, x + 8, y + 16);
  const ramp = pen.createLinearGradient(x + 8, 0, x + wide - 8, 0);
  for (const { offset, colour } of key.stops) ramp.addColorStop(Math.min(1, Math.max(0, offset)), colour);
  pen.fillStyle = ramp;
  pen.fillRect(x + 8, y + 22, wide - 16, 9);
  pen.fillStyle = soft;
  pen.font = `11px ${family}`;
  pen.fillText(key.low, x + 8, y + 46);
  pen.textAlign = 'right';
  pen.fillText(key.high, x + wide - 8, y + 46);
}

export function paintCaption(pen: CanvasRenderingContext2D, { ink, paper, family }: Colours, caption: string, height: number): void {
  if (!caption) return;
  pen.font = `12px ${family}`;
  pen.textAlign = 'left';
  pen.textBaseline = 'middle';
  const wide = pen.measureText(caption).width + 14;
  pen.globalAlpha = 0.86;
  pen.fillStyle = paper;
  pen.fillRect(10, height - 32, wide, 22);
  pen.globalAlpha = 1;
  pen.fillStyle = ink;
  pen.fillText(caption, 17, height - 20.5);
}
