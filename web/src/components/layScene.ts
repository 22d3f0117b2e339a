// Contents of the three-dimensional pictures of a lay: sea, vessel, ramp, stinger, rollers, pipe.
import { aboveLimit, paperScale } from './colourScale';
import { Camera, Painter, add, cross, dot, scale, toPicture, unit, type Look, type Vector } from './painter';
import {
  belowBox, hullCorner, hullHeights, pipePoint, seabedHeight, seabedPlaces, stationPoint, stationValue, stationsUpTo, structures, wholeEnd,
  type LayData, type RollerData, type SupportData,
} from './lay';
import { tickStep } from './chart/scale';

export interface SceneContent { painter: Painter; fit: Vector[] }

const layers = { bed: 0, under: 1, water: 2, behind: 3, things: 4, before: 5 };

export const rollerColours = { contact: '#e8741a', noContact: '#aab4bd' };

/** Maximum of the colour scale of von Mises stress [Pa], up to the yield stress. */
export function largestOfScale({ stations }: LayData): number {
  return Math.max(...stations.von_mises.map((stress, i) => Math.min(stress, stations.yield_stress[i]! || stress)));
}

export const yields = ({ stations }: LayData): boolean => stations.von_mises.some((stress, i) => stress > (stations.yield_stress[i]! || Infinity));

/** Multiples of a step from `low` to `high`. */
function multiples(step: number, low: number, high: number): number[] {
  const first = Math.ceil(low / step);
  return Array.from({ length: Math.max(0, Math.floor(high / step) - first + 1) }, (_, k) => (first + k) * step);
}

type StressColour = (stress: number, yieldStress: number) => string;

function stressColour(lay: LayData): StressColour {
  const top = largestOfScale(lay) || 1;
  return (stress, yieldStress) => (yieldStress > 0 && stress > yieldStress ? aboveLimit : paperScale(stress / top));
}

function addSea(painter: Painter, lay: LayData, x0: number, x1: number, wide: number): void {
  const bed = (x: number, y: number): Vector => [x, y, seabedHeight(lay, x)];
  const along = seabedPlaces(lay, x0, x1);
  const outline = [...along.map((x) => bed(x, -wide)), ...along.map((x) => bed(x, wide)).reverse()];
  painter.addFace(layers.bed, outline, { fill: '#efe8d8', stroke: '#cfc3a6' });
  const step = tickStep(x0, x1, 10);
  const grid: Look = { stroke: '#d9ceb4', 'stroke-width': 0.8 };
  for (const x of multiples(step, x0, x1)) painter.addLine(layers.bed, [bed(x, -wide), bed(x, wide)], grid, 1e6);
  for (const y of multiples(step, -wide, wide)) painter.addLine(layers.bed, along.map((x) => bed(x, y)), grid, 1e6);
  const surface: Vector[] = [[x0, -wide, 0], [x1, -wide, 0], [x1, wide, 0], [x0, wide, 0]];
  painter.addFace(layers.water, surface, { fill: '#7fb2d6', 'fill-opacity': 0.16, stroke: '#7fb2d6', 'stroke-width': 0.8 });
}

/** Signs of the corners of a box, face by face. */
const boxFaces: Vector[][] = ([0, 1, 2] as const).flatMap((axis) => [-1, 1].map((side) =>
  [[-1, -1], [1, -1], [1, 1], [-1, 1]].map((pair) => {
    const corner = [...pair];
    corner.splice(axis, 0, side);
    return corner as unknown as Vector;
  })));

/** A translucent box between two heights of the hull: rear faces first, front faces last. */
function addHull(painter: Painter, lay: LayData, [low, high]: [number, number], [back, front]: [number, number], opacity: number): void {
  const middle = add(toPicture(lay.vessel.origin), [0, 0, (low + high) / 2]);
  for (const face of boxFaces) {
    const points = face.map((corner) => toPicture(hullCorner(lay, ...(corner as [number, number, number]), low, high)));
    const centre = scale(points.reduce((sum, p) => add(sum, p), [0, 0, 0] as Vector), 0.25);
    const towardsEye = dot(add(centre, middle, -1), painter.camera.towardsEye) > 0;
    painter.addFace(towardsEye ? front : back, points, {
      fill: '#93a3b1', 'fill-opacity': towardsEye ? opacity : 2 * opacity, stroke: '#66757f', 'stroke-width': 0.9, 'stroke-linejoin': 'round',
    });
  }
}

