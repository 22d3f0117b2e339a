// Diagrams keep the zoomed range when their results are refreshed.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { runStorm, solved, start, tryValue, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('bgl1-workable-sea.yaml'); page = await bench.open(); await solved(page); });
afterAll(async () => { await bench?.stop(); });

/** Ends of the x axis of a diagram. */
const ends = (slot: number): Promise<[number, number]> => page.evaluate((i) => (document.querySelectorAll('.slot .plot')[i] as unknown as { shown: () => [number, number] }).shown(), slot);

async function zoom(slot: number): Promise<[number, number]> {
  const box = (await page.locator('.slot .u-over').nth(slot).boundingBox())!;
  await page.mouse.move(box.x + 0.3 * box.width, box.y + 0.5 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.6 * box.width, box.y + 0.5 * box.height, { steps: 5 });
  await page.mouse.up();
  await page.waitForTimeout(300);
  return ends(slot);
}

test('while a value is dragged, and after it is applied', async () => {
  const whole = await ends(0), near = await zoom(0);
  expect(near[1] - near[0]).toBeLessThan(0.5 * (whole[1] - whole[0]));
  await tryValue(page, 'tension', 300);
  await page.waitForTimeout(600);
  await expect.poll(() => ends(0)).toEqual(near);
  await page.click('text=Apply to model');
  await page.waitForTimeout(600);
  await expect.poll(() => ends(0)).toEqual(near);
  await page.locator('.slot .u-over').first().dblclick();
  await page.waitForTimeout(300);
  const again = await ends(0);
  expect(again[1] - again[0]).toBeGreaterThan(0.9 * (whole[1] - whole[0]));
});

test('of a run in time, also when more of it arrives', async () => {
  await page.click('[aria-label=Undo]'); // the machine of this model does not reach 300 kN
  await solved(page);
  const id = await runStorm(bench, page, 20);
  await page.selectOption('[aria-label="History 2"]', 'top_tension');
  await page.waitForTimeout(1200);
  const whole = await ends(1), near = await zoom(1);
  expect(near[1] - near[0]).toBeLessThan(0.5 * (whole[1] - whole[0]));
  await page.waitForTimeout(1500); // the range is fetched again at a finer resolution
  await expect.poll(() => ends(1)).toEqual(near);
  expect((await bench.api(`runs/${id}/annotate`, { method: 'POST', body: JSON.stringify({ name: 'looked at' }) })).status).toBe(200);
  await page.locator('.right h3', { hasText: 'looked at' }).waitFor({ timeout: 20_000 });
  await page.waitForTimeout(800);
  await expect.poll(() => ends(1)).toEqual(near);
});

test('no errors were logged in the browser', () => expect(bench.complaints).toEqual([]));
