// The line at all stages of an operation in one figure. A stage under the pointer or selected below the figure is highlighted
// in every panel.
import type { VNode } from 'preact';
import { useMemo } from 'preact/hooks';
import { Chart } from '../../components/Chart';
import type { Pixel } from '../../components/chart/labels';
import { linePath } from '../../components/chart/marks';
import { extent, interpolate, type Range } from '../../components/chart/scale';
import type { Frame, LegendEntry } from '../../components/chart/types';
import { colours } from '../../components/colours';
import { useHighlighted } from '../../components/highlight';
import { Sea, elevationAxes, polygonIn } from '../../components/SideView';
import { useUnits } from '../../components/units';
import type { StageData, StageLine, StagesData } from '../data';
import type { FigureProps } from '../figures';
import { describeStage, stageHighlight, solvedStages, stageColour, readStages } from './stageList';

type Place = readonly [number, number];

const lineLooks = {
  pipe: { width: 1.9, dash: undefined },
  head: { width: 6, dash: undefined },
  cable: { width: 1.4, dash: '6 3' },
};

/** Relative to the ground, a stage is shifted by the advance of the vessel. */
const linePlaces = (stage: StageData, { points }: StageLine, part: string): Place[] => points.map(([x, z]) => [part === 'ground' ? x - stage.ahead : x, z]);

const toPixels = (frame: Frame, places: readonly Place[]): Pixel[] => places.map(([x, z]) => [frame.x(x), frame.y(z)]);

interface DrawnStage { index: number; colour: string; runs: { kind: StageLine['of']; pixels: Pixel[] }[] }

function drawStages(stages: StagesData, part: string, frame: Frame): DrawnStage[] {
  return solvedStages(stages).map((index) => {
    const stage = stages.list[index]!;
    const runs = stage.line!.map((run) => ({ kind: run.of, pixels: toPixels(frame, linePlaces(stage, run, part)) }));
    return { index, colour: stageColour(stages, index), runs };
  });
}

function Surroundings({ frame, stages, part }: { frame: Frame; stages: StagesData; part: string }): VNode {
  const [x0, x1] = frame.x.domain;
  const [xs, zs] = [stages.bed.map((p) => p[0]), stages.bed.map((p) => p[1])];
  const height = (x: number): number => (xs.length > 1 ? interpolate(xs, zs, x) : zs[0]!);
  const places = xs.length > 0 ? [x0, ...xs.filter((x) => x > x0 && x < x1), x1] : [];
  const fromVessel = part !== 'ground';
  return (
    <g>
      <Sea frame={frame} bed={places.map((x) => [x, height(x)] as const)} hull={fromVessel ? stages.hull : []} />
      {fromVessel && <Supports frame={frame} stages={stages} near={part === 'supports'} />}
    </g>
  );
}

function Supports({ frame, stages: { supports }, near }: { frame: Frame; stages: StagesData; near: boolean }): VNode {
  const groups = [false, true].map((stinger) => supports.filter((box) => box.stinger === stinger).flatMap((box) => box.rows));
  return (
    <g>
      {groups.filter((rows) => rows.length > 1).map((rows) => (
        <polyline points={polygonIn(frame, rows)} fill="none" stroke={colours.zero} stroke-width={near ? 2 : 3} />
      ))}
      {near && groups.flat().map(([x, z]) => <circle cx={frame.x(x)} cy={frame.y(z)} r="3" fill="#fff" stroke="#3d4a56" />)}
    </g>
  );
}

function StagePath({ stage, heads, faint }: { stage: DrawnStage; heads: boolean; faint: boolean }): VNode {
  const runs = stage.runs.filter(({ kind }) => (kind === 'head') === heads);
  return (
    <g fill="none" stroke-linejoin="round" opacity={faint ? 0.22 : 1}>
      {heads && runs.map(({ pixels }) => <path d={linePath(pixels)} stroke="#fff" stroke-width={lineLooks.head.width + 2} />)}
      {runs.map(({ kind, pixels }) => (
        <path
          d={linePath(pixels)}
          stroke={stage.colour}
          stroke-width={lineLooks[kind].width}
          stroke-dasharray={lineLooks[kind].dash}
          stroke-linecap={kind === 'cable' ? 'round' : 'butt'}
        />
      ))}
    </g>
  );
}

/** Lines of all stages, with the heads above them; the highlighted stage is on top of the others, which are faint. */
function StageShapes({ stages, part, frame }: { stages: StagesData; part: string; frame: Frame }): VNode {
  const current = useHighlighted(stageHighlight(stages));
  const drawn = useMemo(() => drawStages(stages, part, frame), [stages, part, frame]);
  const shown = drawn.some((stage) => stage.index === current) ? current : null;
  const sorted = [...drawn].sort((a, b) => Number(a.index === shown) - Number(b.index === shown));
  return (
    <g>
      {[false, true].map((heads) => sorted.map((stage) => (
        <StagePath key={`${stage.index}${heads}`} stage={stage} heads={heads} faint={shown !== null && stage.index !== shown} />
      )))}
    </g>
  );
}

/** Stage numbers next to the heads, if they fit. */
function HeadNumbers({ frame, stages, part }: { frame: Frame; stages: StagesData; part: string }): VNode {
  const taken: Pixel[] = [];
  const numbers = drawStages(stages, part, frame).flatMap(({ index, colour, runs }) => {
    const head = runs.find(({ kind }) => kind === 'head')?.pixels;
    const [x, y] = head?.[Math.floor(head.length / 2)] ?? [-1, -1];
    if (x < frame.left + 8 || x > frame.right - 8 || y > frame.bottom) return [];
    if (taken.some((p) => Math.abs(p[0] - x) < 17 && Math.abs(p[1] - y) < 14)) return [];
    taken.push([x, y]);
    return [<text class="halo mark" x={x + 9} y={y - 8} style={{ fontSize: '12px', fill: colour }}>{index + 1}</text>];
  });
  return <g text-anchor="middle">{numbers}</g>;
}

