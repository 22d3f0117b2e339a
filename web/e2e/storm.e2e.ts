// The storm workspace, from a new model with the library hull: results during and after a run, its seeds,
// and results of a model that has changed since.
import { readFileSync } from 'node:fs';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { goTo, solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => {
  bench = await start();
  page = await bench.open({ width: 1440, height: 900 });
  await page.click('dialog button.main');
  await solved(page);
  await goTo(page, 'storm');
  await bench.shot(page, 'storm-new');
  await page.getByRole('button', { name: 'Set up a storm' }).click();
  await runButton().filter({ hasText: 'Run 3 h' }).waitFor();
  await bench.shot(page, 'storm-set');
  await runButton().click();
  await page.waitForSelector('.stormbar [role=progressbar]');
}, 90_000);
afterAll(async () => { await bench?.stop(); });

const text = async (): Promise<string> => (await (await bench.api('model')).json() as { text: string }).text;
interface ListedRun { id: string; parent: string; kind: string; state: string; has_results: boolean }
const runs = async (): Promise<ListedRun[]> => await (await bench.api('runs')).json() as ListedRun[];
const item = (label: string): ReturnType<Page['locator']> => page.locator('.stormstrip .valuebox', { has: page.locator(`.valuelabel:text-is("${label}")`) }).locator('> button');
const value = async (label: string): Promise<string> => (await item(label).innerText()).trim();
const runButton = (): ReturnType<Page['locator']> => page.locator('.stormacts button.main');
const ended = (): Promise<unknown> => page.waitForFunction(() => !document.querySelector('.stormbar [role=progressbar]'), undefined, { timeout: 180_000 });

/** Types a value into a field of a popover. */
async function type(label: string, field: string, typed: string): Promise<void> {
  await item(label).click();
  await page.locator('.valuepanel:popover-open').locator(field).fill(typed);
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => !document.querySelector('.valuepanel:popover-open'));
}

