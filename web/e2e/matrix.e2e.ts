// Studies of many cases from the page: over one key and over two, a case opened from the chart, the largest value that passes.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('first-model.yaml'); page = await bench.open({ width: 1440, height: 900 }); await solved(page); await page.click('#tab-study'); });
afterAll(async () => { await bench?.stop(); });

const pane = (): ReturnType<Page['locator']> => page.locator('section[aria-label="Results of the study"]');
const fill = async (index: number, key: string, values: string): Promise<void> => {
  await page.fill(`input[aria-label="Key ${index}"]`, key);
  await page.fill(`input[aria-label="Values of key ${index}"]`, values);
};

test('what cannot be asked for is said before', async () => {
  await fill(1, 'tensioner.tension', 'much..more/3');
  expect(await page.locator('.studyform .main').isDisabled()).toBe(true);
  expect(await page.locator('.studyform .fault').innerText()).toMatch(/values like/);
});

test('a study over one key is run and drawn as a curve', async () => {
  await fill(1, 'tensioner.tension', '250..350/5');
  await page.click('text=Run 5 cases');
  await pane().getByText('5 cases:').waitFor({ timeout: 60_000 });
  await page.waitForSelector('.run.done', { timeout: 60_000 });
  await page.waitForFunction(() => document.querySelectorAll('.matrix .point:not(.open)').length === 5);
  expect(await pane().locator('option').first().innerText()).toMatch(/^static\./);
  const csv = await (await bench.api(`runs/${(await (await bench.api('runs')).json())[0].id}/table.csv`)).text();
  expect(csv.trim().split('\n').length).toBe(6);
});

test('a case that is chosen in the chart is told and put into the model', async () => {
  await pane().locator('.matrix .point').nth(4).click();
  expect(await page.locator('.chosencase').innerText()).toMatch(/tensioner\.tension\s+350 kN/);
  await page.click('text=Open this case');
  await page.waitForFunction(() => !document.querySelector('section[aria-label="Results of the study"]'));
  expect(await (await bench.api('model')).text()).toMatch(/350 kN/);
});

test('two keys make a map, and a case without a solution is hatched', async () => {
  await page.click('#tab-study');
  await page.click('text=Add a key');
  await fill(1, 'tensioner.tension', '2 kN, 300 kN');
  await fill(2, 'environment.water_depth', '36..40/3');
  await page.click('text=Run 6 cases');
  await pane().getByText('have no solution').waitFor({ timeout: 120_000 });
  await page.waitForFunction(() => document.querySelectorAll('.matrix .cell:not(.open)').length === 6, undefined, { timeout: 60_000 });
  expect(await pane().locator('.matrix .cell.failed').count()).toBe(3);
  await pane().locator('.matrix .cell.failed').first().click();
  expect(await page.locator('.chosencase .fault').innerText()).toMatch(/tension/i);
  await bench.shot(page, 'study-map');
});

test('the largest value that passes is found for every other', async () => {
  await page.click('#tab-study');
  await fill(1, 'environment.water_depth', '36..40/3');
  await fill(2, 'tensioner.tension', '200 kN..900 kN/8');
  await page.selectOption('#st-limit', 'tensioner.tension');
  await page.click('text=Find 3 limits');
  await page.waitForSelector('table.limits', { timeout: 120_000 });
  await page.waitForFunction(() => document.querySelectorAll('table.limits tbody tr').length === 3);
  expect(await page.locator('table.limits').innerText()).toMatch(/Local buckling|Tension|Equivalent|strain|off-rollers|compression|yield/i);
  await bench.shot(page, 'study-limits');
});

test('a faulty study is refused with the key and what is expected', async () => {
  const answer = await bench.api('runs', { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify({ kind: 'study', study: 'overbend_study: 1\nbase: x.yaml\nanalysis: static\naxes:\n  - {key: tensioner.tenson, values: [1 kN]}\n' }) });
  expect(answer.status).toBe(422);
  expect(await answer.text()).toMatch(/tensioner\.tension/);
  expect(bench.complaints.filter((c) => !c.includes('422'))).toEqual([]);
});
