// What a key result hangs on, with BGL-1.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('bgl1.yaml'); page = await bench.open(); await solved(page); });
afterAll(async () => { await bench?.stop(); });

test('a tornado of the chosen result', async () => {
  const panel = page.locator('section[aria-label="Sensitivities"]');
  await panel.locator('button').click();
  await panel.locator('.tornado li').first().waitFor();
  await panel.locator('select').selectOption('static.bottom_tension');
  // The tension at the tensioner is that at touchdown and the weight that hangs between, nothing else.
  const foremost = panel.locator('.tornado li').first();
  expect(await foremost.locator('.what').innerText()).toMatch(/^tensioner\.tension ± 2\.5 kN/);
  expect(await foremost.locator('b').innerText()).toMatch(/^\+2\.\d+ kN/);
  expect(await panel.locator('.tornado li').count()).toBe(12);
  await panel.scrollIntoViewIfNeeded();
  await bench.shot(page, 'sensitivities');
});

test('they are marked as old when a value is tried out', async () => {
  await page.locator('#s-tension').evaluate((el) => { const input = el as HTMLInputElement; input.value = '300'; input.dispatchEvent(new Event('input', { bubbles: true })); });
  await page.locator('section.sensitivities.old').waitFor();
});
