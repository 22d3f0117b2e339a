// What a report contains, for its contents and the numbers of its figures.
import type { BlockData } from './document';

type Section = Extract<BlockData, { kind: 'section' }>;
type FigureBlock = Extract<BlockData, { kind: 'figure' }>;

function* inOrder(blocks: BlockData[]): Generator<BlockData> {
  for (const block of blocks) {
    yield block;
    if ('body' in block) yield* inOrder(block.body);
  }
}

/** Sections in their order, those within others too. */
export function sections(blocks: BlockData[]): Section[] {
  return [...inOrder(blocks)].filter((block) => block.kind === 'section');
}

/** Numbers of the figures, counted over the whole page. */
export function figureNumbers(blocks: BlockData[]): Map<FigureBlock, number> {
  const figures = [...inOrder(blocks)].filter((block) => block.kind === 'figure');
  return new Map(figures.map((figure, i) => [figure, i + 1]));
}
