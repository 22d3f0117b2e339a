// The lay table of the open model: tension, lay-back or depth in steps, its rows, curves and downloads.
import { effect, signal } from '@preact/signals';
import { useState } from 'preact/hooks';
import { ApiError, address, post } from '../api/client';
import type { LayTable, LayTableAnswer, LayTableVary } from '../api/types';
import { LayTableCharts } from '../components/LayTableCharts';
import { Table } from '../components/Table';
import { layRows, rangeOf, usualRange, wishFault, type LayTableWish } from '../logic/laytable';
import { withTwin } from '../logic/show';
import { bullets } from '../logic/findings';
import { byPath, opened, revision } from '../state/model';
import { calmLay } from '../state/shown';
import { Findings } from './Findings';

/** The last one, with the revision of the model that it is of. */
const table = signal<{ of: LayTable; revision: number } | null>(null);
const wish = signal<LayTableWish | null>(null);

// Another model: neither its table nor its range.
effect(() => { void opened.value; table.value = null; wish.value = null; });

const usual = (vary: LayTableVary): LayTableWish => usualRange(vary, calmLay.value?.key ?? null, byPath.value.get('environment.water_depth')?.si ?? null);

/** In the colours of the page, light or dark. */
const look = { curves: ['var(--pipe)', '#e07b1a'], limit: 'var(--bad)', passing: 'var(--range)' };

function Made({ of }: { of: LayTable }) {
  return (
    <>
      <div class="acts">
        <a class="button" href={address('lay-table.csv')} download="lay-table.csv">Table (CSV)</a>
        <a class="button" href={address('lay-table.xlsx')} download="lay-table.xlsx">Workbook (XLSX)</a>
      </div>
      <Findings list={bullets(of.findings, [])} />
      <Table table={layRows(of)} sortable copyable numberTitle={(number, { unit }) => withTwin(number, unit)} />
      <p class="brief">{of.curves.axis}; shaded where the lay passes.</p>
      <div class="laycurves drawn"><LayTableCharts table={of.curves} look={look} width={340} /></div>
    </>
  );
}

export function LayTablePanel() {
  const [busy, setBusy] = useState(false);
  const [refused, setRefused] = useState('');
  const now = wish.value ?? usual('tension');
  const fault = wishFault(now);
  const set = (part: Partial<LayTableWish>): void => { setRefused(''); wish.value = { ...now, ...part }; };
  const make = async (): Promise<void> => {
    setBusy(true);
    setRefused('');
    try {
      const asked = revision.value, model = opened.value;
      const answer = await post<LayTableAnswer>('lay-table', { vary: now.vary, range: rangeOf(now) });
      if (model !== opened.value) return;
      if (answer.status === 'ok') table.value = { of: answer, revision: asked };
      else setRefused(answer.diagnostics[0]?.message ?? 'the model has errors');
    } catch (error) {
      setRefused(error instanceof ApiError ? error.message : String(error));
    } finally {
      setBusy(false);
    }
  };
  const field = (key: 'from' | 'to' | 'steps') => (
    <div class="row wide"><label for={`lt-${key}`}>{key}</label><input id={`lt-${key}`} value={now[key]} autocomplete="off" onInput={(e) => set({ [key]: e.currentTarget.value })} /></div>
  );
  return (
    <section aria-label="Lay table of the model">
      <form class="spread" onSubmit={(e) => { e.preventDefault(); if (!fault && !busy) void make(); }}>
        <div class="row wide">
          <label for="lt-vary">over</label>
          <select id="lt-vary" value={now.vary} onChange={(e) => { setRefused(''); wish.value = usual(e.currentTarget.value as LayTableVary); }}>
            <option value="tension">tension</option><option value="lay_back">lay-back</option><option value="depth">water depth</option>
          </select>
        </div>
        {field('from')}{field('to')}{field('steps')}
        {refused || fault ? <p class="fault" role="alert">{refused || fault}</p> : null}
        <footer><button type="submit" class="main" disabled={busy || fault !== null}>{busy ? 'Making the table…' : 'Make table'}</button></footer>
      </form>
      {table.value ? <>{table.value.revision === revision.value ? null : <p class="brief">Of the model as it was before the last change.</p>}<Made of={table.value.of} /></> : null}
    </section>
  );
}
