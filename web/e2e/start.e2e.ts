// First start: from the dialog to the first solution.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { openField, reading, solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start(); page = await bench.open(); });
afterAll(async () => { await bench?.stop(); });

test('without a model the page offers to create one', async () => {
  await page.waitForSelector('dialog[aria-label="New model"] #n-depth');
  await bench.shot(page, 'start-dialogue');
});

test('an invalid answer is reported at its field and disables the button', async () => {
  await page.fill('#n-depth', '89 kN');
  await expect.poll(() => page.locator('.failuretext').innerText()).toMatch(/not one of m, mm, ft or in/);
  await expect.poll(() => page.locator('dialog button.main').isDisabled()).toBe(true);
});

test('answers in mixed units lead to a solution', async () => {
  await page.selectOption('#n-pipe', '16');
  await page.fill('#n-depth', '300 ft');
  await page.fill('#n-concrete', '1.5 in');
  await page.click('dialog button.main');
  await solved(page);
  await expect.poll(() => reading(page, 'top tension')).toBeGreaterThan(10);
  expect(await (await openField(page, 'environment.water_depth')).inputValue()).toBe('300 ft');
  await page.waitForTimeout(800);
  await bench.shot(page, 'first-solution');
});

test('it can be saved, and undone', async () => {
  await page.click('[aria-label="More save options"]');
  await page.click('[role=menuitem] >> text=Save as…');
  await page.fill('#save-name', 'mine');
  await page.click('dialog button.main');
  await page.waitForSelector('.notice.good');
  const files = await (await bench.api('files')).json() as { files: { name: string }[] };
  expect(files.files.map((f) => f.name)).toContain('mine.yaml');
  await page.fill('#f-environment\\.water_depth', '100 m');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => (document.querySelector('#f-environment\\.water_depth ~ .twin') as HTMLElement).innerText === '328.1 ft');
  await page.click('[aria-label=Undo]');
  await page.waitForFunction(() => (document.querySelector('#f-environment\\.water_depth') as HTMLInputElement).value === '300 ft');
});

test('no errors were logged in the browser', () => expect(bench.complaints).toEqual([]));
