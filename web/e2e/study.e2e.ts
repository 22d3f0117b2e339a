// Several seeds and a comparison: cancelled and resumed, their tables in Study, their cases in Storm.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { goTo, runToEnd, solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('bgl1-tensioner.yaml', { 'build_up: 60 s': 'build_up: 6 s' }); page = await bench.open({ width: 1440, height: 900 }); await solved(page); }, 60_000);
afterAll(async () => { await bench?.stop(); });

interface Run { id: string; parent: string; state: string }
const list = async (): Promise<Run[]> => await (await bench.api('runs')).json() as Run[];
const order = async (body: object): Promise<string> => ((await (await bench.api('runs', { method: 'POST', body: JSON.stringify(body) })).json()) as { id: string }).id;
const reaches = (id: string, state: RegExp): Promise<void> => expect.poll(async () => (await list()).find((r) => r.id === id)?.state, { timeout: 150_000 }).toMatch(state);

const results = (): ReturnType<Page['locator']> => page.locator('section[aria-label="Seeds or variants"]');
const numbers = async (text: RegExp): Promise<number[]> => (await results().locator('tbody', { hasText: text }).first().locator('td').allInnerTexts()).map(Number);

test('several seeds are cancelled and resumed in the list of runs', async () => {
  const id = await order({ kind: 'seeds', seeds: [1, 2], duration: 10_800 }); // longer than the test, on any machine
  await goTo(page, 'runs');
  await page.locator(`tr[data-run="${id}"] td.name`).click();
  for (const next of ['Resume', 'Delete…']) {
    await reaches(id, /running/);
    await page.locator('.runacts').getByRole('button', { name: 'Cancel', exact: true }).click();
    await reaches(id, /cancelled/);
    await page.locator('.runacts').getByRole('button', { name: next, exact: true }).click();
  }
  await page.locator('.runacts .sure').getByRole('button', { name: 'Delete', exact: true }).click();
  await expect.poll(async () => (await list()).length).toBe(0);
});

test('the table over the seeds is that of the cases', async () => {
  const id = await runToEnd(bench, { kind: 'seeds', seeds: [1, 2], duration: 4 });
  await goTo(page, 'study');
  await page.selectOption('select[aria-label="Study shown"]', id);
  await results().locator('table.study').waitFor();
  await expect.poll(() => results().locator('thead').innerText()).toMatch(/mean\s+std\s+min\s+max/);
  const [mean, , least, most] = await numbers(/^Largest effective tension/);
  const largest = await Promise.all((await list()).filter((r) => r.parent).map(async (r) => (await (await bench.api(`runs/${r.id}/summary`)).json() as { dynamic: { top_tension: { max: number } } }).dynamic.top_tension.max / 1e3));
  expect(largest.length).toBe(2);
  expect(Math.abs(least! - Math.min(...largest))).toBeLessThan(0.06);
  expect(Math.abs(most! - Math.max(...largest))).toBeLessThan(0.06);
  expect(Math.abs(mean! - (largest[0]! + largest[1]!) / 2)).toBeLessThan(0.06);
  await bench.shot(page, 'study-seeds');
});

test('a case of it is a run that can be opened', async () => {
  await results().getByRole('button', { name: 'Seed 2' }).click();
  await page.waitForSelector('.animation');
  await page.locator('.right .standing', { hasText: /seed 2\b/ }).waitFor();
  await expect.poll(() => page.locator('[aria-label="Seed shown"] option:checked').innerText()).toMatch(/seed 2 of 2/);
});

test('modes of the tensioner are compared, with a report', async () => {
  const id = await runToEnd(bench, { kind: 'comparison', of: 'tensioner', duration: 4 });
  await goTo(page, 'study');
  await page.selectOption('select[aria-label="Study shown"]', id);
  await expect.poll(() => results().locator('thead').innerText()).toMatch(/off\s+controlled\s+constant/);
  const [off, , constant] = await numbers(/^Standard deviation of the tension/);
  expect(off!).toBeGreaterThan(1);
  expect(constant!).toBeLessThan(0.01 * off!);
  const report = await bench.api(`runs/${id}/report.html`);
  expect(await report.text()).toMatch(/compared_tensioner/);
  for (const [name, width, height] of [['large', 1920, 1080], ['usual', 1280, 720], ['small', 1024, 768]] as const) {
    await page.setViewportSize({ width, height });
    await expect.poll(() => results().evaluate((el) => el.scrollWidth - el.clientWidth), { message: `the table fits on ${name}` }).toBeLessThanOrEqual(1);
    await bench.shot(page, `study-comparison-${name}`);
  }
  await page.setViewportSize({ width: 1440, height: 900 });
});

test('a study is removed with its cases', async () => {
  await goTo(page, 'runs');
  for (const run of (await list()).filter((r) => !r.parent)) {
    await page.locator(`tr[data-run="${run.id}"] td.name`).click();
    await page.locator('.runacts').getByRole('button', { name: 'Delete…', exact: true }).click();
    await page.locator('.runacts .sure').getByRole('button', { name: 'Delete', exact: true }).click();
    await expect.poll(async () => (await list()).some((r) => r.id === run.id)).toBe(false);
  }
  await expect.poll(() => list()).toEqual([]);
});

test('no errors were logged in the browser', () => expect(bench.complaints).toEqual([]));