/** A line below the boxes, on one side. */
const chordBelow = (boxes: SupportData[], across: number, down: number): Vector[] =>
  boxes.flatMap((box) => [-0.5, 0.5].map((k) => toPicture(add(belowBox(box, k * box.length, down), [0, across, 0]))));

/** Schematic chords and posts below the boxes of ramp and stinger. */
function addStructure(painter: Painter, width: number, shown: SupportData[]): void {
  const thick: Look = { stroke: '#76838f', 'stroke-width': width, 'stroke-linecap': 'round' };
  const thin: Look = { stroke: '#97a3ad', 'stroke-width': 0.65 * width };
  const addBar = (a: Vector | undefined, b: Vector | undefined, look: Look): void => { if (a && b) painter.addLine(layers.things, [a, b], look); };
  for (const boxes of structures(shown)) {
    const deep = boxes[0]!.stinger ? 1.9 : 0.9;
    const chords = [[1, 0.6], [-1, 0.6], [0.8, deep], [-0.8, deep]].map(([across, down]) => chordBelow(boxes, across!, down!));
    const [port, starboard, lowerPort, lowerStarboard] = chords as [Vector[], Vector[], Vector[], Vector[]];
    port.forEach((_, i) => {
      for (const chord of chords) addBar(chord[i - 1], chord[i], thick);
      addBar(port[i], starboard[i], thick);
      addBar(port[i], lowerPort[i], thin);
      addBar(starboard[i], lowerStarboard[i], thin);
      addBar(lowerPort[i], lowerStarboard[i], thin);
      addBar(lowerPort[i - 1], port[i], thin);
      addBar(lowerStarboard[i - 1], starboard[i], thin);
    });
  }
}

type Pair = [Vector, Vector];

