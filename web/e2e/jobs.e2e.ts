// Usability tasks of the page, each within its number of user actions.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, afterEach, beforeAll, expect, test } from 'vitest';
import type { Locator, Page } from 'playwright-core';
import { goTo, reading, solved, start, type Bench } from './harness';
import { User } from './user';

interface Printed { printed?: { title: string; drawn: boolean; charts: number; wide: number } }
interface Model { text: string; revision: number; fields: { path: string; value: string | null; count?: number }[] }

let bench: Bench;
let page: Page;
let user: User;
let original = '';

/** Records what the report would print, instead of a system dialog. */
async function notePrint(p: Page): Promise<void> { await p.addInitScript(() => {
  window.print = () => {
    const drawn = document.documentElement.dataset.drawn === 'yes', charts = document.querySelectorAll('svg, canvas').length;
    (window.top as unknown as Printed).printed = { title: document.title, drawn, charts, wide: innerWidth };
  };
}); }

beforeAll(async () => {
  bench = await start('bgl1.yaml');
  page = await bench.open({ width: 1440, height: 900 }, notePrint);
  user = new User(page);
  original = readFileSync(join(bench.folder, 'bgl1.yaml'), 'utf8');
  await solved(page);
}, 60_000);
afterAll(async () => { await bench?.stop(); });
afterEach(() => { user = new User(page); });

const model = async (): Promise<Model> => await (await bench.api('model')).json() as Model;
const text = async (): Promise<string> => (await model()).text;
const value = async (path: string): Promise<string | null> => (await model()).fields.find((f) => f.path === path)?.value ?? null;
async function put(next: string): Promise<void> {
  const { revision } = await model();
  expect((await bench.api('model', { method: 'PUT', body: JSON.stringify({ text: next, revision }) })).status).toBe(200);
}
/** Restores the text of the file, in Lay. */
async function startAnew(): Promise<void> {
  if (await text() !== original) await put(original);
  await goTo(page, 'lay');
  await solved(page);
  await expect.poll(() => reading(page, 'top tension'), { timeout: 20_000 }).toBeCloseTo(250, 0);
}

test('the tension for a utilisation of 0.9 takes four actions', async () => {
  await user.click('.pinned >> text=Goal seek …');
  await user.type('#s-value', '0.9');
  await user.click('dialog button.main:has-text("Find")');
  await user.click('dialog button.main:has-text("Apply")');
  await page.waitForSelector('dialog', { state: 'detached' });
  await expect.poll(text).toMatch(/tension: 185\.\d+ kN/);
  await expect.poll(async () => Number.parseFloat(await page.locator('.verdict .used').innerText()), { timeout: 20_000 }).toBeCloseTo(0.9, 2);
  expect(user.actions).toBeLessThanOrEqual(4);
  await page.click('[aria-label=Undo]');
  await expect.poll(text).toBe(original);
});

/** Names of the stinger boxes in the picture. */
const drawn = (): Promise<string[]> => page.evaluate(() => {
  interface Roller { support: { name: string; structure: string } }
  const { stage } = (window as unknown as { __view: { stage: { rollers: { list: Roller[] } } } }).__view;
  return [...new Set(stage.rollers.list.filter((r) => r.support.structure === 'stinger').map((r) => r.support.name))];
});

