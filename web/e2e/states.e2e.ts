// Error states: reported within the page, with a way to continue, and without loss of data.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { openField, reading, showTab, solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('bgl1.yaml'); page = await bench.open({ width: 1440, height: 900 }); await solved(page); }, 60_000);
afterAll(async () => { await bench?.stop(); });

const file = (): string => join(bench.folder, 'bgl1.yaml');
const text = async (): Promise<string> => (await (await bench.api('model')).json() as { text: string }).text;
const lookAgain = (): Promise<void> => page.evaluate(() => { dispatchEvent(new Event('focus')); });

test('a value without solution is reported in the card, and the nearest solvable one is applied', async () => {
  const typed = page.locator('[aria-label="tension, typed"]');
  await typed.fill('1 kN');
  await typed.press('Enter');
  await page.locator('.verdict.unsolved h2', { hasText: 'Not solved' }).waitFor({ timeout: 60_000 });
  await page.click('.verdict >> text=Find the nearest solution');
  await page.waitForSelector('.verdict.unsolved', { state: 'detached', timeout: 120_000 });
  await solved(page);
  const found = Number.parseFloat(await typed.inputValue());
  expect(found).toBeGreaterThan(1);
  expect(found).toBeLessThan(200);
  await expect.poll(() => reading(page, 'top tension')).toBeCloseTo(found, 0);
  await expect.poll(() => text()).toContain('tension: 250 kN');
  await page.click('.pinned .apply >> text=Reset');
  await expect.poll(() => reading(page, 'top tension')).toBeCloseTo(250, 0);
}, 200_000);

test('a file changed by another program is reported when the page becomes visible, reloaded on demand, and undo restores the text', async () => {
  await (await openField(page, 'environment.water_depth')).fill('91 m');
  await page.keyboard.press('Enter');
  await expect.poll(text).toContain('water_depth: 91 m');
  const original = await text();
  await expect.poll(() => page.locator('.changedoutside').count()).toBe(0);
  writeFileSync(file(), readFileSync(file(), 'utf8').replace('water_depth: 89 m', 'water_depth: 85 m'));
  await lookAgain();
  await page.waitForSelector('.changedoutside');
  await expect.poll(() => page.locator('.changedoutside').innerText()).toMatch(/bgl1\.yaml has been changed by another program\. Your changes here are not saved\./);
  await page.click('.changedoutside >> text=Reload from disk');
  await expect.poll(text).toContain('water_depth: 85 m');
  await page.waitForSelector('.changedoutside', { state: 'detached' });
  await page.click('[aria-label=Undo]');
  await expect.poll(text).toBe(original);
  await solved(page);
});

test('a damaged file opens in the editor at its line', async () => {
  writeFileSync(join(bench.folder, 'damaged.yaml'), readFileSync(file(), 'utf8').replace('  water_depth: 85 m', '  water_depth: 85 m: checked'));
  await page.keyboard.press('Control+s');
  const dialog = page.locator('dialog[aria-label="bgl1.yaml has changed on disk"]');
  if (await dialog.isVisible()) await dialog.locator('text=Replace the file').click();
  await page.waitForSelector('h1 i', { state: 'detached' });
  await page.click('#workspace-storm');
  await page.click('header >> text=Open…');
  await page.click('dialog >> text=damaged.yaml');
  await page.waitForSelector('main[data-workspace=lay] #docktab-yaml[aria-selected=true]');
  await page.waitForFunction(() => document.activeElement?.classList.contains('cm-content'));
  await expect.poll(() => page.locator('.cm-activeLine').innerText()).toContain('water_depth: 85 m: checked');
  await expect.poll(() => page.locator('.diagnosticlist').innerText()).toMatch(/line 7/);
  await bench.shot(page, 'damaged');
});

async function typeAtEnd(text: string): Promise<void> {
  await page.locator('.cm-content').focus();
  await page.keyboard.press('Control+End');
  await page.keyboard.type(text);
}
const disconnected = () => page.locator('header .status', { hasText: 'no connection to the program' });
const editor = (): Promise<string> => page.locator('.cm-content').innerText();

test('text typed during an interruption is sent afterwards', async () => {
  await showTab(page, 'yaml');
  await page.route('**/api/model**', (route) => route.abort());
  await typeAtEnd('# typed while it was away');
  await disconnected().waitFor({ timeout: 30_000 });
  await expect.poll(() => text()).not.toContain('# typed while it was away');
  await page.unrouteAll();
  await lookAgain();
  await expect.poll(text).toContain('# typed while it was away');
  await disconnected().waitFor({ state: 'detached' });
  await expect.poll(() => editor()).toContain('# typed while it was away');
});

test('the end of the program is reported, and typed text is kept', async () => {
  await bench.halt();
  await lookAgain();
  await disconnected().waitFor({ timeout: 30_000 });
  await typeAtEnd(', and this without it');
  await page.locator('.notice', { hasText: 'The program does not answer' }).first().waitFor({ timeout: 30_000 });
  await page.waitForTimeout(1000); // for anything that would remove the text
  await expect.poll(() => editor()).toContain('# typed while it was away, and this without it');
  await bench.shot(page, 'no-connection');
});
