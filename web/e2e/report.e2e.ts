// The report in its workspace: created, previewed, partly printed, marked as outdated when the model has changed.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { goTo, solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
interface Printed { printed?: { shown: string[]; paper: string } }
beforeAll(async () => {
  bench = await start('first-model.yaml');
  page = await bench.open({ width: 1440, height: 900 }, async (p) => { await p.addInitScript(() => {
    window.print = () => {
      const shown = [...document.querySelectorAll<HTMLElement>('.sections > section')].filter((s) => !s.hidden).map((s) => s.querySelector('h2')?.textContent ?? '');
      (window.top as unknown as Printed).printed = { shown, paper: document.getElementById('chosen-paper')?.textContent ?? '' };
    };
  }); });
  await solved(page);
});
afterAll(async () => { await bench?.stop(); });

const printed = (): Promise<Printed['printed']> => page.evaluate(() => (window as unknown as Printed).printed);
const frame = () => page.frameLocator('iframe.reportpage');

test('the report is shown in the middle', async () => {
  await goTo(page, 'report');
  await page.getByRole('button', { name: 'Make the report' }).click();
  await frame().locator('h1').waitFor({ timeout: 60_000 });
  await expect.poll(() => frame().locator('h1').innerText()).toBe('My first lay');
  await bench.shot(page, 'report');
});

test('document control is written into the model, and shown in the updated report', async () => {
  await page.fill('#rp-document', 'OB-001');
  await page.fill('#rp-revision', 'B');
  await page.keyboard.press('Enter');
  await page.locator('text=The model has changed since this report was made').waitFor();
  expect(await (await bench.api('model')).text()).toMatch(/document: OB-001/);
  await page.click('text=Update the report');
  await frame().locator('text=OB-001').first().waitFor({ timeout: 60_000 });
  await expect.poll(() => page.locator('text=The model has changed since this report was made').count()).toBe(0);
});

test('parts are omitted from display and print, on the selected paper', async () => {
  await page.click('.parts summary');
  await page.locator('.parts label', { hasText: 'Assumptions' }).click();
  await page.keyboard.press('Escape');
  await expect.poll(() => frame().locator('h2', { hasText: 'Assumptions' }).isVisible()).toBe(false);
  await page.selectOption('#rp-paper', 'letter');
  await page.evaluate(() => { delete (window as unknown as Printed).printed; });
  await page.click('.reportfiles >> text=PDF');
  await expect.poll(printed, { timeout: 60_000 }).toMatchObject({ paper: '@page { size: letter; }' });
  expect((await printed())!.shown).toContain('Key results');
  expect((await printed())!.shown).not.toContain('Assumptions');
});

test('it is saved as HTML, CSV and a workbook of its tables', async () => {
  for (const [kind, name] of [['HTML', /\.html$/], ['CSV', /\.csv$/], ['XLSX', /\.xlsx$/]] as const) {
    const [file] = await Promise.all([page.waitForEvent('download'), page.click(`.reportfiles >> text=${kind}`)]);
    expect(file.suggestedFilename()).toMatch(name);
  }
});

test('a run of the folder is reported as well', async () => {
  const run = await page.locator('#rp-subject optgroup option').first().getAttribute('value');
  await page.selectOption('#rp-subject', run!);
  await frame().locator('h1').waitFor();
  await expect.poll(() => page.locator('.reportfiles >> text=Update').count()).toBe(0);
});

test('no errors were logged in the browser', () => expect(bench.complaints.filter((c) => !c.includes('model/disk'))).toEqual([]));
