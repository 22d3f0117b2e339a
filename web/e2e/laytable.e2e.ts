// A lay table from the page: made, looked at, downloaded.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('first-model.yaml'); page = await bench.open(); await solved(page); await page.click('#tab-laytable'); });
afterAll(async () => { await bench?.stop(); });

test('what cannot be asked for is said before', async () => {
  await page.fill('#lt-to', '400');
  expect(await page.locator('.laytable .main').isDisabled()).toBe(true);
  expect(await page.locator('.laytable .fault').innerText()).toMatch(/unit/);
});

test('a table over tension has its rows, curves and downloads', async () => {
  await page.fill('#lt-from', '250 kN');
  await page.fill('#lt-to', '400 kN');
  await page.fill('#lt-steps', '3');
  await page.click('text=Make table');
  const rows = page.locator('table.lay-rows tbody tr');
  await rows.first().waitFor({ timeout: 60_000 });
  expect(await rows.count()).toBeGreaterThanOrEqual(4);
  expect(await page.locator('table.lay-rows thead').innerText()).toMatch(/top tension/);
  expect(await page.locator('.laycurves svg').count()).toBeGreaterThan(4);
  const book = await bench.api('lay-table.xlsx');
  expect(book.status).toBe(200);
  expect(new TextDecoder('latin1').decode((await book.arrayBuffer()).slice(0, 2))).toBe('PK');
  expect(await (await bench.api('lay-table.csv')).text()).toMatch(/^row,tension \[kN\]/);
  await bench.shot(page, 'lay-table');
});
