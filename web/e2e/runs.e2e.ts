// Runs in time: to the end and animated, report, cancel, and what the program refuses.
import { readFileSync } from 'node:fs';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('bgl1-workable-sea.yaml', { 'seed: 1': 'seed: 3' }); page = await bench.open(); await solved(page); await page.click('#tab-runs'); });
afterAll(async () => { await bench?.stop(); });

const id = async (): Promise<string> => (await (await bench.api('runs')).json() as { id: string }[])[0]!.id;

test('a run goes to its end', async () => {
  await page.fill('#run-duration', '20 s');
  await page.click('text=Start run');
  await page.waitForSelector('.run.done', { timeout: 150_000 });
});

test('it is animated', async () => {
  await page.waitForSelector('.animation');
  await page.click('[aria-label=Play]');
  const clock = async (): Promise<number> => Number.parseFloat(await page.locator('.clock').innerText());
  const first = await clock();
  await expect.poll(clock).not.toBe(first);
  await page.click('[aria-label=Pause]');
  await page.click('.viewbuttons >> text=overbend');
  await page.selectOption('[aria-label="Diagram 1"]', 'von_mises');
  await page.selectOption('[aria-label="Diagram 2"]', 'history:top_tension');
  await page.waitForTimeout(1500);
  await bench.shot(page, 'animation');
});

test('impacts light up, the tensioner says what it does, boxes have the colour of their reaction', async () => {
  const runs = await (await bench.api('runs')).json() as { id: string; state: string }[];
  const { impacts } = await (await bench.api(`runs/${runs[0]!.id}/impacts`)).json() as { impacts: { time: number }[] };
  expect(impacts.length).toBeGreaterThan(0);
  const hardest = impacts.find((i) => i.time > 0 && i.time < 19)!;
  await page.locator('[aria-label=Time]').evaluate((el, t) => { const input = el as HTMLInputElement; input.value = String(t); input.dispatchEvent(new Event('input', { bubbles: true })); }, Math.ceil((hardest.time + 0.05) * 20) / 20);
  await page.waitForFunction(() => Number((document.querySelector('.legend') as HTMLElement).dataset.flashes) > 0);
  expect(await page.evaluate(() => (window as unknown as { __view: { stage: { flashGroup: { children: unknown[] } } } }).__view.stage.flashGroup.children.length)).toBeGreaterThan(0);
  expect(await page.locator('.readings').innerText()).toMatch(/tensioner (holds|waiting for its delay|pays out|hauls in|at its limit)/);
  expect(await page.locator('.readings').innerText()).toMatch(/travel\s+-?[\d.]+ m/);
  expect(await page.locator('.rollerkey').innerText()).toMatch(/box, to [\d.]+ kN/);
  await page.selectOption('[aria-label="Diagram 2"]', 'history:tensioner/tension');
  await page.waitForTimeout(800);
  await bench.shot(page, 'impact');
});

test('what frames do not hold cannot be chosen while they are shown', async () => {
  const closed = await page.locator('[aria-label="Colour of the pipe"] option:disabled').allInnerTexts();
  expect(closed.join()).toMatch(/Bending stress.*Strain.*Utilisation/);
});

test('the checks are those of the run', async () => {
  const panel = page.locator('section[aria-label="Code checks"]');
  expect(await panel.locator('h2').innerText()).toMatch(/of the run/);
  await panel.locator('summary').click();
  expect(await panel.locator('tr', { hasText: 'Laying criterion II' }).innerText()).toMatch(/0\.\d+\s+(passed|exceeded)/);
  await panel.locator('summary').click();
});

test('the pane is that of the run: static beside least and greatest, whatever becomes of the model', async () => {
  const pane = page.locator('section[aria-label="Results of the run"]');
  expect(await pane.locator('thead').innerText()).toMatch(/static\s+min\s+max/);
  const [before, least, most] = (await pane.locator('tr', { hasText: /^top/ }).locator('td').allInnerTexts()).map(Number);
  const { dynamic } = await (await bench.api(`runs/${await id()}/summary`)).json() as { dynamic: { top_tension: { min: number; max: number } } };
  expect(before).toBe(250);
  expect(Math.abs(least! - dynamic.top_tension.min / 1e3)).toBeLessThan(0.6);
  expect(Math.abs(most! - dynamic.top_tension.max / 1e3)).toBeLessThan(0.6);
  expect(await page.locator('section[aria-label="Key results"], section[aria-label="Try out"]').count()).toBe(0);
  const { revision } = await (await bench.api('model')).json() as { revision: number };
  await bench.api('model/set', { method: 'POST', body: JSON.stringify({ changes: [{ path: 'tensioner.tension', value: '255 kN' }], revision }) });
  await page.waitForTimeout(600);
  expect(await pane.locator('tr', { hasText: /^top/ }).locator('td').first().innerText()).toBe('250');
  await bench.shot(page, 'run-pane');
});

