// Runs of one model: distinguished by name, with printed reports.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { goTo, openField, runToEnd, solved, start, type Bench } from './harness';

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

const names = (): Promise<string[]> => page.locator('table.runlist td.name span').allInnerTexts();

test('two runs of the same title have names that differ, with what was changed', async () => {
  await runToEnd(bench, { kind: 'static' });
  await goTo(page, 'runs');
  await expect.poll(names).toEqual(['My first lay']);
  await (await openField(page, 'tensioner.tension')).fill('310 kN');
  await page.keyboard.press('Enter');
  await expect.poll(async () => (await (await bench.api('model')).json() as { text: string }).text).toMatch(/tension: 310 kN/);
  const id = await runToEnd(bench, { kind: 'static' });
  await expect.poll(names).toEqual(['My first lay (2: tensioner.tension 310 kN)', 'My first lay (1)']);
  await page.locator(`tr[data-run="${id}"]`).click();
  await expect.poll(() => page.locator('.right h3').first().innerText()).toMatch(/My first lay \(2: tensioner\.tension 310 kN\)/);
  await bench.shot(page, 'runs-told-apart');
});

test('the report is printed with its figures drawn', async () => {
  await page.locator('.runacts >> text=PDF…').click();
  await expect.poll(() => page.evaluate(() => (window as unknown as Printed).printed), { timeout: 20_000 }).toMatchObject({ drawn: true, wide: 1000 });
  const printed = await page.evaluate(() => (window as unknown as Printed).printed!);
  expect(printed.title).toMatch(/My first lay/);
  expect(printed.charts).toBeGreaterThan(3);
});

test('no errors were logged in the browser', () => expect(bench.complaints).toEqual([]));
