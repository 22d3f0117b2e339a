// Goal seek from a result.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('first-model.yaml'); page = await bench.open({ width: 1440, height: 900 }); await solved(page); });
afterAll(async () => { await bench?.stop(); });

const row = () => page.locator('.keyresults tr', { hasText: 'bottom tension' });

test('goal seek reaches a bottom tension, and its tension is applied to the model', async () => {
  await row().hover();
  await row().locator('button.make').click();
  await page.fill('#s-value', '270');
  await bench.shot(page, 'seek-asked');
  await page.click('dialog button.main');
  await page.waitForSelector('.seek .found');
  await expect.poll(() => page.locator('.seek .found').innerText()).toContain('gives 270 kN');
  await bench.shot(page, 'seek-found');
  await page.click('dialog button.main:has-text("Apply")');
  await page.waitForSelector('dialog', { state: 'detached' });
  await expect.poll(() => row().locator('th small').innerText()).toBe('kN');
  await expect.poll(async () => (await row().locator('td').first().innerText()).trim(), { timeout: 20_000 }).toMatch(/^270(\.0)?$/);
});

test('an unreachable target is reported with the range that can be reached', async () => {
  await row().hover();
  await row().locator('button.make').click();
  await page.fill('#s-value', '5000 kN');
  await page.click('dialog button.main');
  await page.waitForSelector('.seek .found');
  await expect.poll(() => page.locator('.seek .found').innerText()).toContain('it goes from');
  await bench.shot(page, 'seek-none');
  await page.keyboard.press('Escape');
});
