// An operation on the line: begun in its tab, solved, gone through stage by stage, at three sizes.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { difference, picture, reading, rested, solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('bgl1.yaml'); page = await bench.open({ width: 1920, height: 1080 }); await solved(page); });
afterAll(async () => { await bench?.stop(); });

const text = async (): Promise<string> => (await (await bench.api('model')).json() as { text: string }).text;
async function put(next: string): Promise<void> {
  const { revision } = await (await bench.api('model')).json() as { revision: number };
  expect((await bench.api('model', { method: 'PUT', body: JSON.stringify({ text: next, revision }) })).status).toBe(200);
}
const rows = (): Promise<string[][]> => page.locator('table.stages tbody tr').evaluateAll((all) => all.map((row) => [...row.children].map((cell) => (cell as HTMLElement).innerText.trim())));

test('a first operation is written into the model and its stages are solved', async () => {
  await page.click('#tab-operation');
  await page.click('.offers >> text=Move ahead');
  await expect.poll(text).toMatch(/operation:\s+type: move/);
  await page.click('text=Solve all stages');
  await expect.poll(async () => (await rows()).length, { timeout: 60_000 }).toBe(5);
  const shown = await rows();
  expect(shown.map((r) => Number(r[1]))).toEqual([0, 3, 6, 9, 12]);
  expect(shown.every((r) => Number(r[2]) > 0)).toBe(true);
});

test('a stage that is clicked is the one that picture and results show', async () => {
  await page.locator('table.stages tbody tr').nth(2).locator('.linkname').click();
  await expect.poll(() => page.locator('.results h2').first().innerText()).toMatch(/stage 3/);
  expect(await page.locator('.stagebar .which').innerText()).toMatch(/stage 3 of 5/);
  expect(await reading(page, 'top tension')).toBeCloseTo(Number((await rows())[2]![2]), 0);
  await bench.shot(page, 'operation-move');
});

test('the slider goes through the stages, and back to the lay', async () => {
  await page.locator('.stagebar input[type=range]').fill('4');
  await expect.poll(() => page.locator('.stagebar .which').innerText()).toMatch(/stage 5/);
  expect(await page.locator('table.stages tr.chosen').count()).toBe(1);
  await page.click('.stagebar [aria-label="Back to the lay"]');
  await expect.poll(() => page.locator('.stagebar').count()).toBe(0);
  expect(await page.locator('.results h2').first().innerText()).toMatch(/statics/);
});

test('a stage that cannot be says why in its row', async () => {
  await put((await text()).replace(/operation:[\s\S]*$/, 'operation:\n  type: move\n  stages:\n    - {ahead: 0 m}\n    - {ahead: 6 m, tension: 1 kN}\n'));
  await expect.poll(() => page.locator('.operation .note').innerText()).toMatch(/model has changed/);
  await page.click('text=Solve again');
  await expect.poll(async () => (await rows()).length, { timeout: 60_000 }).toBe(2);
  expect((await rows())[1]![1]).toMatch(/\w{4}/);
  expect(await page.locator('table.stages tr.gone .linkname').isDisabled()).toBe(true);
  await bench.shot(page, 'operation-failed');
});

test('an abandonment shows head and cable apart from the pipe, at three sizes', async () => {
  await put((await text()).replace(/operation:[\s\S]*$/, ''));
  await page.click('.offers >> text=Abandonment');
  await expect.poll(text).toMatch(/type: abandonment/);
  await page.click('text=Solve all stages');
  await expect.poll(async () => (await rows()).length, { timeout: 60_000 }).toBe(11);
  const heads = await page.locator('table.stages thead th').allInnerTexts();
  const depth = heads.findIndex((h) => h.startsWith('head z'));
  const standing = (await rows()).filter((r) => r.length === heads.length).map((r) => Number(r[depth]));
  expect(standing.length).toBeGreaterThan(5);
  expect(standing).toEqual([...standing].sort((a, b) => b - a)); // the head goes down
  expect(await page.locator('.holds li').count()).toBeGreaterThan(2);
  await rested(page);
  const first = await picture(page, '.canvas');
  await page.locator('.stagebar input[type=range]').fill('6');
  await expect.poll(() => page.locator('.stagebar .which').innerText()).toMatch(/stage 7/);
  await rested(page);
  expect(await difference(page, first, await picture(page, '.canvas'))).toBeGreaterThan(0.05);
  expect(await page.locator('.legend').innerText()).toMatch(/head\s+cable/);
  expect(await page.locator('.slot .chartlegend').first().innerText()).toMatch(/cable/);
  for (const [name, width, height] of [['large', 1920, 1080], ['middle', 1280, 720], ['small', 390, 780]] as const) {
    await page.setViewportSize({ width, height });
    if (name === 'small') await page.click('.panes >> text=Model');
    await expect.poll(() => page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
    await bench.shot(page, `operation-${name}`);
  }
  await page.click('.panes >> text=Picture');
  await page.waitForTimeout(300);
  await bench.shot(page, 'operation-small-picture');
});

test('nothing was complained about', () => expect(bench.complaints).toEqual([]));
