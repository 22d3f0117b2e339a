// The list of runs: filter, names and notes, comparison of two runs, their models, cancel, delete, rejected requests.
import { readFileSync } from 'node:fs';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;

interface Run { id: string; state: string; name: string; note: string; utilisation?: number }
const list = async (): Promise<Run[]> => (await bench.api('runs')).json() as Promise<Run[]>;
const order = async (body: object): Promise<string> => ((await (await bench.api('runs', { method: 'POST', body: JSON.stringify(body) })).json()) as { id: string }).id;
/** A poll of vitest cannot be used in `beforeAll`. */
async function ended(id: string): Promise<void> {
  for (;;) {
    if (/done|failed|cancelled/.test((await list()).find((r) => r.id === id)?.state ?? '')) return;
    await new Promise((next) => { setTimeout(next, 300); });
  }
}
const row = (id: string) => page.locator(`tr[data-run="${id}"]`);

async function set(path: string, value: string): Promise<void> {
  const { revision } = await (await bench.api('model')).json() as { revision: number };
  expect((await bench.api('model/set', { method: 'POST', body: JSON.stringify({ changes: [{ path, value }], revision }) })).status).toBe(200);
}

let first = '', second = '', third = '';
beforeAll(async () => {
  bench = await start('bgl1-workable-sea.yaml', { 'seed: 1': 'seed: 3' });
  page = await bench.open({ width: 1440, height: 900 });
  await solved(page);
  first = await order({ kind: 'dynamic', duration: 8 });
  await ended(first);
  await set('tensioner.tension', '255 kN');
  second = await order({ kind: 'dynamic', duration: 8 });
  third = await order({ kind: 'static' });
  await ended(third);
}, 300_000);
afterAll(async () => { await bench?.stop(); });

test('runs that have ended are marked in the header until the list is seen', async () => {
  await page.locator('#workspace-runs .dot.new').waitFor();
  await page.click('#workspace-runs');
  await expect.poll(() => page.locator('#workspace-runs .dot.new').count()).toBe(0);
  await expect.poll(() => page.locator('table.runlist tbody tr').count()).toBe(3);
});

test('the list is filtered and ordered', async () => {
  await page.selectOption('.runfilter [aria-label=kind]', 'static');
  await expect.poll(() => page.locator('table.runlist tbody tr').count()).toBe(1);
  await page.selectOption('.runfilter [aria-label=kind]', '');
  await page.fill('.runfilter input', '255');
  await expect.poll(() => page.locator('table.runlist tbody tr').count()).toBeLessThan(3);
  await page.click('.runfilter >> text=all');
  await page.click('table.runlist th >> text=kind');
  await expect.poll(() => page.locator('table.runlist tbody tr').last().innerText()).toMatch(/static/);
  await page.click('table.runlist th >> text=started');
});

test('a run is given a name and a note', async () => {
  await row(first).locator('td.name').click();
  await page.click('.runacts >> text=Rename');
  await page.fill('table.runlist [aria-label="Name of the run"]', 'Workable limit');
  await page.keyboard.press('Enter');
  await expect.poll(() => row(first).innerText()).toMatch(/Workable limit/);
  await page.click('#docktab-notes');
  await page.fill('[aria-label="Note on the run"]', 'for the client');
  await page.locator('.runnotes h3').click();
  await expect.poll(async () => (await list()).find((r) => r.id === first)?.note).toBe('for the client');
  expect((await list()).find((r) => r.id === first)?.name).toBe('Workable limit');
});

test('a note written while the name is pending is kept, and so is the name', async () => {
  let held = true;
  await page.route('**/annotate', async (r) => {
    if (held) { held = false; await new Promise((w) => setTimeout(w, 1000)); }
    await r.continue();
  });
  await page.fill('.runnotes [aria-label="Name of the run"]', 'Hs 2.5 m');
  await page.keyboard.press('Enter');
  await page.fill('[aria-label="Note on the run"]', 'as agreed');
  await page.locator('.runnotes h3').click();
  await expect.poll(async () => { const run = (await list()).find((r) => r.id === first); return `${run?.name}, ${run?.note}`; }).toBe('Hs 2.5 m, as agreed');
  await page.waitForTimeout(1000);  // for a text that would come later
  expect((await list()).find((r) => r.id === first)?.name).toBe('Hs 2.5 m');
  await page.unroute('**/annotate');
});