test('the sea of the picture is that of the run', async () => {
  const { waves, stern_shoe: at } = await (await bench.api(`runs/${await id()}/scene`)).json() as { waves: { amplitude: number; number: number; frequency: number; phase: number; direction: number }[]; stern_shoe: number[] };
  const shown = await page.evaluate(() => (window as unknown as { __view: { stage: { sea: { waves: { phase: number }[] } } } }).__view.stage.sea.waves);
  expect(shown).toEqual(waves);
  const { t, min } = await (await bench.api(`runs/${await id()}/series?name=elevation&t0=0&px=1000`)).json() as { t: number[]; min: number[] };
  expect(t.length).toBeGreaterThan(30);
  t.forEach((time, i) => {
    const drawn = waves.reduce((sum, w) => sum + w.amplitude * Math.cos(w.number * (at[0]! * Math.cos(w.direction) + at[1]! * Math.sin(w.direction)) - w.frequency * time + w.phase), 0);
    expect(drawn).toBeCloseTo(min[i]!, 3);
  });
});

test('a run is given a name and a note', async () => {
  await page.fill('[aria-label="Name of the run"]', 'Workable limit');
  await page.keyboard.press('Enter');
  await page.fill('[aria-label="Note on the run"]', 'for the client');
  await page.locator('.startrun h3').click();
  await page.waitForFunction(() => document.querySelector('section[aria-label="Results of the run"] .note')?.textContent === 'for the client');
  expect(await page.locator('.runhead b').first().innerText()).toBe('Workable limit');
});

test('a note that is written while the name is still on its way is kept, and so is the name', async () => {
  let first = true;
  await page.route('**/annotate', async (r) => {
    if (first) { first = false; await new Promise((w) => setTimeout(w, 1000)); }
    await r.continue();
  });
  await page.fill('[aria-label="Name of the run"]', 'Hs 2.5 m');
  await page.keyboard.press('Enter');
  await page.fill('[aria-label="Note on the run"]', 'as agreed');
  await page.locator('.startrun h3').click();
  await page.waitForFunction(() => document.querySelector('section[aria-label="Results of the run"] .note')?.textContent === 'as agreed');
  await page.waitForTimeout(1000);  // for words that would come after
  const kept = (await (await bench.api('runs')).json() as { id: string; name: string; note: string }[]).find((r) => r.note === 'as agreed');
  expect(kept?.name).toBe('Hs 2.5 m');
  await page.unroute('**/annotate');
});

test('the report is downloaded', async () => {
  const [file] = await Promise.all([page.waitForEvent('download'), page.click('.run >> text=Report')]);
  const text = readFileSync(await file.path(), 'utf8');
  expect(text).toMatch(/<html/i);
  expect(text.length).toBeGreaterThan(50_000);
});

test('diagrams go out as CSV and SVG', async () => {
  for (const [kind, like] of [['csv', /^arc length/], ['svg', /^<svg/]] as const) {
    const [file] = await Promise.all([page.waitForEvent('download'), page.locator('.slot').first().locator(`text=${kind}`).click()]);
    expect(readFileSync(await file.path(), 'utf8')).toMatch(like);
  }
});

let liveTension = NaN;  // kN, read during the run that is cancelled

