// Saves a drawing of the page as SVG or PNG: on white, in print colours.
import { render, type VNode } from 'preact';
import style from '../../components/chart.css?inline';
import { download } from '../../components/download';

/** Some programs that read SVG do not support CSS variables. */
const paper: Record<string, string> = {
  ink: '#1b2733', soft: '#51606e', axis: '#51606e', grid: '#e6ebf0', mark: '#7b8794', paper: '#ffffff', deep: '#e6ecf1', pipe: '#0b5394', bad: '#b3261e',
  warn: '#8a5a00', good: '#1f7a3f', range: '#cfe8cf' };

const inPaper = (text: string): string => text.replace(/var\(--([\w-]+)\)/g, (_, name: string) => paper[name] ?? '#51606e');

const kFont = 'Arial, Helvetica, sans-serif';

/** Text of the first drawing in `drawn`, with its size in pixels. */
export function drawingText(drawn: VNode): { text: string; width: number; height: number } | null {
  const box = document.createElement('div');
  render(drawn, box);
  const svg = box.querySelector('svg');
  if (!svg) return null;
  const [, , width = 640, height = 320] = (svg.getAttribute('viewBox') ?? '').split(/\s+/).map(Number);
  svg.setAttribute('width', String(width));
  svg.setAttribute('height', String(height));
  const embedded = document.createElementNS('http://www.w3.org/2000/svg', 'style');
  embedded.textContent = `${style}svg.drawing{width:${width}px;height:${height}px;background:#fff;font-family:${kFont}}`
    + '.point circle{fill:#0b5394}.point path{fill:none;stroke:#b3261e;stroke-width:1.8}.hit{fill:transparent}';
  svg.prepend(embedded);
  const text = inPaper(new XMLSerializer().serializeToString(svg));
  render(null, box);
  return { text, width, height };
}

async function rasterised({ text, width, height }: { text: string; width: number; height: number }): Promise<Blob | null> {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
  await image.decode();
  const canvas = document.createElement('canvas'), scale = 2;
  [canvas.width, canvas.height] = [scale * width, scale * height];
  const context = canvas.getContext('2d')!;
  context.fillStyle = '#fff';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((done) => canvas.toBlob(done, 'image/png'));
}

export async function saveDrawing(drawn: VNode, name: string, kind: 'svg' | 'png'): Promise<void> {
  const drawing = drawingText(drawn);
  if (!drawing) return;
  const blob = kind === 'svg' ? new Blob([drawing.text], { type: 'image/svg+xml' }) : await rasterised(drawing);
  if (blob) download(`${name}.${kind}`, blob);
}
