// Studies of many cases on the page: over one and two keys, one key at a time, operability limits, the study file.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => {
  bench = await start('first-model.yaml');
  page = await bench.open({ width: 1440, height: 900 });
  await solved(page);
  await page.click('#workspace-study');
  await page.selectOption('#st-kind', 'study');
});
afterAll(async () => { await bench?.stop(); });

const pane = (): ReturnType<Page['locator']> => page.locator('section[aria-label="Results of the study"]');
const key = async (index: number, parts: { name?: string; from?: string; to?: string; count?: string; list?: string }): Promise<void> => {
  if (parts.name) await page.fill(`[aria-label="Key ${index}"]`, parts.name);
  for (const part of ['from', 'to', 'count'] as const) if (parts[part] !== undefined) await page.fill(`[aria-label="Key ${index}, ${part}"]`, parts[part]);
  if (parts.list !== undefined) await page.fill(`[aria-label="Values of key ${index}"]`, parts.list);
};
const solve = async (button: RegExp): Promise<void> => {
  await expect.poll(() => page.locator('.studystrip .main').innerText()).toMatch(button);
  await page.click('.studystrip .main');
};

test('an invalid request is reported before it is sent', async () => {
  await key(1, { from: 'much' });
  await expect.poll(() => page.locator('.studystrip .main').isDisabled()).toBe(true);
  await expect.poll(() => page.locator('.studystrip .failuretext').innerText()).toMatch(/enter from, to/);
});

test('a study over one key is run and drawn as a curve', async () => {
  await key(1, { from: '250', to: '350', count: '5' });
  await solve(/^Solve 5 cases/);
  await pane().getByText('5 cases:').waitFor({ timeout: 60_000 });
  await expect.poll(() => page.locator('.studyshown .matrix .point:not(.open)').count(), { timeout: 60_000 }).toBe(5);
  await expect.poll(() => page.locator('[aria-label="Result"] option').first().innerText()).toMatch(/^Utilisation/);
  const [run] = await (await bench.api('runs')).json() as { id: string }[];
  await expect.poll(async () => (await (await bench.api(`runs/${run!.id}/table.csv`)).text()).trim().split('\n').length).toBe(6);
});

test('a case selected in the chart is shown and applied to the model', async () => {
  await page.locator('.studyshown .matrix .point').nth(4).click();
  await expect.poll(() => page.locator('.chosencase').innerText()).toMatch(/tension\s+350 kN/);
  await page.click('.chosencase >> text=Apply to model');
  await expect.poll(async () => (await bench.api('model')).text()).toMatch(/350 kN/);
});

test('two keys make a table, and a case without a solution says so', async () => {
  await key(1, { list: '2 kN, 300 kN' });
  await page.fill('[aria-label="Add a key"]', 'environment.water_depth');
  await key(2, { from: '36', to: '40', count: '3' });
  await solve(/^Solve 6 cases/);
  await pane().getByText('have no solution').waitFor({ timeout: 120_000 });
  await expect.poll(() => page.locator('.casegrid td:not(.open)').count(), { timeout: 60_000 }).toBe(6);
  await expect.poll(() => page.locator('.casegrid td.failed').count()).toBe(3);
  await page.locator('.casegrid td.failed button').first().click();
  await expect.poll(() => page.locator('.chosencase .failuretext').innerText()).toMatch(/tension/i);
  await page.click('#docktab-governing');
  await expect.poll(() => page.locator('.dockpanel').innerText()).toMatch(/no solution/);
  await page.click('#docktab-cases');
  await expect.poll(() => page.locator('.dockpanel tbody tr').count()).toBe(6);
  await bench.shot(page, 'study-grid');
});

test('one key at a time gives the range of each', async () => {
  await page.selectOption('#st-kind', 'each');
  await key(1, { list: '300, 400' });
  await solve(/^Solve 6 cases/);
  await page.locator('.studyshown svg >> text=water depth').waitFor({ timeout: 120_000 });
  await expect.poll(() => page.locator('.studyshown svg').innerHTML()).toMatch(/tensioner\.tension: /);
});

test('the limiting value is found for every other key', async () => {
  await page.selectOption('#st-kind', 'operability');
  await key(1, { list: '200 kN..900 kN/8' });
  await expect.poll(() => page.locator('#st-over').inputValue()).toBe('tensioner.tension');
  await solve(/^Find 3 limits/);
  const rows = page.locator('.studyshown table.limits tbody tr');
  await expect.poll(() => rows.count(), { timeout: 120_000 }).toBe(3);
  await expect.poll(() => page.locator('table.limits').innerText()).toMatch(/Local buckling|Tension|Equivalent|strain|off-rollers|compression|yield/i);
  await bench.shot(page, 'study-limits');
});

test('the study file is shown, and solved as edited', async () => {
  await page.selectOption('#st-kind', 'study');
  await page.click('#docktab-file');
  const file = page.locator('[aria-label="Study file"]');
  await expect.poll(() => file.inputValue()).toMatch(/^overbend_study: 1\n/);
  await file.fill('overbend_study: 1\nbase: m.yaml\nanalysis: static\nsample: {count: 4, keys: {tensioner.tension: {from: 250 kN, to: 350 kN}}}\n');
  await solve(/^Solve the study file/);
  await pane().getByText('4 cases:').waitFor({ timeout: 60_000 });
  await expect.poll(() => page.locator('.studyshown tbody tr').count()).toBe(4);
  await file.fill('overbend_study: 1\nbase: m.yaml\naxes:\n  - {key: tensioner.tenson, values: [1 kN]}\n');
  await page.click('.studystrip .main');
  await expect.poll(() => page.locator('.studystrip .failuretext').innerText()).toMatch(/tensioner\.tenson/);
  await page.click('text=Back to the fields above');
  await expect.poll(() => page.locator('.studystrip .failuretext').count()).toBe(0);
});

test('a study is cancelled and resumed', async () => {
  await key(1, { list: '200 kN..400 kN/2000' });
  await solve(/^Solve 6000 cases/);
  const button = (name: string) => page.locator('.studyprogress').getByRole('button', { name, exact: true }); // the message says "cancelled" too
  await button('Cancel').click({ timeout: 60_000 });
  await button('Resume').click({ timeout: 60_000 });
  await button('Cancel').click({ timeout: 60_000 });
  await button('Resume').waitFor({ timeout: 60_000 });
});

test('a faulty study is rejected with the key and what is expected', async () => {
  const answer = await bench.api('runs', { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify({ kind: 'study', study: 'overbend_study: 1\nbase: x.yaml\nanalysis: static\naxes:\n  - {key: tensioner.tenson, values: [1 kN]}\n' }) });
  expect(answer.status).toBe(422);
  expect(await answer.text()).toMatch(/tensioner\.tension/);
  expect(bench.complaints.filter((c) => !/422|404/.test(c))).toEqual([]);
});
