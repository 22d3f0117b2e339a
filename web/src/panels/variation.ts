// Variation of the number of a field with live statics: by dragging its label, or with the arrow keys in it.
import { useComputed } from '@preact/signals';
import { useMemo, useRef } from 'preact/hooks';
import type { Field } from '../api/types';
import { gridStep, keyVariable, onStep, pace, paceFactor, variableStep, variableText, type Variable } from '../logic/variables';
import { applyLive, setLive, values } from '../state/live';
import { byPath } from '../state/model';

/** Smaller movements count as a click [px]. */
const slack = 3;

interface Drag { x: number; si: number; before: number | undefined }

export interface Variation {
  /** The trial value as it would be written; null if there is none. */
  text: string | null;
  /** True if the field has a number to vary. */
  able: boolean;
  label: {
    onPointerDown: (event: PointerEvent) => void;
    onPointerMove: (event: PointerEvent) => void;
    onPointerUp: (event: PointerEvent) => void;
    onPointerCancel: () => void;
    onClick: (event: MouseEvent) => void;
  };
  /** Handles an arrow key; false for any other. */
  key: (event: KeyboardEvent) => boolean;
  /** Writes a value varied with keys into the model; false if there is none. `any`: any trial value. */
  commit: (any?: boolean) => boolean;
  /** Resets to the value of the model; false if nothing was varied. */
  cancel: () => boolean;
}

export function useVariation(field: Field): Variation {
  const path = field.path;
  const variable = useMemo<Variable | null>(() => keyVariable(field, byPath.value), [field]);
  const live = useComputed(() => values.value[path]).value;
  const drag = useRef<Drag | null>(null);
  const dragged = useRef(false);
  const varied = useRef(false);

  const current = (): number => values.peek()[path] ?? variable!.si;
  const abandon = (): void => {
    if (!drag.current) return;
    setLive(path, drag.current.before);
    end();
  };
  const escape = (event: KeyboardEvent): void => { if (event.key === 'Escape') { event.stopPropagation(); abandon(); } };
  const escapeHandler = useRef(escape);
  const end = (): void => { drag.current = null; removeEventListener('keydown', escapeHandler.current, true); };

  const label: Variation['label'] = {
    onPointerDown: (event) => {
      dragged.current = false;
      if (!variable || event.button !== 0) return;
      (event.currentTarget as Element).setPointerCapture(event.pointerId);
      drag.current = { x: event.clientX, si: current(), before: values.peek()[path] };
      escapeHandler.current = escape;
      addEventListener('keydown', escape, true);
    },
    onPointerMove: (event) => {
      const d = drag.current;
      if (!d || !variable) return;
      const pixels = event.clientX - d.x;
      if (pixels === 0 || (!dragged.current && Math.abs(pixels) < slack)) return;
      d.x = event.clientX;
      dragged.current = true;
      const step = variableStep(variable) * paceFactor[pace(event)];
      d.si += pixels * step * variable.scale;
      setLive(path, onStep(variable, d.si, gridStep(variable, event)));
    },
    onPointerUp: () => {
      if (!drag.current) return;
      end();
      if (dragged.current) void applyLive(path);
    },
    onPointerCancel: abandon,
    // the end of a drag is not a click, which would focus the field
    onClick: (event) => { if (dragged.current) event.preventDefault(); },
  };

  const key = (event: KeyboardEvent): boolean => {
    const direction = event.key === 'ArrowUp' ? 1 : event.key === 'ArrowDown' ? -1 : 0;
    if (!variable || direction === 0) return false;
    event.preventDefault();
    varied.current = true;
    const step = variableStep(variable) * paceFactor[pace(event)];
    setLive(path, onStep(variable, current() + direction * step * variable.scale, gridStep(variable, event)));
    return true;
  };
  const commit = (any = false): boolean => {
    if (!varied.current && !(any && live !== undefined)) return false;
    varied.current = false;
    void applyLive(path);
    return true;
  };
  const cancel = (): boolean => {
    if (live === undefined) return false;
    varied.current = false;
    setLive(path, undefined);
    return true;
  };

  return { text: live === undefined || !variable ? null : variableText(variable, live, 7), able: variable !== null, label, key, commit, cancel };
}
