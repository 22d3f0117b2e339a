// No silent loss of data: unsaved changes, files changed by others, undo after a reload, two tabs.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Dialog, Page } from 'playwright-core';
import { openField, selectObject, showTab, solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('bgl1.yaml'); page = await bench.open({ width: 1280, height: 620 }); await solved(page); });
afterAll(async () => { await bench?.stop(); });

const depth = '#f-environment\\.water_depth';
const file = (): string => readFileSync(join(bench.folder, 'bgl1.yaml'), 'utf8');
const model = async (): Promise<{ text: string; revision: number; saved: boolean }> => await (await bench.api('model')).json() as never;
async function type(p: Page, value: string): Promise<void> { await (await openField(p, 'environment.water_depth')).fill(value); await p.keyboard.press('Enter'); }
const holds = (p: Page, value: string): Promise<unknown> => p.waitForFunction(([id, v]) => (document.querySelector(id!) as HTMLInputElement | null)?.value === v, [depth, value] as const);

test('Open and New ask before changes are lost, and do not where there are none', async () => {
  await page.click('header >> text=Open…');
  await page.waitForSelector('dialog[aria-label=Open]');
  await page.keyboard.press('Escape');
  await type(page, '91 m');
  await page.waitForSelector('h1 i');
  for (const button of ['New…', 'Open…']) {
    await page.click(`header >> text=${button}`);
    await page.waitForSelector('dialog[aria-label="Changes are not saved"]');
    await page.click('dialog >> text=Cancel');
  }
  expect((await model()).text).toContain('water_depth: 91 m');
  await page.click('header >> text=Open…');
  await page.click('dialog >> text=Save first');
  await page.waitForSelector('dialog[aria-label=Open]');
  await page.keyboard.press('Escape');
  expect(file()).toContain('water_depth: 91 m');
});

test('a file changed by another program is not overwritten: both texts are shown, and each can be chosen', async () => {
  writeFileSync(join(bench.folder, 'bgl1.yaml'), file().replace('water_depth: 91 m', 'water_depth: 85 m'));
  await type(page, '93 m');
  await page.waitForSelector('h1 i');
  await page.keyboard.press('Control+s');
  const dialog = page.locator('dialog[aria-label="bgl1.yaml has changed on disk"]');
  await dialog.waitFor();
  await expect.poll(() => dialog.locator('.differs').innerText()).toMatch(/85 m[\s\S]*93 m/);
  await bench.shot(page, 'overwrite');
  await dialog.locator('footer >> text=Cancel').click();
  expect(file()).toContain('water_depth: 85 m');
  expect((await model()).text).toContain('water_depth: 93 m');

  await page.getByRole('button', { name: 'Save', exact: true }).click();
  await dialog.locator('text=Replace the file').click();
  await dialog.waitFor({ state: 'hidden' }); // nothing can be typed behind it; a notice of an earlier save may still be visible
  await page.waitForSelector('.notice.good');
  expect(file()).toContain('water_depth: 93 m');

  writeFileSync(join(bench.folder, 'bgl1.yaml'), file().replace('water_depth: 93 m', 'water_depth: 86 m'));
  await type(page, '94 m');
  await page.waitForSelector('h1 i');
  await page.keyboard.press('Control+s');
  await dialog.locator("text=Reload from disk").click();
  await holds(page, '86 m');
  await page.click('[aria-label=Undo]'); // the previous text is one undo step back
  await holds(page, '94 m');
  await page.click('[aria-label=Redo]');
  await holds(page, '86 m');
});

test('undo and redo survive a reload', async () => {
  await type(page, '95 m');
  await solved(page);
  await type(page, '96 m');
  await page.waitForFunction(() => !document.querySelector('[aria-label=Redo]:enabled'));
  await expect.poll(async () => (await model()).text).toContain('water_depth: 96 m');
  await page.click('[aria-label=Undo]');
  await expect.poll(async () => (await model()).text).toContain('water_depth: 95 m');
  await page.reload();
  await holds(page, '95 m');
  await page.click('[aria-label=Redo]');
  await holds(page, '96 m');
  await page.click('[aria-label=Undo]');
  await page.click('[aria-label=Undo]');
  await holds(page, '86 m');
});

test('two tabs agree without a question', async () => {
  const second = await bench.open({ width: 1280, height: 620 });
  await solved(second);
  await selectObject(second, 'environment');
  await type(second, '97 m');
  await holds(page, '97 m');
  await page.click('[aria-label=Undo]');
  await holds(second, '86 m');
  await second.context().close();
});