test('a stinger from a spreadsheet takes three actions, and picture and results follow', async () => {
  await startAnew();
  const rows = Array.from({ length: 9 }, (_none, i) => `S${i + 1}\t${(5.2 + 3.8 * i).toFixed(3).replace('.', ',')}\t${(-4.578 - 1.25 * i - 0.05 * i * i).toFixed(3).replace('.', ',')}\t4`);
  await user.click('#docktab-boxes');
  await page.locator('[role=grid]').waitFor();
  await user.paste(['Box\tX (m)\tElevation [m]\tlength [m]', ...rows].join('\r\n'));
  await user.click('.gridstrip button.main');
  await expect.poll(async () => (await model()).fields.find((f) => f.path === 'supports.stinger.boxes')?.count).toBe(9);
  expect(user.actions).toBeLessThanOrEqual(3);
  await expect.poll(() => value('supports.stinger.boxes[8].x')).toBe('35.600 m');
  await expect.poll(() => value('supports.stinger.boxes[8].name')).toBe('S9');
  const row = page.locator('[role=grid] tr', { has: page.locator('td[data-path="supports.stinger.boxes[0].name"]') });
  await expect.poll(() => row.locator('td.result').allInnerTexts(), { timeout: 20_000 }).toContainEqual(expect.stringMatching(/\d/));
  await expect.poll(drawn, { timeout: 20_000 }).toContain('S9');
  await page.keyboard.press('Control+z');
  await expect.poll(text).toBe(original);
  await expect.poll(drawn, { timeout: 20_000 }).toContain('stinger 8');
});

test('an abandonment is designed in five actions', async () => {
  await startAnew();
  await user.click('#workspace-operation');
  await user.click('.offers >> text=Abandonment');
  await user.click('text=Design the procedure');
  await expect.poll(text).toMatch(/tension: seek/);
  const rows = (): Promise<string[][]> => page.locator('table.stages tbody tr')
    .evaluateAll((all) => all.map((row) => [...row.children].map((cell) => (cell as HTMLElement).innerText.trim())));
  await expect.poll(async () => (await rows()).length, { timeout: 180_000 }).toBe(11);
  await expect.poll(() => page.locator('.opstrip .main').innerText(), { timeout: 180_000 }).toBe('Solve 11 stages');
  expect(user.actions).toBeLessThanOrEqual(5);
  const heads = await page.locator('table.stages thead tr').last().locator('th').allInnerTexts();
  const column = (name: string): number => heads.findIndex((h) => h.startsWith(name));
  const shown = await rows();
  expect(Math.max(...shown.map((r) => Number(r[column('use')])))).toBeLessThanOrEqual(0.9);
  expect(Number(shown.at(-1)![column('top')])).toBeLessThan(Number(shown[0]![column('top')]));
  expect(Number(shown.at(-1)![column('head z')])).toBeLessThan(-88);
  await bench.shot(page, 'job-abandonment');
}, 400_000);

test('an error in YAML is found and corrected in two actions', async () => {
  await startAnew();
  await put(original.replace('  water_depth: 89 m', '  water_depth: 89 m: checked'));
  await user.click('header .status.bad');
  await page.waitForFunction(() => document.activeElement?.classList.contains('cm-content'));
  await expect.poll(() => page.locator('.cm-activeLine').innerText()).toContain('water_depth: 89 m: checked');
  await user.retypeLine('  water_depth: 89 m');
  await expect.poll(text).toBe(original);
  await solved(page);
  expect(user.actions).toBeLessThanOrEqual(2);
});

test('the report is a PDF after three actions, with its figures drawn', async () => {
  await startAnew();
  await user.click('#workspace-report');
  await user.click('.reportfiles >> text=PDF');
  const printed = (): Promise<Printed['printed']> => page.evaluate(() => (window as unknown as Printed).printed);
  await expect.poll(printed, { timeout: 60_000 }).toMatchObject({ drawn: true, wide: 1000 });
  expect(user.actions).toBeLessThanOrEqual(3);
  expect((await printed())!.title).toMatch(/BGL-1/);
  expect((await printed())!.charts).toBeGreaterThan(3);
});

let untilModel = 0;

test('a new model has its first static answer after three actions', async () => {
  await startAnew();
  await page.keyboard.press('Control+s'); // otherwise the page asks whether to save the changes
  await page.waitForSelector('h1 i', { state: 'detached' });
  await user.click('header >> text=New…');
  await user.type('dialog #n-depth', '80 m');
  await user.click('dialog button.main');
  await page.waitForSelector('dialog', { state: 'detached' });
  await expect.poll(() => value('environment.water_depth')).toBe('80 m');
  await expect.poll(() => reading(page, 'top tension'), { timeout: 20_000 }).not.toBeCloseTo(250, 0);
  await solved(page);
  expect(user.actions).toBeLessThanOrEqual(3);
  untilModel = user.actions;
});

