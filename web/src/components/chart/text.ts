// Text widths in the font of the page.

let pen: CanvasRenderingContext2D | null = null;
let family = '';

/** Width in pixels; estimated outside a browser. */
export function textWidth(text: string, size = 14, bold = false): number {
  if (typeof document === 'undefined') return 0.55 * size * text.length;
  if (!pen) {
    pen = document.createElement('canvas').getContext('2d')!;
    family = getComputedStyle(document.body).fontFamily;
  }
  pen.font = `${bold ? '600 ' : ''}${size}px ${family}`;
  return pen.measureText(text).width;
}