/** Two unit vectors perpendicular to an axis. */
function acrossAxis(axis: Vector): Pair {
  const a = unit(cross(Math.abs(axis[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0], axis));
  return [a, cross(axis, a)];
}

const sides = 12;

function ring(centre: Vector, [a, b]: Pair, radius: number): { normal: Vector; p: Vector }[] {
  return Array.from({ length: sides }, (_, k) => {
    const angle = 2 * Math.PI * k / sides;
    const normal = add(scale(a, Math.cos(angle)), b, Math.sin(angle));
    return { normal, p: add(centre, normal, radius) };
  });
}

function addTube(painter: Painter, layer: number, ends: Pair, axis: Vector, radius: number, colour: string): Vector[][] {
  const [first, second] = ends.map((end) => ring(end, acrossAxis(axis), radius)) as [ReturnType<typeof ring>, ReturnType<typeof ring>];
  for (let k = 0; k < sides; ++k) {
    const m = (k + 1) % sides;
    const face = [first[k]!.p, first[m]!.p, second[m]!.p, second[k]!.p];
    painter.addShaded(layer, face, unit(add(first[k]!.normal, first[m]!.normal)), colour);
  }
  return [first.map((corner) => corner.p), second.map((corner) => corner.p)];
}

function addRoller(painter: Painter, layer: number, roller: RollerData): void {
  const axis = unit(toPicture(roller.axis));
  const centre = add(toPicture(roller.p), toPicture(roller.normal), -roller.radius);
  const ends: Pair = [add(centre, axis, -roller.face / 2), add(centre, axis, roller.face / 2)];
  const colour = roller.reaction > 0 ? rollerColours.contact : rollerColours.noContact;
  const [first, second] = addTube(painter, layer, ends, axis, roller.radius, colour) as [Vector[], Vector[]];
  painter.addShaded(layer, first, scale(axis, -1), colour);
  painter.addShaded(layer, second, axis, colour);
}

const allRollers = (boxes: SupportData[]): RollerData[] => boxes.flatMap((box) => box.rows.flatMap((row) => row.rollers));

/** The pipe as a solid coloured by stress, in short pieces so that the painting order is correct. */
function addPipeBody(painter: Painter, lay: LayData, from: number, to: number, colour: StressColour): void {
  const step = 0.5; // m
  for (let s = from + step; s < to; s += step) {
    const ends: Pair = [toPicture(pipePoint(lay, s - step)), toPicture(pipePoint(lay, s))];
    const axis = unit(add(ends[1], ends[0], -1));
    const painted = colour(stationValue(lay, 'von_mises', s), stationValue(lay, 'yield_stress', s));
    addTube(painter, layers.things, ends, axis, lay.pipe_outer_diameter / 2, painted);
  }
}

/** The pipe as a line, with its shadow on the seabed. */
function addPipeLine(painter: Painter, lay: LayData, indices: number[], colour: StressColour): void {
  const points = indices.map((i) => toPicture(stationPoint(lay, i)));
  for (let k = 1; k < points.length; ++k) {
    const [a, b, i] = [points[k - 1]!, points[k]!, indices[k]!];
    const look: Look = { stroke: colour(lay.stations.von_mises[i]!, lay.stations.yield_stress[i]!), 'stroke-width': 3, 'stroke-linecap': 'round' };
    painter.addLine(a[2] + b[2] < 0 ? layers.under : layers.things, [a, b], look, 1e5);
  }
  const shadow = points.map((p): Vector => [p[0], p[1], seabedHeight(lay, p[0])]);
  painter.addLine(layers.bed, shadow, { stroke: '#a08f68', 'stroke-width': 1.2, 'stroke-dasharray': '5 3' }, 2e6);
}

export function wholeScene(lay: LayData, camera: Camera): SceneContent {
  const painter = new Painter(camera);
  const { vessel, supports, stations } = lay;
  const [keel, deck] = hullHeights(lay);
  const indices = stationsUpTo(lay, wholeEnd(lay));
  const bow = hullCorner(lay, 1, 0, 1, 0, 0)[0];
  const last = Math.max(...indices.map((i) => stations.x[i]!));
  const drift = Math.max(...indices.map((i) => Math.abs(stations.y[i]!)));
  const wide = Math.max(0.7 * vessel.beam, 1.4 * drift, 0.06 * (last - bow));
  addSea(painter, lay, bow - 10, last + 5, wide);
  addHull(painter, lay, [keel, 0], [layers.under, layers.under], 0.35);
  addHull(painter, lay, [0, deck], [layers.behind, layers.before], 0.35);
  for (const boxes of structures(supports)) {
    const layer = boxes[0]!.stinger ? layers.under : layers.things;
    for (const side of [-0.8, 0.8]) painter.addLine(layer, chordBelow(boxes, side, 0.4), { stroke: '#55636f', 'stroke-width': 1.6 });
  }
  for (const roller of allRollers(supports)) addRoller(painter, roller.p[2] < 0 ? layers.under : layers.things, roller);
  addPipeLine(painter, lay, indices, stressColour(lay));
  const high = toPicture(hullCorner(lay, 1, 0, 1, 0, deck));
  painter.addLabel(toPicture(lay.touchdown.p), 'touchdown', 0, -36);
  painter.addLabel(toPicture(lay.tensioner), 'tensioner', 24, -46);
  painter.addLabel(high, vessel.name, -6, -20);
  if (supports.some((box) => box.stinger)) painter.addLabel(toPicture(supports.at(-1)!.p), 'stinger', 50, -52);
  const corners = [bow - 10, last + 5].flatMap((x) => [-wide, wide].flatMap((y): Vector[] => [[x, y, seabedHeight(lay, x)], [x, y, 0]]));
  return { painter, fit: [...corners, toPicture(hullCorner(lay, 1, 1, 1, 0, deck))] };
}

/** Boxes with all rollers and the pipe; `before`, `after`: pipe beyond the boxes [m]. */
export function boxesScene(lay: LayData, camera: Camera, boxes: SupportData[], before: number, after: number): SceneContent {
  const painter = new Painter(camera);
  const all = boxes.length === lay.supports.length;
  const from = Math.max(0, Math.min(...boxes.map((box) => box.s - box.length / 2)) - before);
  const to = Math.min(wholeEnd(lay), Math.max(...boxes.map((box) => box.s + box.length / 2)) + after);
  if (all) addHull(painter, lay, hullHeights(lay), [layers.behind, layers.before], 0.1);
  addStructure(painter, all ? 1.1 : 1.8, boxes);
  for (const roller of allRollers(boxes)) addRoller(painter, layers.things, roller);
  addPipeBody(painter, lay, from, to, stressColour(lay));
  for (const box of boxes) painter.addLabel(toPicture(box.p), box.name, -12, 44, 'end', true);
  const fit = boxes.flatMap((box) => [add(box.p, [-box.length / 2, 1.5, -1]), add(box.p, [box.length / 2, -1.5, 1.5])]);
  return { painter, fit: [...fit, pipePoint(lay, from), pipePoint(lay, to)].map(toPicture) };
}
