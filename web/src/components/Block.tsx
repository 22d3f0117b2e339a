// Draws the blocks of a report page, one component for each kind of block.
import { createContext, type ComponentType } from 'preact';
import { useContext } from 'preact/hooks';
import { CalculationSheet } from './CalculationSheet';
import type { BlockData } from './document';
import { Entries } from './Entries';
import { Folded } from './Folded';
import { Table } from './Table';
import { Tiles } from './Tile';

type BlockWithKind<Kind extends BlockData['kind']> = Extract<BlockData, { kind: Kind }>;
export type FigureBlock = BlockWithKind<'figure'>;

/** Drawing function and data of the figures on this page; without it no figure is drawn. */
export const FigureContext = createContext<ComponentType<{ figure: FigureBlock }>>(() => null);

function Figure({ figure }: { figure: FigureBlock }) {
  const Drawn = useContext(FigureContext);
  return <Drawn figure={figure} />;
}

function Section({ id, heading, body }: BlockWithKind<'section'>) {
  return (
    <section id={id}>
      <h2>{heading}</h2>
      <Blocks blocks={body} />
    </section>
  );
}

/** Ends with a link to a section of the page, or to the file of another report. */
function Paragraph({ text, link }: BlockWithKind<'paragraph'>) {
  if (!link) return <p>{text}</p>;
  const to = /[./]/.test(link.to) ? link.to : `#${link.to}`;
  return <p>{text.trimEnd()} <a href={to}>{link.text}</a></p>;
}

function List({ items, numbered }: BlockWithKind<'list'>) {
  const all = items.map((item) => <li>{item}</li>);
  return numbered ? <ol>{all}</ol> : <ul>{all}</ul>;
}

export function Block({ block }: { block: BlockData }) {
  switch (block.kind) {
    case 'section':
      return <Section {...block} />;
    case 'paragraph':
      return <Paragraph {...block} />;
    case 'remark':
      return <p class="small">{block.text}</p>;
    case 'subheading':
      return <h3>{block.text}</h3>;
    case 'list':
      return <List {...block} />;
    case 'folded':
      return <Folded summary={block.summary} printed={block.printed}><Blocks blocks={block.body} /></Folded>;
    case 'group':
      return <div class={block.look}><Blocks blocks={block.body} /></div>;
    case 'tiles':
      return <Tiles tiles={block.tiles} />;
    case 'entries':
      return <Entries entries={block.entries} framed />;
    case 'verbatim':
      return <pre>{block.text}</pre>;
    case 'figure':
      return <Figure figure={block} />;
    case 'sheet':
      return <CalculationSheet lines={block.lines} />;
    case 'table':
      return <Table table={block} />;
  }
}

export function Blocks({ blocks }: { blocks: BlockData[] }) {
  return <>{blocks.map((block) => <Block block={block} />)}</>;
}