test('simultaneous changes of two tabs: the user decides between them', async () => {
  for (const [choice, stays] of [['Use the newer', '98 m'], ['Keep mine', '92 m']] as const) {
    // the event of the other tab is delayed
    await page.route('**/api/model', async (route) => { await new Promise((done) => setTimeout(done, 800)); await route.continue().catch(() => undefined); });
    const { revision } = await model();
    expect((await bench.api('model/set', { method: 'POST', body: JSON.stringify({ changes: [{ path: 'environment.water_depth', value: '98 m' }], revision }) })).status).toBe(200);
    await type(page, '92 m');
    await page.waitForSelector('dialog >> text=Use the newer');
    await page.waitForTimeout(1000); // after the event the question is still open
    await page.unroute('**/api/model');
    await page.click(`dialog >> text=${choice}`);
    await holds(page, stays);
    await expect.poll(async () => (await model()).text).toContain(`water_depth: ${stays}`);
    await solved(page);
  }
});

test('a field shows the model once the newer text is chosen, also if that changed another key', async () => {
  const before = await page.locator(depth).inputValue();
  await page.route('**/api/model', async (route) => { await new Promise((done) => setTimeout(done, 800)); await route.continue().catch(() => undefined); });
  const { revision } = await model();
  expect((await bench.api('model/set', { method: 'POST', body: JSON.stringify({ changes: [{ path: 'tensioner.tension', value: '255 kN' }], revision }) })).status).toBe(200);
  await type(page, '101 m');
  await page.click('dialog >> text=Use the newer');
  await page.unroute('**/api/model');
  await selectObject(page, 'tensioner');
  await expect.poll(() => page.locator('#f-tensioner\\.tension').getAttribute('data-written')).toBe('255 kN');
  await selectObject(page, 'environment');
  await holds(page, before);
  expect((await model()).text).toContain(`water_depth: ${before}`);
});

test('two values typed during a change of another tab are both kept if the user keeps them', async () => {
  await page.route('**/api/model/set', async (route) => { await new Promise((done) => setTimeout(done, 600)); await route.continue().catch(() => undefined); });
  const { revision } = await model();
  await page.route('**/api/model', async (route) => { await new Promise((done) => setTimeout(done, 1500)); await route.continue().catch(() => undefined); });
  expect((await bench.api('model/set', { method: 'POST', body: JSON.stringify({ changes: [{ path: 'tensioner.delay', value: '3 s' }], revision }) })).status).toBe(200);
  await type(page, '94 m');
  await (await openField(page, 'tensioner.tension')).fill('256 kN');
  await page.keyboard.press('Enter');
  await page.waitForSelector('dialog >> text=Keep mine');
  await page.waitForTimeout(1500);  // for the second rejection
  await page.unrouteAll();
  await page.click('dialog >> text=Keep mine');
  await expect.poll(async () => (await model()).text).toMatch(/water_depth: 94 m[\s\S]*tension: 256 kN/);
  await selectObject(page, 'environment');
  await holds(page, '94 m');
  await solved(page);
});

test('text typed during a save is kept as unsaved, and included in the next one', async () => {
  await type(page, '90 m');
  await page.waitForSelector('h1 i');
  await showTab(page, 'yaml');
  await page.waitForSelector('.cm-content');
  await page.route('**/api/model/save', async (route) => { const answer = await route.fetch(); await new Promise((done) => setTimeout(done, 1500)); await route.fulfill({ response: answer }); });
  const sent = page.waitForRequest('**/api/model/save');
  await page.keyboard.press('Control+s');
  await sent;
  await page.locator('.cm-content').focus();
  await page.keyboard.press('Control+End');
  await page.keyboard.type('# typed meanwhile');
  await expect.poll(async () => (await model()).text).toContain('# typed meanwhile');
  await page.waitForSelector('h1 i');
  expect(file()).not.toContain('# typed meanwhile');
  await expect.poll(() => page.locator('.cm-content').innerText()).toContain('# typed meanwhile');
  await page.unroute('**/api/model/save');
  await page.keyboard.press('Control+s');
  await page.waitForSelector('h1 i', { state: 'detached' });
  expect(file()).toContain('# typed meanwhile');
});

test('the browser warns before the page is closed with unsent text, and not afterwards', async () => {
  const asked: string[] = [];
  const answer = (d: Dialog): void => { asked.push(d.type()); void d.dismiss(); };
  page.on('dialog', answer);
  await page.route('**/api/model', async (route) => { await new Promise((done) => setTimeout(done, 1500)); await route.continue().catch(() => undefined); });
  await page.locator('.cm-content').focus();
  await page.keyboard.press('Control+End');
  await page.keyboard.type(' and before leaving');
  await page.evaluate(() => { location.reload(); });
  await expect.poll(() => asked).toEqual(['beforeunload']);
  await expect.poll(async () => (await model()).text).toContain('and before leaving');
  await page.unroute('**/api/model');
  await page.keyboard.press('Control+s');
  await page.waitForSelector('h1 i', { state: 'detached' });
  await page.reload();
  await solved(page);
  expect(asked).toHaveLength(1);
  expect((await model()).text).toContain('and before leaving');
  page.off('dialog', answer);
});

test('no errors were logged in the browser', () => expect(bench.complaints.filter((c) => !/409/.test(c))).toEqual([]));