test('two runs stand side by side: keys of their models, results, diagrams', async () => {
  await row(second).locator('input[type=checkbox]').check();
  await page.click('#docktab-differences');
  const keys = page.locator('section[aria-label="Differences in the model"]'), results = page.locator('section[aria-label="Results"]');
  await expect.poll(() => results.innerText()).toMatch(/top tension, max/);
  if ((await bench.api(`runs/${first}/model`)).status === 200) {
    await expect.poll(() => keys.innerText()).toMatch(/tensioner\.tension\s+250 kN\s+255 kN/);
  }
  await expect.poll(() => results.locator('tr', { hasText: 'static top tension' }).innerText()).toMatch(/250\s+255 \+2 %/);
  await bench.shot(page, 'runs-differences');
  await page.click('#docktab-diagrams');
  await expect.poll(() => page.locator('.datadiagram').count()).toBe(3);
  await expect.poll(() => page.locator('.datadiagram .chartlegend').first().innerText()).toMatch(/Hs 2\.5 m/);
  const [file] = await Promise.all([page.waitForEvent('download'), page.locator('.datadiagram').first().locator('text=csv').click()]);
  expect(readFileSync(await file.path(), 'utf8')).toMatch(/^arc length/);
  await bench.shot(page, 'runs-diagrams');
});

test('a run is opened in its workspace, and its report is downloaded', async () => {
  await row(first).locator('td.name').click();
  const [file] = await Promise.all([page.waitForEvent('download'), page.click('.runacts >> text=Report')]);
  expect(readFileSync(await file.path(), 'utf8').length).toBeGreaterThan(50_000);
  await page.click('.runacts >> text=Open in Storm');
  await expect.poll(() => page.evaluate(() => location.hash)).toMatch(/storm/);
  await page.click('#workspace-runs');
});

test('a long run is followed and cancelled', async () => {
  const long = await order({ kind: 'dynamic', duration: 10800 });  // longer than the test, on any machine
  await row(long).locator('[role=progressbar]').waitFor({ timeout: 60_000 });
  await row(long).locator('td.name').click();
  await page.click('.runacts >> text=Cancel');
  await expect.poll(() => row(long).innerText(), { timeout: 30_000 }).toMatch(/cancelled/);
});

test('several runs are deleted at once, after confirmation', async () => {
  const all = await list();
  for (const run of all) if (run.id !== first && run.id !== third) await row(run.id).locator('input[type=checkbox]').check();
  await row(first).locator('input[type=checkbox]').uncheck();
  await page.click('.runacts >> text=Delete…');
  await expect.poll(() => page.locator('.sure').innerText()).toMatch(/Delete 2 runs/);
  await page.click('.sure >> text=Keep');
  expect((await list()).length).toBe(4);
  // pending reads of the run are awaited
  await page.route(`**/api/runs/${second}/series*`, async (slow) => { await new Promise((next) => { setTimeout(next, 1500); }); await slow.continue(); });
  await row(third).locator('td.name').click();
  await Promise.all([page.waitForRequest(`**/api/runs/${second}/series*`), row(second).locator('td.name').click()]);
  for (const run of all) if (run.id !== first && run.id !== third && run.id !== second) await row(run.id).locator('input[type=checkbox]').check();
  await page.click('.runacts >> text=Delete…');
  await page.click('.sure .danger');
  await expect.poll(async () => (await list()).length, { timeout: 10_000 }).toBe(2);
  await expect.poll(() => page.locator('table.runlist tbody tr').count()).toBe(2);
});

test('a failed run is marked in its row', async () => {
  await set('tensioner.tension', '2 kN');
  const failed = await order({ kind: 'static' });
  await ended(failed);
  await expect.poll(() => row(failed).innerText()).toMatch(/failed/);
  await row(failed).locator('td.name').click();
  await expect.poll(() => page.locator('.standing.bad').innerText()).toMatch(/This run failed\. .*tension is too low/);
  await bench.shot(page, 'failed-run');
});

test('a closed tab does not stop a run', async () => {
  await set('tensioner.tension', '250 kN');
  const id = await order({ kind: 'dynamic', duration: 5 });
  await page.context().close();
  await ended(id);
  expect((await list()).find((r) => r.id === id)?.state).toBe('done');
});

test('requests without the access token are rejected', async () => {
  const origin = { Origin: 'http://example.org' };
  expect((await bench.api('model', { headers: origin })).status).toBe(403);
  expect((await bench.api('model', { headers: { 'X-Overbend-Token': 'wrong' } })).status).toBe(401);
  expect((await bench.api('model', { method: 'PUT', body: JSON.stringify({ text: 'x'.repeat(3_000_000), revision: 1 }) })).status).toBe(413);
});

test('no errors were logged in the browser', () => expect(bench.complaints).toEqual([]));
