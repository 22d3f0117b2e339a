// The visible picture as one PNG.
import { gradientStops } from '../../components/colourScale';
import { makeImage, pageColours, paintCaption, paintKey, paintNames, paintSky, sheet, standalone } from '../../logic/pictureFile';
import { tidy } from '../../logic/units';
import { title } from '../../state/model';
import { mode } from '../../state/picture';
import { calmLay } from '../../state/shown';
import type { View3D } from '../../view/view3d';
import { pipeColours } from './colouring';
import { animating } from './moment';

/** `box`: the element of the picture. */
export async function snapshot(box: HTMLElement, view: View3D | null): Promise<Blob> {
  const { width, height } = box.getBoundingClientRect(), colours = pageColours();
  const { canvas, pen } = sheet(width, height);
  paintSky(pen, colours, width, height);
  const svg = box.querySelector<SVGSVGElement>('svg.pictured');
  if (mode.value !== '3d' && svg) {
    pen.fillStyle = colours.paper;
    pen.fillRect(0, 0, width, height);
    const area = svg.getBoundingClientRect(), from = box.getBoundingClientRect();
    pen.drawImage(await makeImage(standalone(svg)), area.left - from.left, area.top - from.top, area.width, area.height);
  } else if (view) {
    const seen = view.snapshot();
    pen.drawImage(seen.canvas, 0, 0, seen.width, seen.height);
    paintNames(pen, colours, seen.names);
  }
  const lay = calmLay.value;
  if (lay?.pipe.s.length && mode.value !== 'plan' && mode.value !== 'section') {
    const { scale, shown } = pipeColours(lay, animating.value);
    const unit = shown.unit === '–' ? '' : ` ${shown.unit}`;
    paintKey(pen, colours, { title: shown.name, stops: gradientStops(scale), low: tidy(scale.low, 3), high: `${tidy(scale.high, 3)}${unit}` }, width);
  }
  paintCaption(pen, colours, [title.value, box.querySelector('.caption')?.firstChild?.textContent ?? ''].filter(Boolean).join(' · '), height);
  return new Promise((done, fail) => canvas.toBlob((blob) => (blob ? done(blob) : fail(new Error('The picture could not be converted to an image'))), 'image/png'));
}