test('the library hull is named as an assumption, in the strip and in the file', async () => {
  await expect.poll(() => value('motion')).toBe('library hull');
  await expect.poll(() => page.locator('.stormstrip').innerText()).toMatch(/box hull of 120 × 30 m scaled from BGL-1: an assumption/);
  await expect.poll(() => text()).toMatch(/raos: box-hull-120x30m\.csv/);
  expect(readFileSync(`${bench.folder}/box-hull-120x30m.csv`, 'utf8')).toMatch(/^# Motion RAOs of a box hull.*\n# assumption: The vessel's motion response is that of the box barge/);
});

test('while it runs its histories grow, and it can be cancelled', async () => {
  try {
    await page.waitForFunction(() => document.querySelectorAll('.stormplots .u-wrap').length >= 2, undefined, { timeout: 150_000 });
    await expect.poll(() => page.locator('.stormbar').innerText()).toMatch(/\d+ %.* t = .* s/);
    await bench.shot(page, 'storm-running');
  } finally {
    // otherwise it would delay the later runs
    await page.locator('.stormbar').getByRole('button', { name: 'Cancel' }).click();
  }
  await ended();
}, 400_000);

test('waves, motion and duration are set in one undo step', async () => {
  await page.click('[aria-label="Undo"]');
  await expect.poll(text).not.toMatch(/jonswap|box-hull|duration/);
  await page.getByRole('button', { name: 'Set up a storm' }).waitFor();
  await page.click('[aria-label="Redo"]');
  await expect.poll(text).toMatch(/jonswap[\s\S]*box-hull/);
});

test('settings are changed in their popovers', async () => {
  await type('duration', '[id="f-analysis.dynamic.duration"]', '20 s');
  await expect.poll(() => value('duration')).toBe('20 s');
  await type('sea', '[id="f-environment.waves.hs"]', '3.5');
  await expect.poll(() => value('sea')).toBe('JONSWAP, Hs 3.5 m, Tp 8 s');
  await type('from', '[id="f-environment.waves.from"]', '135');
  await expect.poll(() => value('from')).toBe('135 deg, starboard bow');
  await item('motion').click();
  await page.waitForTimeout(300);
  await bench.shot(page, 'storm-motion');
  await page.keyboard.press('Escape');
  await item('tensioner').click();
  await page.getByRole('button', { name: /^Control within/ }).click();
  await expect.poll(() => value('tensioner')).toMatch(/^\d+ … \d+ kN$/);
  await page.keyboard.press('Escape');
  await expect.poll(() => text()).toMatch(/range: \[/);
});

test('a run goes to its end: histories, boxes, statistics, spectra and envelopes', async () => {
  await runButton().filter({ hasText: 'Run 20 s' }).click();
  await page.waitForSelector('.stormbar [role=progressbar]');
  await ended();
  await page.waitForFunction(() => document.querySelectorAll('.stormplots .u-wrap').length >= 2);
  await page.waitForTimeout(1500);
  await bench.shot(page, 'storm-done');
  for (const [tab, wait] of [['Boxes', '.stormtab td'], ['Statistics', '.stormtab td'], ['Extremes', '.stormtab'], ['Spectra', '.stormtab .u-wrap'], ['Envelopes', '.stormtab .u-wrap'], ['Checks', 'table.checks']] as const) {
    await page.click(`#docktab-${tab.toLowerCase()}`);
    await page.waitForSelector(wait);
    await page.waitForTimeout(700);
    await bench.shot(page, `storm-${tab.toLowerCase()}`);
  }
  await page.click('#docktab-statistics');
  const top = page.locator('.stormtab tr', { hasText: /^top tension/ });
  const id = (await runs()).find((run) => run.has_results && run.state === 'done')!.id;
  const { dynamic } = await (await bench.api(`runs/${id}/summary`)).json() as { dynamic: { top_tension: { max: number } } };
  expect(Number(await top.locator('td').nth(5).innerText())).toBeCloseTo(dynamic.top_tension.max / 1e3, 0);
}, 400_000);

test('a box chosen in the table becomes the selected object', async () => {
  await page.click('#docktab-boxes');
  await page.locator('.stormtab .linkname', { hasText: 'stinger 2' }).click();
  await page.waitForFunction(() => decodeURI(location.hash) === '#/storm/supports.stinger.boxes[1]');
  await expect.poll(() => page.locator('.stormsplit select').inputValue()).toBe('reaction');
});

test('the spectrum of a history has its variance', async () => {
  const id = (await runs()).find((run) => run.state === 'done')!.id;
  const spectrum = await (await bench.api(`runs/${id}/spectrum?name=heave`)).json() as { frequency: number[]; density: number[]; std: number };
  const variance = spectrum.density.reduce((sum, d) => sum + d, 0) * spectrum.frequency[1]!;
  expect(spectrum.std).toBeGreaterThan(0);
  expect(variance).toBeGreaterThan(0.2 * spectrum.std ** 2);
  expect(variance).toBeLessThan(3 * spectrum.std ** 2);
});

test('results before a change of the model are marked, until it is undone', async () => {
  await expect.poll(() => page.locator('.stormbar .stalebadge').count()).toBe(0);
  await type('sea', '[id="f-environment.waves.tp"]', '9');
  await expect.poll(() => page.locator('.stormbar .stalebadge').allInnerTexts()).toEqual([expect.stringMatching(/environment\.waves\.tp 9 s/)]);
  await bench.shot(page, 'storm-stale');
  await page.click('[aria-label="Undo"]');
  await expect.poll(() => page.locator('.stormbar .stalebadge').count()).toBe(0);
});

test('the next run says how long it will take', async () => {
  await expect.poll(() => runButton().innerText()).toMatch(/^Run 20 s, about \d+ (s|min)$/);
});

test('seeds are shown one by one, and together', async () => {
  await type('seeds', '#storm-seeds', '3');
  await runButton().filter({ hasText: 'Run 3 × 20 s' }).click();
  await page.waitForSelector('.stormbar [role=progressbar]');
  await page.waitForTimeout(1000);
  await bench.shot(page, 'storm-seeds-running');
  await ended();
  const seeds = page.locator('[aria-label="Seed shown"]');
  await expect.poll(() => seeds.locator('option').allInnerTexts()).toEqual(['seed 1 of 3', 'seed 2 of 3', 'seed 3 of 3']);
  await seeds.selectOption({ label: 'seed 2 of 3' });
  await page.click('#docktab-statistics');
  await page.locator('.stormtab thead', { hasText: 'over 3 seeds' }).waitFor();
  await bench.shot(page, 'storm-seeds');
  await page.getByRole('button', { name: 'this seed' }).click();
  await page.locator('.stormtab tr', { hasText: /^top tension/ }).waitFor();
}, 400_000);

test('tensioner modes are compared from the same place', async () => {
  await page.selectOption('[aria-label="Type of run"]', 'tensioner');
  await runButton().filter({ hasText: 'Compare tensioner modes, 20 s' }).click();
  await page.waitForSelector('.stormbar [role=progressbar]');
  await ended();
  await expect.poll(() => page.locator('[aria-label="Variant shown"] option').count(), { timeout: 20_000 }).toBe(3);
  await page.getByRole('button', { name: 'all variants' }).click();
  await expect.poll(() => page.locator('.stormtab thead').innerText()).toMatch(/Off, held by its brake\s+Controlled\s+Constant/);
}, 400_000);

test('the workspace fits on smaller screens and in the dark', async () => {
  await page.selectOption('[aria-label="Type of run"]', 'storm');
  await page.click('#docktab-histories');
  await page.setViewportSize({ width: 1024, height: 768 });
  await page.evaluate(() => { document.documentElement.dataset.theme = 'dark'; });
  await page.waitForTimeout(1200);
  await expect.poll(() => page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
  await bench.shot(page, 'storm-dark-1024');
  await page.click('#docktab-boxes');
  await page.waitForTimeout(600);
  await bench.shot(page, 'storm-dark-boxes');
});

test('no errors were logged in the browser', () => expect(bench.complaints).toEqual([]));
