// The tab of the operation on the line: its stages in a table, and a first operation where there is none.
import { bedHeight } from '../logic/bed';
import { firstOperation, type FirstOperation, type LaySize } from '../logic/firstOperation';
import { cell, columnsOf, columnUnit, stageColours, stageLevel, stageName, whyNot } from '../logic/operation';
import { bullets } from '../logic/findings';
import { fixedIn, unitName } from '../logic/show';
import type { Converged, Scene } from '../api/types';
import { calm, changes, failure, scene } from '../state/live';
import { leftTab } from '../state/look';
import { byPath, errors, revision, setKeys } from '../state/model';
import { say, sayError } from '../state/notices';
import { address } from '../api/client';
import { startRun } from '../state/runs';
import { chooseStage, chosenStage, hasOperation, operation, outdated, progress, solveOperation, solving } from '../state/operation';
import { ReportLinks } from './ReportLinks';
import { Findings } from './Findings';

const offers: [FirstOperation, string, string][] = [
  ['abandonment', 'Abandonment', 'A head closes the pipe and is lowered to the bed on a cable'],
  ['start_up', 'Start-up', 'The pipe leaves the barge, held by a cable from an anchor on the bed'],
  ['move', 'Move ahead', 'The barge moves ahead by a joint'],
];

/** Null where the lay of the model as it is written is not solved: an operation cannot be sized then. */
function laySize(lay: Converged | null, around: Scene | null): LaySize | null {
  const { key, touchdown, pipe } = lay ?? {};
  if (!lay || !around || !key || !touchdown || !pipe?.s.length || failure.value || changes.value.length || lay.revision !== revision.value) return null;
  const [x, y] = [pipe.x[0]!, pipe.y[0]!], reach = Math.hypot(touchdown.place[0] - x, touchdown.place[1] - y) || 1;
  const [ax, ay] = [(touchdown.place[0] - x) / reach, (touchdown.place[1] - y) / reach];
  const boxes = lay.supports.filter((b) => b.structure === 'stinger');
  return {
    joint: byPath.value.get('pipe.joint.length')?.si ?? 12, touchdown: touchdown.s, tip: boxes.length ? Math.max(...boxes.map((b) => b.s)) : 0.1 * touchdown.s,
    tension: key.top_tension, bottomTension: key.bottom_tension, height: pipe.z[0]!,
    depthAt: (distance) => -bedHeight(around.seabed, x + ax * distance, y + ay * distance),
  };
}

async function add(type: FirstOperation): Promise<void> {
  const lay = laySize(calm.value, scene.value);
  if (!lay) { say('No operation was added: it is sized by the lay of the model, which has no solution yet. Wait for the solution, correct the model, or apply or reset the values on the sliders.'); return; }
  try { await setKeys(firstOperation(type, lay)); } catch (error) { sayError(error); }
}

function Offer() {
  return (
    <div class="operation">
      <p>An operation on the line is a sequence of stages. Begin with one and change it in the form:</p>
      <ul class="offers">{offers.map(([type, name, words]) => <li key={type}><button type="button" onClick={() => void add(type)}>{name}</button> <small>{words}</small></li>)}</ul>
    </div>
  );
}

function Table() {
  const o = operation.value;
  if (!o) return null;
  const columns = columnsOf(o);
  return (
    <div class="scrolled">
      <table class={`stages${outdated.value ? ' old' : ''}`} aria-label="Stages of the operation">
        <thead><tr><th scope="col">stage</th>{columns.map((c) => <th key={c.name} scope="col" title={c.title}>{c.name}<small>{columnUnit(c) || '–'}</small></th>)}<th scope="col" title="Of the checks and findings of the stage">verdict</th></tr></thead>
        <tbody>
          {o.stages.map((s, i) => {
            const level = stageLevel(s), holds = o.hold_points.filter((h) => h.stage === i);
            return (
              <tr key={i} class={`${level}${chosenStage.value === i ? ' chosen' : ''}`} onClick={() => void chooseStage(chosenStage.value === i ? -1 : i)}>
                <th scope="row">
                  <button type="button" class="linkname" aria-pressed={chosenStage.value === i} disabled={!s.values} title={s.values ? `${s.values.check || 'Show this stage'}` : whyNot(s)}><i style={{ background: stageColours[level] }} />{stageName(s, i)}</button>
                  {holds.length ? <abbr class="hold" title={`Hold before this stage: ${holds.map((h) => `${h.what}${h.out === null ? '' : ` (at ${fixedIn(h.out, 'm', 1)} ${unitName('m')})`}`).join('; ')}`}>hold</abbr> : null}
                </th>
                {s.values ? columns.map((c) => <td key={c.name} title={c.name === 'use' ? s.values!.check : c.name === 'roller' ? s.values!.largest_reaction_support : c.title}>{cell(c, s)}</td>).concat(<td key="verdict" class="words">{s.values.verdict}</td>) : <td class="why" colSpan={columns.length + 1}><p>{whyNot(s)}</p></td>}
              </tr>
            );
          })}
        </tbody>
      </table>
    </div>
  );
}

function Holds() {
  const list = operation.value?.hold_points ?? [];
  if (list.length === 0) return null;
  return (
    <section class="holds" aria-label="Hold points">
      <h3>Hold points</h3>
      <ul>{list.map((h, i) => <li key={i}>before stage {h.stage + 1}: {h.what}{h.out === null ? '' : ` (at ${fixedIn(h.out, 'm', 1)} ${unitName('m')})`}</li>)}</ul>
    </section>
  );
}

export function OperationTab() {
  if (!hasOperation.value) return <Offer />;
  const p = progress.value, o = operation.value, inTime = byPath.value.get('analysis.dynamic')?.given === true;
  const findings = o ? bullets([...o.findings, ...o.stages.flatMap((s) => s.findings)], []) : [];
  return (
    <div class="operation">
      <div class="acts">
        <button type="button" class="main" disabled={solving.value || errors.value.length > 0} onClick={() => void solveOperation()}>{o ? 'Solve again' : 'Solve all stages'}</button>
        <button type="button" onClick={() => { leftTab.value = 'form'; }}>Keys in the form</button>
        {o ? <ReportLinks file={address('operation/report.html')} show={address('operation/report.html?show=1')} name="operation.html" title="Report of all stages, with the procedure sheet that goes on board" /> : null}
        {o && chosenStage.value >= 0 ? <button type="button" disabled={!inTime} title={inTime ? 'A dynamic run of the stage that is shown, as the model\'s analysis.dynamic says' : 'The model has no analysis.dynamic'} onClick={() => { leftTab.value = 'runs'; void startRun({ kind: 'dynamic', stage: String(chosenStage.value + 1) }); }}>Into the sea</button> : null}
      </div>
      {solving.value ? <div class="solving" role="status"><div class="bar"><i style={{ width: `${p ? (100 * p.done) / p.of : 0}%` }} /></div><small>{p ? `${p.done} of ${p.of} stages: ${p.name}` : 'solving…'}</small></div> : null}
      {errors.value.length > 0 ? <p class="fault">The model has errors; correct them first.</p> : null}
      {outdated.value && !solving.value ? <p class="note">The model has changed since these stages were solved.</p> : null}
      <Table />
      <Holds />
      <Findings list={findings} />
    </div>
  );
}