/** Distance of a point from a polyline in pixels. */
function distanceTo(pixels: readonly Pixel[], [x, y]: Pixel): number {
  let least = Infinity;
  for (let k = 1; k < pixels.length; ++k) {
    const [[ax, ay], [bx, by]] = [pixels[k - 1]!, pixels[k]!];
    const [dx, dy] = [bx - ax, by - ay];
    const t = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
    least = Math.min(least, Math.hypot(x - ax - t * dx, y - ay - t * dy));
  }
  return least;
}

const reach = 14; // reach of the pointer [px]

/** The stage whose line passes nearest to a pixel. */
function nearestStage(stages: StagesData, part: string, frame: Frame, pixel: Pixel): number | null {
  const distances = drawStages(stages, part, frame).map(({ index, runs }) => ({ index, far: Math.min(...runs.map((run) => distanceTo(run.pixels, pixel))) }));
  const nearest = distances.reduce((best, stage) => (stage.far < best.far ? stage : best), { index: -1, far: reach });
  return nearest.index < 0 ? null : nearest.index;
}

/** Every stage with its colour, for selection; and the values of the highlighted one. */
function StageKeys({ stages }: { stages: StagesData }): VNode {
  const units = useUnits();
  const highlight = stageHighlight(stages);
  const current = useHighlighted(highlight);
  return (
    <>
      <div class="stage-keys">
        {stages.list.map(({ name, line }, i) => (
          <button
            key={i}
            type="button"
            aria-pressed={i === current}
            disabled={!line}
            title={describeStage(stages, i, units)}
            onClick={() => highlight.choose(i)}
            onPointerEnter={() => line && highlight.point(i)}
            onPointerLeave={() => highlight.point(null)}
          >
            <i style={{ background: line ? stageColour(stages, i) : 'none' }} />
            <span>{line ? name : `${name}: no solution`}</span>
          </button>
        ))}
      </div>
      <p class="stage-values">{current === null ? 'Point at a line or select a stage to see its values.' : describeStage(stages, current, units)}</p>
    </>
  );
}

/** Extent of a panel: distances and heights. */
function findRanges(stages: StagesData, part: string): { x: Range; z: Range } {
  const all = solvedStages(stages).flatMap((i) => stages.list[i]!.line!.flatMap((run) => linePlaces(stages.list[i]!, run, part)));
  const [x, z] = [extent(all.map((p) => p[0])), extent(all.map((p) => p[1]))];
  if (part === 'supports') {
    const rows = stages.supports.flatMap((box) => box.rows);
    const first = rows[0]![0];
    const [x0, x1] = extent([...rows, ...all.filter((p) => p[0] < first)].map((p) => p[0]));
    const near: Range = [Math.max(x0, first - 15) - 1, x1 + 0.35 * (x1 - x0)];
    const inside = all.filter((p) => p[0] >= near[0] && p[0] <= near[1]);
    return { x: near, z: extent([...rows, ...inside].map((p) => p[1])) };
  }
  if (part === 'ground') return { x, z };
  const { hull, bed } = stages;
  return {
    x: [Math.min(x[0], ...hull.map((p) => p[0])), x[1]],
    z: [Math.min(z[0], ...bed.map((p) => p[1])), Math.max(z[1], 0, ...hull.map((p) => p[1]))],
  };
}

const titles: Record<string, string> = {
  whole: 'Relative to the vessel (true to scale)',
  supports: 'Ramp and stinger (heights enlarged)',
  ground: 'Relative to the ground: origin at the vessel position of the first stage (true to scale)',
};

const lineLegend: LegendEntry[] = (['pipe', 'head', 'cable'] as const).map((text) => ({ text, colour: '#41505e', ...lineLooks[text] }));

export function Stages({ part, data }: FigureProps): VNode {
  const stages = readStages(data);
  const highlight = stageHighlight(stages);
  const { x, z } = findRanges(stages, part);
  const room = 0.06 * (z[1] - z[0] || 1);
  const cable = stages.list.some(({ line }) => line?.some((run) => run.of === 'cable'));
  const onPointer = (pixel: Pixel | null, frame: Frame, click: boolean): void => {
    const nearest = pixel && nearestStage(stages, part, frame, pixel);
    if (!click) highlight.point(nearest);
    else if (nearest !== null) highlight.choose(nearest);
  };
  return (
    <>
      <Chart
        title={titles[part]}
        equal={part !== 'supports'}
        height={360}
        maxHeight={460}
        x={{
          si: 'm',
          label: `X, astern of the stern shoe${part === 'ground' ? ' at the first stage' : ''}`,
          range: [x[0], x[1] + 0.01 * (x[1] - x[0])],
        }}
        y={{ ...elevationAxes.y, range: [z[0] - room, z[1] + 1.4 * room] }}
        legend={cable ? lineLegend : undefined}
        inside={(frame) => (
          <g>
            <Surroundings frame={frame} stages={stages} part={part} />
            <StageShapes frame={frame} stages={stages} part={part} />
          </g>
        )}
        onPointer={onPointer}
      >
        {(frame) => <HeadNumbers frame={frame} stages={stages} part={part} />}
      </Chart>
      {part === 'whole' && <StageKeys stages={stages} />}
    </>
  );
}
