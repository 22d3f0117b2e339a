// The picture: the 3-D view or a drawing, with views, legend, values of the selected object, caption and tools.
import { useEffect, useRef } from 'preact/hooks';
import type { ViewName } from '../logic/views';
import { roundTrip } from '../state/live';
import { dialog } from '../state/look';
import { hasModel } from '../state/model';
import { mode, ruler } from '../state/picture';
import { calmLay, shownFailure } from '../state/shown';
import { Caption } from './picture/Caption';
import { Failure } from './picture/Failure';
import { Legend } from './picture/Legend';
import { PlanDrawing } from './picture/PlanDrawing';
import { SectionDrawing } from './picture/SectionDrawing';
import { SideDrawing } from './picture/side/SideDrawing';
import { Tools } from './picture/Tools';
import { useClear } from './picture/useClear';
import { useView3D } from './picture/useView3D';
import { Values } from './picture/Values';
import { ViewButtons, viewKey } from './picture/ViewButtons';
import { Whose } from './picture/Whose';
import '../styles/picture.css';

const debug = new URLSearchParams(location.search).has('debug');

/** For measurements: the address with &debug. */
function Speed() {
  return <span class="speed" title="Time from request to solution">{roundTrip.value ? `${Math.round(roundTrip.value)} ms` : ''}</span>;
}

function Welcome() {
  if (hasModel.value) return null;
  return (
    <div class="welcome">
      <h2>New pipelay model</h2>
      <p>Answer a few questions to see the first lay, or open an example.</p>
      <button type="button" class="main" onClick={() => { dialog.value = 'start'; }}>New model…</button>
    </div>
  );
}

const drawings = { side: SideDrawing, section: SectionDrawing, plan: PlanDrawing };

export function Picture() {
  const box = useRef<HTMLElement>(null), canvas = useRef<HTMLDivElement>(null);
  const { view, ready, problem } = useView3D(canvas);
  useClear(box, view, ready);
  const go = (name: ViewName): void => view.current?.go(name);
  const shown = mode.value, Drawing = shown === '3d' ? null : drawings[shown];
  const lay = calmLay.value, laid = lay === null || lay.pipe.s.length > 0;
  useEffect(() => {
    const end = (e: KeyboardEvent): void => { if (e.key === 'Escape' && ruler.value && !e.defaultPrevented) ruler.value = null; };
    addEventListener('keydown', end);
    return () => removeEventListener('keydown', end);
  }, []);
  const keys = (e: KeyboardEvent): void => {
    if (e.target instanceof HTMLInputElement || e.target instanceof HTMLSelectElement || e.ctrlKey || e.metaKey || e.altKey) return;
    viewKey(e.key, go);
  };
  return (
    <section ref={box} class={`picture of-${shown}${shownFailure.value ? ' failed' : ''}${ruler.value ? ' measuring' : ''}`} aria-label="Picture" onKeyDown={keys}>
      <div class="canvas" ref={canvas} tabIndex={0} role="img" aria-label="Barge, stinger, pipe, moorings, water and seabed. Keys 1 to 9 change the view." />
      {Drawing ? <Drawing /> : null}
      <ViewButtons ready={ready} go={go} />
      {laid && (shown === '3d' || shown === 'side') ? <Legend /> : null}
      <Whose />
      {shown === '3d' || shown === 'side' ? <Values /> : null}
      <div class="lower">
        <Failure />
        <Caption />
      </div>
      {lay ? <Tools box={box} view={view} /> : null}
      {problem && shown === '3d' ? <p class="failure">{problem}</p> : null}
      <Welcome />
      {debug ? <Speed /> : null}
    </section>
  );
}
