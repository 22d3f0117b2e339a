import { render } from 'preact';
import './style.css';
import './components/chart.css';
import { App } from './panels/App';
import { startAnimation } from './state/animation';
import { connect } from './state/connection';
import { startLive } from './state/live';
import { dialog, startLook } from './state/look';
import { startMoorings } from './state/moorings';
import { startOffsets } from './state/offsets';
import { startOperation } from './state/operation';
import { guardLeaving, hasModel, start } from './state/model';
import { fetchRuns, startRuns } from './state/runs';
import { startStudies } from './state/studies';

startLook();
guardLeaving();
startLive();
startAnimation();
startRuns();
startStudies();
startMoorings();
startOffsets();
startOperation();
render(<App />, document.getElementById('page')!);
void start().then(() => { if (!hasModel.value) dialog.value = 'start'; });
void fetchRuns();
connect();

// For tests and screenshots: the first picture has been drawn.
requestAnimationFrame(() => requestAnimationFrame(() => { (window as unknown as { __ready: boolean }).__ready = true; }));
