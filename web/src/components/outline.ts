// Sections of a report for its contents, and numbers of its figures.
import type { BlockData } from './document';

type Section = Extract<BlockData, { kind: 'section' }>;
type FigureBlock = Extract<BlockData, { kind: 'figure' }>;

function* inOrder(blocks: BlockData[]): Generator<BlockData> {
  for (const block of blocks) {
    yield block;
    if ('body' in block) yield* inOrder(block.body);
  }
}

/** Sections in order, including nested ones. */
export function sections(blocks: BlockData[]): Section[] {
  return [...inOrder(blocks)].filter((block) => block.kind === 'section');
}

/** Figure numbers, counted over the whole page. */
export function figureNumbers(blocks: BlockData[]): Map<FigureBlock, number> {
  const figures = [...inOrder(blocks)].filter((block) => block.kind === 'figure');
  return new Map(figures.map((figure, i) => [figure, i + 1]));
}
