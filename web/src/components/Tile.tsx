// Key figures in large print.
import type { TileData } from './document';

/** Characters in large print that fit into a tile. */
const room = 9;

export function Tile({ tile }: { tile: TileData }) {
  return (
    <div class={tile.over ? 'tile over' : 'tile'}>
      <div class="name">{tile.name}</div>
      <div class={tile.value.length > room ? 'value long' : 'value'}>{tile.value} <span>{tile.unit}</span></div>
      <div class="note">{tile.note}</div>
    </div>
  );
}

export function Tiles({ tiles }: { tiles: TileData[] }) {
  return <div class="tiles">{tiles.map((tile) => <Tile tile={tile} />)}</div>;
}
