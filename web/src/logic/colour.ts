// Colour maps as short tables of anchor colours, linear in between. All are readable for colour-blind eyes.
import { readHex, type Rgb } from '../components/colourScale';

const maps = {
  // viridis without its darkest end, which would drown in deep water
  stress: ['#31688e', '#26828e', '#1f9e89', '#35b779', '#6ece58', '#b5de2b', '#fde725', '#fca636', '#e8602c', '#c3172b'],
  load: ['#ffe8a3', '#ffc247', '#f98e2b', '#e4572e', '#b3123a'],
} as const;

export type MapName = keyof typeof maps;

const parts = (hex: string): Rgb => readHex(hex).map((v) => v / 255) as Rgb;
const anchors: Record<MapName, Rgb[]> = { stress: maps.stress.map(parts), load: maps.load.map(parts) };

/** Colour at `t` from 0 to 1, written into `out` (three numbers from 0 to 1) to spare garbage in the drawing loop. */
export function colourAt(map: MapName, t: number, out: Rgb = [0, 0, 0]): Rgb {
  const list = anchors[map];
  const place = Math.min(1, Math.max(0, Number.isFinite(t) ? t : 0)) * (list.length - 1);
  const i = Math.min(list.length - 2, Math.floor(place));
  const f = place - i;
  for (let k = 0; k < 3; ++k) out[k] = list[i]![k]! * (1 - f) + list[i + 1]![k]! * f;
  return out;
}

export function css(map: MapName): string {
  return `linear-gradient(to right, ${maps[map].join(', ')})`;
}

/** A range with round ends for a legend, so that it does not flicker while a value is dragged. */
export function niceRange(low: number, high: number): [number, number] {
  if (!(high > low)) return [low - 0.5, low + 0.5];
  const step = 10 ** Math.floor(Math.log10((high - low) / 2));
  const part = (high - low) / step > 10 ? 2 * step : step;
  return [Math.floor(low / part) * part, Math.ceil(high / part) * part];
}
