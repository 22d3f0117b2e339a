// Runs of one model: told apart by their names, their reports printed.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
interface Printed { printed?: { title: string; drawn: boolean; charts: number; wide: number } }
beforeAll(async () => {
  bench = await start('first-model.yaml');
  page = await bench.open({ width: 1280, height: 720 }, async (p) => { await p.addInitScript(() => {
    window.print = () => { (window.top as unknown as Printed).printed = { title: document.title, drawn: document.documentElement.dataset.drawn === 'yes', charts: document.querySelectorAll('svg, canvas').length, wide: innerWidth }; };
  }); });
  await solved(page);
});
afterAll(async () => { await bench?.stop(); });

async function run(count: number): Promise<void> {
  await page.click('#tab-runs');
  await page.click('text=Static run with report');
  await expect.poll(() => page.locator('.run.done').count(), { timeout: 60_000 }).toBe(count);
}

test('two runs of the same title have names that differ, with what was changed', async () => {
  await run(1);
  expect(await page.locator('.runhead b').allInnerTexts()).toEqual(['My first lay']);
  await page.click('#tab-form');
  await page.fill('#f-tensioner\\.tension', '310 kN');
  await page.keyboard.press('Enter');
  await solved(page);
  await run(2);
  expect(await page.locator('.runhead b').allInnerTexts()).toEqual(['My first lay (2: tensioner.tension 310 kN)', 'My first lay (1)']);
  expect(await page.locator('section[aria-label="Results of the run"] h2').innerText()).toMatch(/My first lay \(2: tensioner\.tension 310 kN\)/);
  await bench.shot(page, 'runs-told-apart');
});

test('the report is printed with its figures drawn', async () => {
  await page.locator('.run').first().locator('text=PDF…').click();
  await expect.poll(() => page.evaluate(() => (window as unknown as Printed).printed), { timeout: 20_000 }).toMatchObject({ drawn: true, wide: 1000 });
  const printed = await page.evaluate(() => (window as unknown as Printed).printed!);
  expect(printed.title).toMatch(/My first lay/);
  expect(printed.charts).toBeGreaterThan(3);
});

test('nothing was complained about', () => expect(bench.complaints).toEqual([]));
