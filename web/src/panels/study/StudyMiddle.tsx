// Middle of the study workspace: the table or drawing of the study, and the selected case.
import { signal } from '@preact/signals';
import { hasModel } from '../../state/model';
import { bullets } from '../../logic/findings';
import { depthLimits } from '../../logic/layGrid';
import { baseCase, tally } from '../../logic/studies';
import { casesTable, tensionTable } from '../../logic/studyTables';
import { Table } from '../../components/Table';
import { chosenCase, fixed, layTable, limits, matrix, outdated, output, pictureShown, shownRun, studies } from '../../state/studies';
import { Findings } from '../Findings';
import { CaseCurve, CaseMap, CaseSwings, marksText } from './CaseDrawing';
import { CaseGrid, GridKey } from './CaseGrid';
import { ChosenCase } from './ChosenCase';
import { Gathered } from './Gathered';
import { LayRows } from './LayRows';
import { Limits } from './Limits';
import { Files, Progress, ResultChoice, StudyChoice } from './MiddleHead';
import { axes, cells, chooseCell, heldAxes, isLayGrid, openCell, shape } from './shown';
import { useCasePicture } from './picture';

/** Larger grids are drawn as a map. */
const kReadable = 600;
const asMap = signal<boolean | null>(null);
const drawsMap = (): boolean => asMap.value ?? cells.value.flat().length > kReadable;

function HeldKeys() {
  const m = matrix.value!;
  return (
    <>
      {heldAxes.value.map((a) => (
        <label key={a} class="heldkey">
          {m.inputs[a]!.key}{' '}
          <select value={fixed.value[a] ?? 0} onChange={(e) => { fixed.value = { ...fixed.value, [a]: Number(e.currentTarget.value) }; }}>
            {m.inputs[a]!.words.map((word, i) => <option key={i} value={i}>{word}</option>)}
          </select>
        </label>
      ))}
    </>
  );
}

function Tensions() {
  const m = matrix.value!, [x, y] = axes.value as [number, number], { utilisation, clearance, reserved } = limits.value;
  const keeps = [`utilisation up to ${utilisation}`, ...(clearance === null ? [] : [`tip clearance from ${clearance}`]), reserved ? 'reservations count as passing' : 'reservations do not count as passing'];
  const list = depthLimits(m, x, y, fixed.value, limits.value);
  return (
    <section aria-label="Permissible tensions">
      <h3>Permissible tensions <small>{keeps.join(', ')}; ≤ and ≥ mark limits of the table; values between two tensions are interpolated if the same check governs at both{list.some(({ gap }) => gap) ? '; * not for every tension in between' : ''}</small></h3>
      <Table table={{ ...tensionTable(m, axes.value, list), title: '' }} sortable copyable file="tensions" />
    </section>
  );
}

function GridView() {
  const m = matrix.value!, drawn = { m, axes: axes.value, cells: cells.value, output: output.value, chosen: chosenCase.value, choose: chooseCell };
  return (
    <>
      {drawsMap() ? <div class="matrix drawn"><CaseMap {...drawn} /><p class="brief">Cells {marksText(cells.value)}.</p></div> : <><CaseGrid {...drawn} open={openCell} /><GridKey m={m} cells={cells.value} /></>}
      {isLayGrid.value ? <Tensions /> : null}
    </>
  );
}

function MatrixView() {
  const m = matrix.value!, base = baseCase(m);
  if (m.operability) return <Limits of={m.operability} />;
  if (m.cases.length === 0) return <p class="empty">No cases yet.</p>;
  if (base) return <div class="matrix drawn"><CaseSwings m={m} base={base} output={output.value} /></div>;
  if (shape.value === 'grid') return <GridView />;
  if (shape.value === 'curve') return <div class="matrix drawn"><CaseCurve m={m} axes={axes.value} cells={cells.value} output={output.value} chosen={chosenCase.value} choose={chooseCell} width={760} /></div>;
  return <Table table={casesTable(m)} sortable copyable rowAction={(name) => ({ act: () => { chosenCase.value = Number(name); }, title: 'Show this case', chosen: name === String(chosenCase.value) })} />;
}

function Head() {
  const m = matrix.value, run = shownRun.value, grid = shape.value === 'grid';
  return (
    <header class="studyhead">
      {m && !m.operability ? <ResultChoice /> : <h2>{m ? 'Operability' : run ? 'Study' : layTable.value ? 'Lay table' : 'Studies'}</h2>}
      {grid ? <div class="switch" role="group" aria-label="View"><button type="button" aria-pressed={!drawsMap()} onClick={() => { asMap.value = false; }}>table</button><button type="button" aria-pressed={drawsMap()} onClick={() => { asMap.value = true; }}>map</button></div> : null}
      {m ? <HeldKeys /> : null}
      <span class="grow" />
      <StudyChoice />
      <button type="button" aria-pressed={pictureShown.value} onClick={() => { pictureShown.value = !pictureShown.value; }} title="Picture of the lay, or of the selected case if its keys can be tried out">Picture</button>
    </header>
  );
}

function Shown() {
  const m = matrix.value, run = shownRun.value;
  if (run && run.kind !== 'study') return <Gathered run={run} />;
  if (m) return <MatrixView />;
  if (run) return run.state === 'running' || run.has_results ? <p class="empty">Loading …</p> : null;
  if (layTable.value) return <LayRows of={layTable.value.of} />;
  return (
    <p class="empty">
      {hasModel.value ? 'No results yet. Select the keys to vary above, then solve.' : 'No model yet.'}
      {studies.value.length ? ' Earlier studies of this folder can be chosen at the top right.' : ''}
    </p>
  );
}

export function StudyMiddle() {
  useCasePicture();
  const m = matrix.value, run = shownRun.value, findings = m ? m.findings : run ? [] : layTable.value?.of.findings ?? [];
  return (
    <section class="studymiddle" aria-label="Results of the study">
      <Head />
      {run ? <Progress run={run} /> : null}
      {outdated.value ? <p class="note">The model has changed since: solve again.</p> : null}
      <div class="studyfiles">
        <p class="brief standing" role="status">{m?.cases.length ? tally(m) : ''}{m && shape.value === 'grid' ? '; click a cell to show its case, double-click to open it in Lay' : ''}</p>
        <Files />
      </div>
      {run?.note ? <p class="note">{run.note}</p> : null}
      <div class="studybody">
        <div class="studyshown"><Shown /><Findings list={bullets(findings, [])} /></div>
        <ChosenCase />
      </div>
    </section>
  );
}