test('a lay table of 5 depths by 8 tensions is in a workbook after six actions', async () => {
  await user.click('#workspace-study');
  await user.type('[aria-label="rows: water depth, number"]', '5');
  await user.type('[aria-label="columns: tension, number"]', '8');
  await expect.poll(() => page.locator('.studystrip .main').innerText()).toMatch(/^Solve 40 cases/);
  await user.click('.studystrip .main');
  await page.locator('text=/^40 cases: /').waitFor({ timeout: 180_000 });
  const saved = page.waitForEvent('download');
  await user.click('.studyfiles >> text=XLSX');
  const file = await (await saved).path();
  expect(user.actions).toBeLessThanOrEqual(6);
  expect(readFileSync(file).subarray(0, 2).toString()).toBe('PK');
  const names = execFileSync('python3', ['-c', 'import sys, zipfile\nprint(zipfile.ZipFile(sys.argv[1]).read("xl/workbook.xml").decode())', file], { encoding: 'utf8' });
  expect(names).toMatch(/Utilisation.*Governing check.*Tensions.*Cases/);
}, 300_000);

test('a new model gets to a storm with a library hull in six actions', async () => {
  user.actions = untilModel;
  const run = (): Locator => page.locator('.stormacts button.main');
  await user.click('#workspace-storm');
  await user.click(page.getByRole('button', { name: 'Set up a storm' }));
  await run().filter({ hasText: 'Run 3 h' }).waitFor();
  await user.click(run());
  await page.waitForSelector('.stormbar [role=progressbar]');
  expect(user.actions).toBeLessThanOrEqual(6);
  await expect.poll(() => text()).toMatch(/raos: box-hull-\d/);
  const runs = await (await bench.api('runs')).json() as { kind: string; state: string }[];
  expect(runs.filter((r) => r.kind === 'dynamic').map((r) => r.state)).toEqual(['running']);
  await page.locator('.stormbar').getByRole('button', { name: 'Cancel' }).click();
  await page.waitForFunction(() => !document.querySelector('.stormbar [role=progressbar]'), undefined, { timeout: 60_000 });
}, 150_000);

test('the worst impact of a run is seen in the picture after three actions, and marked', async () => {
  const sea = await start('bgl1-workable-sea.yaml', { 'seed: 1': 'seed: 3', 'duration: 10800 s, build_up: 60 s': 'duration: 20 s, build_up: 60 s' });
  try {
    const shown = await sea.open({ width: 1440, height: 900 });
    await solved(shown);
    await goTo(shown, 'storm');
    await shown.locator('.stormacts button.main').click();
    await shown.waitForSelector('.animation', { timeout: 240_000 });
    const worker = new User(shown), id = (await (await sea.api('runs')).json() as { id: string }[])[0]!.id;
    await worker.click(shown.getByRole('button', { name: 'worst impact' }));
    expect(worker.actions).toBeLessThanOrEqual(3);
    const { impacts } = await (await sea.api(`runs/${id}/impacts`)).json() as { impacts: { time: number; support: string; peak_force: number }[] };
    const worst = impacts.reduce((a, b) => (b.peak_force > a.peak_force ? b : a));
    await expect.poll(() => shown.locator('.caption').innerText()).toContain(`worst impact: ${worst.support}`);
    await expect.poll(async () => Math.abs(Number.parseFloat(await shown.locator('.clock').innerText()) - worst.time)).toBeLessThan(0.11);
    await shown.waitForFunction(() => Number((document.querySelector('.legend') as HTMLElement).dataset.flashes) > 0);
    await expect.poll(() => shown.locator('.label3d.chosen').innerText()).toBe(worst.support);
    await sea.shot(shown, 'job-worst-impact');
  } finally { await sea.stop(); }
}, 400_000);

test('no errors were logged in the browser', () => expect(bench.complaints.filter((c) => !/model\/disk|422/.test(c))).toEqual([]));
