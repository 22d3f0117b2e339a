// The first operation that the page offers for a new model, unchanged: the head reaches the seabed.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start(); page = await bench.open({ width: 1600, height: 900 }); });
afterAll(async () => { await bench?.stop(); });

async function make(answers: Record<string, string>): Promise<void> {
  if (!await page.locator('dialog[open]').count()) {
    await page.click('header >> text=New…');
    await page.click('text=Continue without saving');
  }
  await page.waitForSelector('#n-depth');
  for (const [id, value] of Object.entries(answers)) {
    const field = page.locator(`#n-${id}`);
    if (await field.evaluate((e) => e.tagName) === 'SELECT') await field.selectOption(value); else await field.fill(value);
  }
  await page.click('dialog button.main');
  await expect.poll(() => page.locator('dialog[open]').count(), { timeout: 30_000 }).toBe(0);
  await solved(page);
}

async function stages(offer: string): Promise<{ z: number[]; rows: number; failed: number }> {
  await page.click('#workspace-operation');
  await page.click(`.offers >> text=${offer}`);
  await page.click('.opstrip button.main');
  await page.locator('table.stages tbody tr').first().waitFor({ timeout: 60_000 });
  const heads = await page.locator('table.stages thead tr').last().locator('th').allInnerTexts();
  const column = heads.findIndex((h) => h.startsWith('head z'));
  const cells = await page.locator('table.stages tbody tr').evaluateAll((all) => all.map((row) => [...row.children].map((cell) => (cell as HTMLElement).innerText.trim())));
  return { z: cells.filter((r) => r.length === heads.length).map((r) => Number(r[column])), rows: cells.length, failed: await page.locator('table.stages tr.gone').count() };
}

// from a light pipe in shallow water to a pipe laid from a tower in deep water
test.each([
  [{ pipe: '6', depth: '20 m', lay: 's' }, 20],
  [{ pipe: '30', depth: '300 m', lay: 's' }, 300],
  [{ pipe: '20', depth: '1000 m', lay: 'j', vessel: 'ship' }, 1000],
])('of %j the abandonment ends on the seabed', async (answers, depth) => {
  await make(answers);
  const { z, rows, failed } = await stages('Abandonment');
  expect([rows, failed]).toEqual([11, 0]);
  // the axis of a head on the seabed is above it by the radius of the coated pipe, less than 0.5 m
  expect(z.at(-1)! + depth).toBeGreaterThan(-0.2);
  expect(z.at(-1)! + depth).toBeLessThan(0.6);
  expect(z).toEqual([...z].sort((a, b) => b - a));
  await bench.shot(page, `first-abandonment-${depth}`);
});

test('a start-up solves at every stage as well', async () => {
  await make({ pipe: '16', depth: '90 m', lay: 's' });
  const { rows, failed } = await stages('Start-up');
  expect([rows, failed]).toEqual([7, 0]);
});

test('a pull to a winch on the seabed solves at every stage', async () => {
  await make({ pipe: '16', depth: '90 m', lay: 's' });
  const { rows, failed } = await stages('Shore pull');
  expect([rows, failed]).toEqual([9, 0]);
});

test('no operation is created without a solution of the lay', async () => {
  await make({ pipe: '16', depth: '90 m', lay: 's' });
  const { revision } = await (await bench.api('model')).json() as { revision: number };
  await bench.api('model/set', { method: 'POST', body: JSON.stringify({ changes: [{ path: 'tensioner.tension', value: '2 kN' }], revision }) });
  await page.waitForSelector('.status.bad');
  await page.click('#workspace-operation');
  await page.click('.offers >> text=Abandonment');
  await expect.poll(() => page.locator('.notices').innerText()).toMatch(/No operation was added/);
  await expect.poll(() => page.locator('table.stages').count()).toBe(0);
});

test('no errors were logged in the browser', () => expect(bench.complaints).toEqual([]));
