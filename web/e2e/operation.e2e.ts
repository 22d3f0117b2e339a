// An operation on the line: created in its workspace, designed, solved, viewed stage by stage, at three screen sizes.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { difference, picture, rested, solved, start, type Bench } from './harness';

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
  await page.click('#workspace-operation');
  await page.click('.offers >> text=Move ahead');
  await expect.poll(text).toMatch(/operation:\s+type: move/);
  await page.click('.opstrip >> text=Solve 5 stages');
  await expect.poll(async () => (await rows()).length, { timeout: 60_000 }).toBe(5);
  const shown = await rows();
  expect(shown.map((r) => Number(r[1]))).toEqual([0, 3, 6, 9, 12]);
  expect(shown.every((r) => Number(r[2]) > 0)).toBe(true);
});

test('a clicked stage is shown in picture and results', async () => {
  await page.locator('table.stages tbody tr').nth(2).locator('.linkname').click();
  await expect.poll(() => page.locator('.whoseresults h3').innerText()).toMatch(/Stage 3/);
  await expect.poll(() => page.locator('.stagebar .which').innerText()).toMatch(/stage 3 of 5/);
  const tension = page.locator('.right tr', { hasText: 'top tension' }).first();
  expect(Number.parseFloat((await tension.locator('td').first().innerText()))).toBeCloseTo(Number((await rows())[2]![2]), 0);
  await bench.shot(page, 'operation-move');
});

test('the slider goes through the stages, and back to the lay', async () => {
  await page.locator('.stagebar input[type=range]').fill('4');
  await expect.poll(() => page.locator('.stagebar .which').innerText()).toMatch(/stage 5/);
  await expect.poll(() => page.locator('table.stages tr.chosen').count()).toBe(1);
  await page.click('.stagebar [aria-label="Back to the lay"]');
  await expect.poll(() => page.locator('.stagebar .which').innerText()).toMatch(/the lay is shown/);
  await expect.poll(() => page.locator('.whoseresults').count()).toBe(0);
});

test('a stage without solution shows the reason in its row', async () => {
  await put((await text()).replace(/operation:[\s\S]*$/, 'operation:\n  type: move\n  stages:\n    - {ahead: 0 m}\n    - {ahead: 6 m, tension: 1 kN}\n'));
  await expect.poll(() => page.locator('.opstrip .note').innerText()).toMatch(/model has changed/);
  await page.click('.opstrip >> text=Solve 2 stages');
  await expect.poll(async () => (await rows()).length, { timeout: 60_000 }).toBe(2);
  await page.locator('table.stages tr.gone td.why').waitFor({ timeout: 60_000 });
  await expect.poll(() => page.locator('table.stages tr.gone td.why').innerText()).toMatch(/\w{4}/);
  await expect.poll(() => page.locator('table.stages tr.gone .linkname').isDisabled()).toBe(true);
  await bench.shot(page, 'operation-failed');
});

test('a stage of a list is changed in its row', async () => {
  const tension = page.locator('table.stages tbody tr').nth(1).locator('td.setting input').nth(1);
  await expect.poll(() => tension.inputValue()).toBe('1 kN');
  await tension.fill('240');
  await tension.press('Enter');
  await expect.poll(text).toMatch(/ahead: 6 m, tension: 240 kN/);
  await expect.poll(() => page.locator('.opstrip .note').innerText()).toMatch(/model has changed/);
  await page.click('.opstrip >> text=Solve 2 stages');
  // the value of the solved stage follows that of the model
  await expect.poll(async () => Number(await tension.getAttribute('placeholder')), { timeout: 60_000 }).toBe(240);
  await expect.poll(() => page.locator('table.stages tr.gone').count()).toBe(0);
});

test('the settings of a designed abandonment are summarised above the picture, with their keys in popovers', async () => {
  await put((await text()).replace(/operation:[\s\S]*$/, ''));
  await page.click('.offers >> text=Abandonment');
  await page.click('text=Design the procedure');
  await expect.poll(() => page.locator('table.stages .light[aria-label]').count(), { timeout: 180_000 }).toBe(11);
  await expect.poll(() => page.locator('.opstrip .main').innerText(), { timeout: 180_000 }).toBe('Solve 11 stages');
  await bench.shot(page, 'operation-designed');
  const field = page.locator('.opstrip .valuebox', { hasText: 'tension' });
  await expect.poll(() => field.locator('button').first().innerText()).toBe('seek: utilisation below 0.9');
  await field.locator('button').first().click();
  await page.fill('.valuepanel:popover-open [id="f-operation.stages.limits.tip_clearance"]', '0 m');
  await page.keyboard.press('Enter');
  await expect.poll(text).toMatch(/tip_clearance: 0 m/);
  await page.keyboard.press('Escape');
  await expect.poll(() => page.locator('.valuepanel:popover-open').count()).toBe(0);
  await expect.poll(() => page.locator('.opstrip .valuebox', { hasText: 'cable' }).first().locator('button').first().innerText()).toMatch(/mm, [\d.]+ kN/);
});

test('diagrams run over the stages, and tension along the cable', async () => {
  await page.click('#docktab-over');
  await expect.poll(() => page.locator('.datadiagram').count()).toBeGreaterThan(4);
  await page.click('#docktab-cable');
  await expect.poll(() => page.locator('.cablevalues').innerText()).toMatch(/breaking load/);
  await page.click('#docktab-stages');
});

test('an abandonment shows head and cable apart from the pipe, at three sizes', async () => {
  await put((await text()).replace(/operation:[\s\S]*$/, ''));
  await page.click('.offers >> text=Abandonment');
  await expect.poll(text).toMatch(/type: abandonment/);
  await page.click('.opstrip >> text=Solve 11 stages');
  await expect.poll(async () => (await rows()).length, { timeout: 60_000 }).toBe(11);
  const heads = await page.locator('table.stages thead tr').last().locator('th').allInnerTexts();
  const depth = heads.findIndex((h) => h.startsWith('head z'));
  const standing = (await rows()).filter((r) => r.length === heads.length).map((r) => Number(r[depth]));
  expect(standing.length).toBeGreaterThan(5);
  expect(standing).toEqual([...standing].sort((a, b) => b - a)); // the head is lowered
  await expect.poll(() => page.locator('.holds li').count()).toBeGreaterThan(2);
  await rested(page);
  const first = await picture(page, '.canvas');
  await page.locator('.stagebar input[type=range]').fill('6');
  await expect.poll(() => page.locator('.stagebar .which').innerText()).toMatch(/stage 7/);
  await rested(page);
  expect(await difference(page, first, await picture(page, '.canvas'))).toBeGreaterThan(0.05);
  await expect.poll(() => page.locator('.legend').innerText()).toMatch(/head\s+cable/);
  await page.click('#docktab-diagrams');
  await expect.poll(() => page.locator('.dock .slot .chartlegend').first().innerText()).toMatch(/cable/);
  await page.click('#docktab-stages');
  for (const [name, width, height] of [['large', 1920, 1080], ['middle', 1280, 720], ['small', 1024, 768]] as const) {
    await page.setViewportSize({ width, height });
    await expect.poll(() => page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
    await bench.shot(page, `operation-${name}`);
  }
});

test('no errors were logged in the browser', () => expect(bench.complaints).toEqual([]));