test('values are live during a long run, until it is cancelled', async () => {
  await page.fill('#run-duration', '3 h');  // longer than the test, however fast the machine
  await page.click('text=Start run');
  const run = page.locator('.run.running');
  await run.locator('.livevalues').waitFor({ timeout: 60_000 });
  const before = Number(await run.locator('[role=progressbar]').getAttribute('aria-valuenow'));
  expect(await run.locator('.brief').nth(1).innerText()).toMatch(/%/);
  await page.waitForFunction((least) => Number(document.querySelector('.run.running [role=progressbar]')?.getAttribute('aria-valuenow') ?? 100) > least, before);
  await bench.shot(page, 'live-values');
  await page.waitForFunction(() => /t = [1-9]/.test(document.querySelector('.run.running')?.textContent ?? ''), undefined, { timeout: 120_000 });
  liveTension = Number.parseFloat(await run.locator('.kv', { hasText: 'top tension' }).locator('dd').innerText());
  await run.locator('text=Cancel').click();
  await page.waitForSelector('.run.cancelled', { timeout: 30_000 });
});

test('what was computed before the cancel is shown and animated, and the tension seen live is within it', async () => {
  const pane = page.locator('section[aria-label="Results of the run"]');
  await pane.locator('table.minmax').waitFor();
  expect(await pane.innerText()).toMatch(/Cancelled\. Results of the first [\d.]+ s are shown/);
  const [least, greatest] = (await pane.locator('table.minmax tr', { has: page.locator('th', { hasText: /^top/ }) }).locator('td').allInnerTexts()).slice(1).map(Number);
  expect(liveTension).toBeGreaterThanOrEqual(least! - 0.1);  // as rounded
  expect(liveTension).toBeLessThanOrEqual(greatest! + 0.1);
  await page.waitForSelector('.animation');
  expect(await page.locator('.run.cancelled >> text=Report').count()).toBe(1);
  await bench.shot(page, 'cancelled');
});

test('a run is removed, when that is said twice', async () => {
  await page.click('.run.chosen >> text=Delete…');
  await page.click('.run.chosen >> text=Delete with all files');
  await page.waitForFunction(() => document.querySelectorAll('.run').length === 1);
  await page.waitForSelector('section[aria-label="Key results"]'); // back at the model
});

test('a run is cancelled', async () => {
  await page.fill('#run-duration', '3 h');
  await page.click('text=Start run');
  await page.waitForSelector('.run.running');
  await page.waitForTimeout(1000);
  await page.click('.run >> text=Cancel');
  await page.waitForSelector('.run.cancelled', { timeout: 30_000 });
});

test('a run that fails is not shown with statics in green', async () => {
  const { revision } = await (await bench.api('model')).json() as { revision: number };
  await bench.api('model/set', { method: 'POST', body: JSON.stringify({ changes: [{ path: 'tensioner.tension', value: '2 kN' }], revision }) });
  if (await page.locator('.back').count()) await page.click('.back');
  await page.waitForSelector('.failure');
  await page.click('text=Static run with report');
  await page.waitForSelector('.run.failed', { timeout: 60_000 });
  expect(await page.locator('.standing.bad').innerText()).toMatch(/This run failed\. .*tension is too low/);
  expect(await page.locator('.right .region').count()).toBe(0);
  await bench.shot(page, 'failed-run');
});

test('a closed tab does not stop a run', async () => {
  const { revision } = await (await bench.api('model')).json() as { revision: number };
  await bench.api('model/set', { method: 'POST', body: JSON.stringify({ changes: [{ path: 'tensioner.tension', value: '250 kN' }], revision }) });
  const { id } = await (await bench.api('runs', { method: 'POST', body: JSON.stringify({ kind: 'dynamic', duration: 5 }) })).json() as { id: string };
  await page.context().close();
  for (let i = 0; i < 200; ++i) {
    const list = await (await bench.api('runs')).json() as { id: string; state: string }[];
    const run = list.find((r) => r.id === id)!;
    if (run.state === 'done') return;
    expect(['queued', 'running']).toContain(run.state);
    await new Promise((r) => setTimeout(r, 500));
  }
  throw new Error('not done in time');
});

test('strangers are refused', async () => {
  const origin = { Origin: 'http://example.org' };
  expect((await bench.api('model', { headers: origin })).status).toBe(403);
  expect((await bench.api('model', { headers: { 'X-Overbend-Token': 'wrong' } })).status).toBe(401);
  expect((await bench.api('model', { method: 'PUT', body: JSON.stringify({ text: 'x'.repeat(3_000_000), revision: 1 }) })).status).toBe(413);
});

test('nothing was complained about', () => expect(bench.complaints).toEqual([]));
