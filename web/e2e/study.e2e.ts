// Several seeds and a comparison, from the page: started, seen on the way, cancelled and resumed, their tables and their cases.
import { readFileSync } from 'node:fs';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('bgl1-tensioner.yaml', { 'build_up: 60 s': 'build_up: 6 s' }); page = await bench.open(); await solved(page); await page.click('#tab-runs'); });
afterAll(async () => { await bench?.stop(); });

const pane = (): ReturnType<Page['locator']> => page.locator('section[aria-label="Results of the study"]');
const numbers = async (text: RegExp): Promise<number[]> => (await pane().locator('tbody', { hasText: text }).first().locator('td').allInnerTexts()).map(Number);

test('several seeds are started, cancelled and resumed', async () => {
  await page.selectOption('#run-kind', 'seeds');
  await page.fill('#run-seeds', '2-2');
  expect(await page.locator('.startrun .main').isDisabled()).toBe(true);
  await page.fill('#run-seeds', '1-2');
  await page.fill('#run-duration', '3 h');  // longer than the test, however fast the machine
  await page.click('text=Start run');
  for (const next of ['text=Resume', 'text=Delete…']) {
    await page.waitForFunction(() => Number(document.querySelector('.run.running [role=progressbar]')?.getAttribute('aria-valuenow') ?? -1) >= 0 && document.querySelector('.cases .running'));
    await bench.shot(page, 'study-running');
    await page.locator('.run.running').getByRole('button', { name: 'Cancel', exact: true }).click();
    await page.waitForSelector('.run.cancelled', { timeout: 60_000 });
    await page.click(`.run.cancelled >> ${next}`);
  }
  await page.click('text=Delete with all files');
  await page.waitForFunction(() => document.querySelectorAll('.run').length === 0);
});

test('several seeds go to their end', async () => {
  await page.fill('#run-duration', '4 s');
  await page.click('text=Start run');
  await page.waitForSelector('.run.done', { timeout: 150_000 });
});

test('the table over the seeds is that of the cases', async () => {
  await pane().locator('table.study').waitFor();
  expect(await pane().locator('thead').innerText()).toMatch(/mean\s+std\s+min\s+max/);
  const [mean, , least, most] = await numbers(/^Largest effective tension/);
  const runs = await (await bench.api('runs')).json() as { id: string; parent: string }[];
  const largest = await Promise.all(runs.filter((r) => r.parent).map(async (r) => (await (await bench.api(`runs/${r.id}/summary`)).json() as { dynamic: { top_tension: { max: number } } }).dynamic.top_tension.max / 1e3));
  expect(largest.length).toBe(2);
  expect(Math.abs(least! - Math.min(...largest))).toBeLessThan(0.06);
  expect(Math.abs(most! - Math.max(...largest))).toBeLessThan(0.06);
  expect(Math.abs(mean! - (largest[0]! + largest[1]!) / 2)).toBeLessThan(0.06);
  await bench.shot(page, 'study-seeds');
});

test('a case of it is a run that can be looked at', async () => {
  await page.click('.cases >> text=Seed 2');
  await page.waitForSelector('.animation');
  const own = page.locator('section[aria-label="Results of the run"]');
  await own.locator('table.minmax').waitFor();
  expect(await own.innerText()).toMatch(/seed 2,/);
  await page.click('text=Back to the study');
  await pane().locator('table.study').waitFor();
});

test('modes of the tensioner are compared, with a page to keep', async () => {
  await page.selectOption('#run-kind', 'tensioner');
  await page.fill('#run-duration', '4 s');
  await page.click('text=Start run');
  await page.waitForFunction(() => document.querySelectorAll('.run.done').length === 2, undefined, { timeout: 150_000 });
  await pane().locator('table.study').waitFor();
  expect(await pane().locator('thead').innerText()).toMatch(/off\s+controlled\s+constant/);
  const [off, , constant] = await numbers(/^Standard deviation of the tension/);
  expect(off!).toBeGreaterThan(1);
  expect(constant!).toBeLessThan(0.01 * off!);
  const [file] = await Promise.all([page.waitForEvent('download'), pane().locator('text=Comparison page').click()]);
  expect(readFileSync(await file.path(), 'utf8')).toMatch(/compared_tensioner/);
  const [table] = await Promise.all([page.waitForEvent('download'), pane().locator('text=Table (CSV)').click()]);
  expect(readFileSync(await table.path(), 'utf8')).toMatch(/^quantity/);
  for (const [name, width, height] of [['large', 1920, 1080], ['usual', 1280, 720], ['phone', 390, 844]] as const) {
    await page.setViewportSize({ width, height });
    if (width < 1100) await page.click('.panes >> text=Results');
    await expect.poll(() => pane().evaluate((el) => el.scrollWidth - el.clientWidth), { message: `the table fits on ${name}` }).toBeLessThanOrEqual(1);
    await bench.shot(page, `study-comparison-${name}`);
  }
  await page.setViewportSize({ width: 1280, height: 720 });
});

test('a study is removed with its cases', async () => {
  for (let left = 1; left >= 0; --left) {
    await page.locator('.run .runhead').first().click();
    if (await page.locator('.run.chosen >> text=Delete…').count() === 0) await page.locator('.run .runhead').first().click();
    await page.click('.run.chosen >> text=Delete…');
    await page.click('.run.chosen >> text=Delete with all files');
    await page.waitForFunction((n) => document.querySelectorAll('.run').length === n, left);
  }
  expect(await (await bench.api('runs')).json()).toEqual([]);
});

test('nothing was complained about', () => expect(bench.complaints).toEqual([]));
