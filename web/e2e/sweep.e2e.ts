// The pointer sweeps over the whole page, which responds after every move.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { goTo, showTab, solved, start, workspaces, type Bench } from './harness';

let bench: Bench;
beforeAll(async () => { bench = await start('bgl1.yaml'); });
afterAll(async () => { await bench?.stop(); });

/** Fails if the page does not respond in time. */
function answers(page: Page, where: string): Promise<void> {
  let late: NodeJS.Timeout;
  const busy = new Promise<never>((_, fail) => { late = setTimeout(() => fail(new Error(`the page no longer answers ${where}`)), 10_000); });
  return Promise.race([page.evaluate(() => undefined), busy]).finally(() => clearTimeout(late));
}

/** Along lines across the page, back and forth, with a step that no row of the page shares. */
async function sweep(page: Page, where: string, moves: number): Promise<void> {
  const { width, height } = page.viewportSize()!;
  const rows = 20, each = moves / rows;
  for (let i = 0; i < moves; ++i) {
    const row = Math.floor(i / each), along = (i % each + 0.5) / each;
    await page.mouse.move(width * (row % 2 ? 1 - along : along), height * (row + 0.5) / rows);
    await answers(page, `in ${where} after ${i + 1} moves`);
  }
}

test('the page answers after each move of the pointer over everything, in every tab of every workspace', async () => {
  const page = await bench.open({ width: 1600, height: 900 });
  await solved(page);
  await page.selectOption('[aria-label="Diagram 1"]', 'von_mises');
  await page.selectOption('[aria-label="Diagram 2"]', 'reactions');
  let whole = true;  // the surroundings of the tabs are the same in all
  for (const workspace of workspaces) {
    await goTo(page, workspace);
    const tabs = (await page.locator('.docktabs [role=tab]').evaluateAll((all) => all.map((tab) => tab.id.replace('docktab-', ''))));
    if (workspace === 'lay') expect(tabs.length).toBeGreaterThan(5);
    for (const tab of tabs.length ? tabs : ['']) {
      if (tab) await showTab(page, tab);
      await sweep(page, `${workspace} ${tab}`, whole ? 500 : 60);
      whole = false;
    }
  }
  expect(bench.complaints).toEqual([]);
  await page.context().close();
}, 600_000);

test('a cursor on the pipe is shown in every diagram along it', async () => {
  const page = await bench.open({ width: 1600, height: 900 });
  await solved(page);
  const first = (await page.locator('.slot').nth(0).locator('.u-over').boundingBox())!;
  await page.mouse.move(first.x + 0.4 * first.width, first.y + 0.5 * first.height);
  for (const slot of await page.locator('.slot').all()) await expect.poll(() => slot.locator('.read').innerText()).not.toBe('');
  await page.mouse.move(first.x + 0.4 * first.width, 5);
  for (const slot of await page.locator('.slot').all()) await expect.poll(() => slot.locator('.read').innerText()).toBe('');
  await page.context().close();
});
