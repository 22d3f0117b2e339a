// A three-dimensional picture that is rotated with the pointer, drawn as SVG.
import type { ComponentChildren, JSX } from 'preact';
import { useId, useMemo, useRef, useState } from 'preact/hooks';
import { ticks } from './chart/scale';
import { textWidth } from './chart/text';
import { aboveLimit, paperScale } from './colourScale';
import type { SceneContent } from './layScene';
import { Camera, fitInto, placeLabels, type Piece, type Place, type PlacedLabel } from './painter';

const width = 960;
const margin = { left: 20, right: 20, top: 74, bottom: 64 };
const labelSize = 13;

function PaintedPiece({ piece, place }: { piece: Piece; place: Place }) {
  const points = piece.seen.map((p) => place(p).map((v) => v.toFixed(1)).join(' ')).join('L');
  return <path d={`M${points}${piece.closed ? 'Z' : ''}`} {...piece.look} />;
}

function PaintedLabel({ placed: { label, x, y, dy } }: { placed: PlacedLabel }) {
  const leader = Math.hypot(label.dx, dy) > 24;
  return (
    <g>
      {leader ? <line x1={x} y1={y} x2={x + 0.85 * label.dx} y2={y + 0.85 * dy} stroke="#5b6b7a" stroke-width="0.8" /> : null}
      <text class="halo" x={x + label.dx} y={y + dy + 4} text-anchor={label.anchor} style={{ fontSize: `${labelSize}px` }}>{label.text}</text>
    </g>
  );
}

/** Azimuth and elevation that follow the pointer, at most once a frame. */
function useRotation(azimuth: number, elevation: number) {
  const [angles, setAngles] = useState({ azimuth, elevation });
  const dragged = useRef({ x: 0, y: 0, active: false, waiting: false, azimuth, elevation });
  const onPointerDown = (event: JSX.TargetedPointerEvent<SVGSVGElement>): void => {
    event.currentTarget.setPointerCapture(event.pointerId);
    Object.assign(dragged.current, { x: event.clientX, y: event.clientY, active: true });
  };
  const onPointerMove = (event: JSX.TargetedPointerEvent<SVGSVGElement>): void => {
    const state = dragged.current;
    if (!state.active) return;
    state.azimuth -= (event.clientX - state.x) * 0.008;
    state.elevation = Math.min(1.5, Math.max(0.05, state.elevation + (event.clientY - state.y) * 0.006));
    Object.assign(state, { x: event.clientX, y: event.clientY });
    if (state.waiting) return;
    state.waiting = true;
    requestAnimationFrame(() => {
      state.waiting = false;
      setAngles({ azimuth: state.azimuth, elevation: state.elevation });
    });
  };
  const stop = (): void => { dragged.current.active = false; };
  const onMouseDown = (event: MouseEvent): void => event.preventDefault(); // dragging does not select text
  return { angles, handlers: { onMouseDown, onPointerDown, onPointerMove, onPointerUp: stop, onPointerCancel: stop } };
}

interface SceneProps {
  title: string;
  height: number;
  /** Initial camera angles [rad]. */
  azimuth: number;
  elevation: number;
  build: (camera: Camera) => SceneContent;
  /** Legend of the colours, at the lower left. */
  children?: ComponentChildren;
}

export function Scene({ title, height, azimuth, elevation, build, children }: SceneProps) {
  const { angles, handlers } = useRotation(azimuth, elevation);
  const clip = useId();
  const painted = useMemo(() => {
    const camera = new Camera(angles.azimuth, angles.elevation);
    const { painter, fit } = build(camera);
    const place = fitInto(fit.map((p) => camera.project(p)), width, height, margin);
    const labels = placeLabels(painter.labels, place, (text) => textWidth(text, labelSize), height - margin.bottom + 8);
    return { pieces: painter.sortedPieces(), place, labels };
  }, [angles, build, height]);
  return (
    <>
      <svg viewBox={`0 0 ${width} ${height}`} class="drawing rotatable" role="img" aria-label={title} {...handlers}>
        <clipPath id={clip}><rect y={32} width={width} height={height - 32} /></clipPath>
        <rect width={width} height={height} fill="#fff" />
        <g clip-path={`url(#${clip})`}>
          {painted.pieces.map((piece, i) => <PaintedPiece key={i} piece={piece} place={painted.place} />)}
          {painted.labels.map((placed, i) => <PaintedLabel key={i} placed={placed} />)}
        </g>
        <text class="title" x={16} y={20}>{title}</text>
        <g transform={`translate(16,${height - 34})`}>{children}</g>
      </svg>
      <div class="hint">drag to rotate</div>
    </>
  );
}

/** A label next to a block of its colour. */
function KeyEntry({ x, colour, text }: { x: number; colour: string; text: string }) {
  return (
    <g transform={`translate(${x},-3)`}>
      <rect width={14} height={14} fill={colour} />
      <text x={20} y={12}>{text}</text>
    </g>
  );
}

const scaleWidth = 220;

interface ColourKeyProps {
  title: string;
  /** Maximum of the scale, in the unit shown. */
  top: number;
  /** Label of the colour beyond the scale. */
  beyond: string | null;
  entries: { colour: string; text: string }[];
}

/** Colour scale of the pipe, and legend of the other colours. */
export function ColourKey({ title, top, beyond, entries }: ColourKeyProps) {
  const gradient = useId();
  const list = beyond ? [{ colour: aboveLimit, text: beyond }, ...entries] : entries;
  let x = Math.max(scaleWidth, textWidth(title)) + 40;
  return (
    <>
      <linearGradient id={gradient}>
        {Array.from({ length: 11 }, (_, k) => <stop key={k} offset={k / 10} stop-color={paperScale(k / 10)} />)}
      </linearGradient>
      <text y={-7}>{title}</text>
      <rect width={scaleWidth} height={10} fill={`url(#${gradient})`} />
      {ticks(0, top, 4).map((value) => (
        <g key={value} class="tick" transform={`translate(${scaleWidth * value / top},10)`}>
          <line y2={4} />
          <text y={17} text-anchor="middle">{value}</text>
        </g>
      ))}
      {list.map((entry) => {
        const left = x;
        x += textWidth(entry.text) + 44;
        return <KeyEntry key={entry.text} x={left} {...entry} />;
      })}
    </>
  );
}
