// Search in the YAML: by Ctrl+F from anywhere on the page, also for lines that are not rendered.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { showTab, solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('bgl1.yaml'); page = await bench.open(); await solved(page); await showTab(page, 'yaml'); await page.locator('.cm-content').waitFor(); });
afterAll(async () => { await bench?.stop(); });

test('a word far below is found and shown', async () => {
  await expect.poll(() => page.locator('.cm-content').innerText()).not.toMatch(/partial_factors|convention|duration/);
  await page.keyboard.press('Control+f');
  await page.locator('.cm-search input[name=search]').waitFor();
  await page.keyboard.type('duration');
  await page.keyboard.press('Enter');
  await page.locator('.cm-searchMatch-selected').waitFor();
  await expect.poll(() => page.locator('.cm-searchMatch-selected').innerText()).toBe('duration');
  await bench.shot(page, 'yaml-search');
});

test('all parts of the search are reachable in a narrow pane', async () => {
  const pane = (await page.locator('.editor').boundingBox())!;
  for (const button of await page.locator('.cm-search button, .cm-search input').all()) {
    const box = (await button.boundingBox())!;
    expect(box.x).toBeGreaterThanOrEqual(pane.x - 1);
    expect(box.x + box.width).toBeLessThanOrEqual(pane.x + pane.width + 1);
  }
});

test('replacements are in the model, and Escape closes the search', async () => {
  await page.fill('.cm-search input[name=search]', 'title:');
  await page.fill('.cm-search input[name=replace]', 'title: Searched');
  await page.click('.cm-search button[name=replaceAll]');
  await expect.poll(async () => (await (await bench.api('model')).json() as { text: string }).text).toMatch(/^title: Searched/m);
  await page.locator('.cm-search input[name=search]').press('Escape');
  await expect.poll(() => page.locator('.cm-search').count()).toBe(0);
});

test('no errors were logged in the browser', () => expect(bench.complaints).toEqual([]));
