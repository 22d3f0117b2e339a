// Calculation of a check: formulas, substituted numbers and their origin.
import type { ComponentChild } from 'preact';
import type { SheetLine } from './document';
import { formulaPieces, type Piece } from './formula';

function setPiece(piece: Piece): ComponentChild {
  if (piece.kind === 'index') return <sub>{piece.text}</sub>;
  if (piece.kind === 'power') return <sup>{piece.pieces.map(setPiece)}</sup>;
  return piece.text;
}

/** A symbol or formula in the program's notation, with Greek letters, subscripts and powers. */
export function Formula({ text }: { text: string }) {
  return <>{formulaPieces(text).map(setPiece)}</>;
}

function Line({ line }: { line: SheetLine }) {
  return (
    <tr class={line.soft ? 'soft' : undefined}>
      <td class="t"><Formula text={line.symbol} /></td>
      <td class="t">{line.meaning}</td>
      <td class="t"><Formula text={line.formula} /></td>
      <td class="t">{line.numbers}</td>
      <td>{line.value}</td>
      <td class="t">{line.origin}</td>
      <td class="t">{line.confirmed}</td>
    </tr>
  );
}

export function CalculationSheet({ lines }: { lines: SheetLine[] }) {
  return (
    <div class="table">
      <table class="dense sheet">
        <thead>
          <tr>
            <th class="t">Symbol</th>
            <th class="t">Meaning</th>
            <th class="t">Formula</th>
            <th class="t">Substitution</th>
            <th>Value</th>
            <th class="t">Clause or source</th>
            <th class="t">Confirmed by</th>
          </tr>
        </thead>
        <tbody>
          {lines.map((line) => <Line line={line} />)}
        </tbody>
      </table>
    </div>
  );
}
