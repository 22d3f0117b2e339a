// A model of another program is opened: it is translated, solved, and the page says what was left out.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { reading, root, solved, start, type Bench } from './harness';

const cases = join(root, 'validation', 'orcaflex_cases');
let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('bgl1.yaml'); page = await bench.open(); await solved(page); });
afterAll(async () => { await bench?.stop(); });

async function openFiles(...names: string[]): Promise<void> {
  await page.click('header >> text=Open…');
  await page.waitForSelector('dialog');
  const unsaved = page.locator('text=Continue without saving');
  if (await unsaved.isVisible()) await unsaved.click();
  await page.setInputFiles('[aria-label="Open files of this computer"]', names.map((name) => join(cases, name)));
}

test('an OrcaFlex file is opened as a new model and solved', async () => {
  await openFiles('slay-simple.yml');
  await page.waitForSelector('dialog[aria-label="Imported from slay-simple.yml"]');
  const account = await page.locator('dialog .account').innerText();
  expect(account).toMatch(/9 supports/);
  expect(account).toMatch(/yield stress of the steel: the file has none/);
  await bench.shot(page, 'import');
  await page.click('dialog button.main');
  await expect.poll(() => reading(page, 'top tension'), { timeout: 30_000 }).toBeCloseTo(225.0, 1);
});

test('a file in parts is opened with all of them', async () => {
  await openFiles('jumper-general.yml');
  await page.waitForSelector('dialog[aria-label="Imported from jumper-general.yml"]');
  await page.click('dialog button.main');
  await expect.poll(async () => (await (await bench.api('model')).json() as { text: string }).text).toContain('name: "Jumper"');
});

test('a damaged file is rejected with its line, and the model stays', async () => {
  const before = (await (await bench.api('model')).json() as { text: string }).text;
  await openFiles('of-unit-unknown.yml');
  await expect.poll(() => page.locator('.notices').innerText()).toMatch(/of-unit-unknown\.yml:12.*cubit/);
  expect((await (await bench.api('model')).json() as { text: string }).text).toBe(before);
  expect(readFileSync(join(cases, 'of-unit-unknown.yml'), 'utf8')).toContain('cubit');
});
