// Lay tables on the page: depth by tension with a cell opened in Lay, and a table over one key.
import { readFileSync } from 'node:fs';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { goTo, solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => {
  bench = await start('first-model.yaml');
  page = await bench.open({ width: 1440, height: 900 });
  await solved(page);
  await goTo(page, 'study');
  await page.fill('[aria-label="rows: water depth, number"]', '5');
  await page.fill('[aria-label="columns: tension, number"]', '8');
  await page.click('.studystrip .main');
  await page.locator('text=/^40 cases: /').waitFor({ timeout: 120_000 });
  await bench.shot(page, 'study-lay-grid');
}, 200_000);
afterAll(async () => { await bench?.stop(); });

const cells = (): ReturnType<Page['locator']> => page.locator('.casegrid td');

test('every depth has its permissible tensions for the given limit', async () => {
  const table = page.locator('section[aria-label="Permissible tensions"] table');
  await expect.poll(() => table.locator('tbody tr').count()).toBe(5);
  const before = await table.innerText();
  await page.fill('#lt-utilisation', '0.75');
  await page.keyboard.press('Tab');
  await expect.poll(() => table.innerText()).not.toBe(before);
  await expect.poll(() => page.locator('.casegrid td.beyond').count()).toBeGreaterThan(0);
  await page.fill('#lt-utilisation', '1');
  await page.keyboard.press('Tab');
});

test('a cell is reached with the arrow keys, shows its case, and opens it in Lay without a change of the model', async () => {
  await cells().first().locator('button').focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  const card = page.locator('.chosencase');
  const tension = /tension\s+(\d+) kN/.exec(await card.innerText())![1]!;
  const text = await (await bench.api('model')).text();
  await card.locator('text=Open in Lay').click();
  expect(page.url()).toContain('#/lay');
  await expect.poll(() => page.locator('aside.right').innerText()).toMatch(new RegExp(`top tension[^\\d]*${tension}\\b`));
  expect(await (await bench.api('model')).text()).toBe(text);
});

test('applying a case to the model is one undo step', async () => {
  const text = await (await bench.api('model')).json() as { text: string };
  await page.click('#workspace-study');
  await cells().nth(15).locator('button').click();
  await page.locator('.chosencase >> text=Apply to model').click();
  await expect.poll(async () => ((await (await bench.api('model')).json()) as { text: string }).text).not.toBe(text.text);
  await page.locator('text=The model has changed since: solve again').waitFor();
  await page.click('[aria-label="Undo"]');
  await expect.poll(async () => ((await (await bench.api('model')).json()) as { text: string }).text).toBe(text.text);
});

test('the map of the same cases is saved as drawing and picture', async () => {
  await page.click('.studyhead >> text=map');
  await page.locator('.matrix .cell').first().waitFor();
  for (const [kind, head] of [['SVG', '<svg'], ['PNG', '\u0089PNG']] as const) {
    const [file] = await Promise.all([page.waitForEvent('download'), page.locator(`.studyfiles >> text=${kind}`).click()]);
    expect(readFileSync(await file.path(), 'latin1').startsWith(head)).toBe(true);
  }
  await page.click('.studyhead >> text=table');
});

test('the picture is shown next to the table on demand', async () => {
  await page.click('.studyhead >> text=Picture');
  await expect.poll(() => page.locator('.centre').isVisible()).toBe(true);
  await page.click('.studyhead >> text=Picture');
  await expect.poll(() => page.locator('.centre').isVisible()).toBe(false);
});

test('of a table over one key, an invalid request is reported before it is sent', async () => {
  await page.selectOption('#lt-over', 'tension');
  await page.fill('[aria-label="from … to, in steps, to"]', '400');
  await expect.poll(() => page.locator('.studystrip .main').isDisabled()).toBe(true);
  await expect.poll(() => page.locator('.studystrip .failuretext').innerText()).toMatch(/unit/);
});

test('a table over tension has its rows, curves and downloads', async () => {
  await page.fill('[aria-label="from … to, in steps, from"]', '250 kN');
  await page.fill('[aria-label="from … to, in steps, to"]', '400 kN');
  await page.fill('[aria-label="from … to, in steps, steps"]', '3');
  await page.click('.studystrip .main');
  const rows = page.locator('.studyshown table.lay-rows tbody tr');
  await rows.first().waitFor({ timeout: 60_000 });
  await expect.poll(() => rows.count()).toBeGreaterThanOrEqual(4);
  await expect.poll(() => page.locator('.studyshown table.lay-rows thead').innerText()).toMatch(/top\s+tension/);
  await page.click('#docktab-curves');
  await expect.poll(() => page.locator('.laycurves svg').count()).toBeGreaterThan(4);
  const book = await bench.api('lay-table.xlsx');
  expect(book.status).toBe(200);
  expect(new TextDecoder('latin1').decode((await book.arrayBuffer()).slice(0, 2))).toBe('PK');
  expect(await (await bench.api('lay-table.csv')).text()).toMatch(/^row,tension \[kN\]/);
  await page.locator('.studyshown .linkname').last().click();
  expect(page.url()).toContain('#/lay');
});

test('an earlier study of the folder is shown again', async () => {
  await page.click('#workspace-study');
  const earlier = await page.locator('[aria-label="Study shown"] option').nth(1).getAttribute('value');
  await page.selectOption('[aria-label="Study shown"]', earlier!);
  await expect.poll(() => cells().count()).toBe(40);
});
