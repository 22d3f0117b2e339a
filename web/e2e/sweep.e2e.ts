// The pointer goes over everything: the page answers after every move.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { solved, start, type Bench } from './harness';

let bench: Bench;
beforeAll(async () => { bench = await start('bgl1.yaml'); });
afterAll(async () => { await bench?.stop(); });

/** Fails where the page is too busy with itself to answer. */
function answers(page: Page, where: string): Promise<void> {
  let late: NodeJS.Timeout;
  const busy = new Promise<never>((_, fail) => { late = setTimeout(() => fail(new Error(`the page no longer answers ${where}`)), 10_000); });
  return Promise.race([page.evaluate(() => undefined), busy]).finally(() => clearTimeout(late));
}

/** Along lines across the page, back and forth, a step in width that no row of the page shares. */
async function sweep(page: Page, tab: string, moves: number): Promise<void> {
  const { width, height } = page.viewportSize()!;
  const rows = 20, each = moves / rows;
  for (let i = 0; i < moves; ++i) {
    const row = Math.floor(i / each), along = (i % each + 0.5) / each;
    await page.mouse.move(width * (row % 2 ? 1 - along : along), height * (row + 0.5) / rows);
    await answers(page, `in the tab ${tab} after ${i + 1} moves`);
  }
}

test('the page answers after each move of the pointer over everything, in every tab', async () => {
  const page = await bench.open({ width: 1600, height: 900 });
  await solved(page);
  await page.selectOption('[aria-label="Diagram 1"]', 'von_mises');
  await page.selectOption('[aria-label="Diagram 2"]', 'reactions');
  const tabs = page.getByRole('tab');
  const count = await tabs.count();
  expect(count).toBeGreaterThan(2);
  for (let i = 0; i < count; ++i) {
    const tab = tabs.nth(i);
    if (!await tab.isVisible() || await tab.isDisabled()) continue;
    const name = await tab.innerText();
    await tab.click();
    await sweep(page, name, i === 0 ? 500 : 100);  // what is beside the tabs is the same in all
  }
  expect(bench.complaints).toEqual([]);
  await page.context().close();
}, 300_000);

test('a cursor on the pipe stands in every diagram along it', async () => {
  const page = await bench.open({ width: 1600, height: 900 });
  await solved(page);
  const first = (await page.locator('.slot').nth(0).locator('.u-over').boundingBox())!;
  await page.mouse.move(first.x + 0.4 * first.width, first.y + 0.5 * first.height);
  for (const slot of await page.locator('.slot').all()) await expect.poll(() => slot.locator('.read').innerText()).not.toBe('');
  await page.mouse.move(first.x + 0.4 * first.width, 5);
  for (const slot of await page.locator('.slot').all()) await expect.poll(() => slot.locator('.read').innerText()).toBe('');
  await page.context().close();
});
