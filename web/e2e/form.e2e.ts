// Properties of objects: vessel motion, fields required by a sea state, errors that name their key and lead to it.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { goTo, openField, root, selectObject, solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('bgl1.yaml'); page = await bench.open({ width: 1280, height: 620 }); await solved(page); });
afterAll(async () => { await bench?.stop(); });

const text = async (): Promise<string> => (await (await bench.api('model')).json() as { text: string }).text;
const put = async (next: string): Promise<void> => {
  const { revision } = await (await bench.api('model')).json() as { revision: number };
  expect((await bench.api('model', { method: 'PUT', body: JSON.stringify({ text: next, revision }) })).status).toBe(200);
};
const id = (path: string): string => `[id="f-${path}"]`;

test('motion is chosen: harmonic, fixed, a file of the folder, a file of this machine', async () => {
  await selectObject(page, 'vessel');
  const kind = page.locator('#motion-kind');
  await expect.poll(() => kind.inputValue()).toBe('raos');
  await kind.selectOption('harmonic');
  await page.waitForSelector(id('vessel.motion.harmonic.heave.amplitude'));
  await page.fill(id('vessel.motion.harmonic.heave.amplitude'), '0.7 m');
  await page.keyboard.press('Enter');
  await expect.poll(text).toMatch(/motion: *\{? *\n? *harmonic:[\s\S]*amplitude: 0\.7 m/);
  await kind.selectOption('fixed');
  await expect.poll(text).toMatch(/motion: fixed/);

  await kind.selectOption('history');
  writeFileSync(join(bench.folder, 'heave.csv'), 'time_s,heave_m\n0,0\n5,0.4\n10,0\n');
  await page.setInputFiles('[aria-label="Upload a file"]', { name: 'pitch.csv', mimeType: 'text/csv', buffer: Buffer.from('time_s,pitch_deg\n0,0\n5,0.4\n10,0\n') });
  await expect.poll(text).toMatch(/history: pitch\.csv/);
  await expect.poll(() => page.locator('#motion-file option').allInnerTexts()).toContain('heave.csv');
  await page.selectOption('#motion-file', 'heave.csv');
  await expect.poll(text).toMatch(/history: heave\.csv/);

  await kind.selectOption('raos');
  await page.setInputFiles('[aria-label="Upload a file"]', join(bench.folder, '../data/bgl1/rao.csv'));
  await expect.poll(text).toMatch(/raos: rao\.csv/);
  await solved(page);
  await bench.shot(page, 'motion');
});

/** Answers to changed values arrive late. */
const late = async (seen: () => void): Promise<void> => {
  await page.route((url) => url.pathname === '/api/model/set', async (route) => {
    seen();
    await new Promise((done) => setTimeout(done, 700));
    await route.continue().catch(() => undefined);
  });
};

test('a selection made while an answer is pending is kept', async () => {
  const kind = page.locator('#motion-kind');
  let held = 0;
  await late(() => { ++held; });
  await kind.selectOption('fixed');
  await kind.selectOption('history');
  await expect.poll(text).toMatch(/motion: fixed/);
  await solved(page);
  await expect.poll(() => kind.inputValue()).toBe('history');
  await page.unrouteAll();
  expect(held).toBe(1);
  await kind.selectOption('fixed');
  await expect.poll(() => page.locator('[aria-label="Upload a file"]').count()).toBe(0);
  await kind.selectOption('raos');
  await page.setInputFiles('[aria-label="Upload a file"]', join(bench.folder, '../data/bgl1/rao.csv'));
  await expect.poll(text).toMatch(/raos: rao\.csv/);
  await solved(page);
});

test('a file is taken by its contents, regardless of its name, byte for byte', async () => {
  const upload = '[aria-label="Upload a file"]', hulls = join(root, 'validation', 'hull_files');
  await page.locator('#motion-kind').selectOption('coupled');
  await page.setInputFiles(upload, { name: 'barge 2026.txt', mimeType: 'text/plain', buffer: readFileSync(join(hulls, 'wamit-out/barge.out')) });
  await expect.poll(text).toMatch(/hydrodynamics: .?barge 2026\.txt/);
  await page.setInputFiles(upload, join(hulls, 'bemio/barge.h5'));
  await expect.poll(text).toMatch(/hydrodynamics: barge\.h5/);
  expect(readFileSync(join(bench.folder, 'barge.h5')).equals(readFileSync(join(hulls, 'bemio/barge.h5')))).toBe(true);
  await page.setInputFiles(upload, { name: 'sea.csv', mimeType: 'text/csv', buffer: Buffer.from('omega_rad_s,density_m2s\n0.4,0\n0.8,1\n') });
  await expect.poll(() => page.locator('.notices').innerText()).toMatch(/sea\.csv: not the hydrodynamics of a hull/);
  await page.locator('#motion-kind').selectOption('raos');
  await page.setInputFiles(upload, join(bench.folder, '../data/bgl1/rao.csv'));
  await expect.poll(text).toMatch(/raos: rao\.csv/);
  await solved(page);
});

test('a new model offers motion and waves without a search', async () => {
  const before = await text();
  await put(before.replace(/\n *motion:.*/, '').replace(/\n *waves:(.*\n)( {4,}.*\n)*/, '\n'));
  await expect.poll(() => page.locator('#motion-kind').inputValue()).toBe('');
  await selectObject(page, 'environment');
  await expect.poll(() => page.locator('[data-path="environment.waves"] .fold').first().isVisible()).toBe(true);
  await put(before);
  await solved(page);
});

test('a spectrum always shows Hs and Tp, a regular wave its height and period', async () => {
  await (await openField(page, 'environment.waves.type')).selectOption('airy');
  await page.waitForSelector(id('environment.waves.height'));
  await put((await text()).replace(/\n *hs:.*|\n *tp:.*/g, '').replace(/, hs: [^,}]*|, tp: [^,}]*/g, ''));
  await expect.poll(() => page.locator(id('environment.waves.hs')).count()).toBe(0);
  await page.selectOption(id('environment.waves.type'), 'jonswap');
  await page.waitForSelector(id('environment.waves.tp'));
  await page.fill(id('environment.waves.hs'), '2');
  await page.keyboard.press('Enter');
  await page.fill(id('environment.waves.tp'), '8 s');
  await page.keyboard.press('Enter');
  await expect.poll(text).toMatch(/hs: 2 m/);
  await solved(page);
});

test('a value out of its range is rejected at its field, with a message', async () => {
  await (await openField(page, 'tensioner.tension')).fill('-5 kN');
  await page.keyboard.press('Enter');
  const row = page.locator('.row.wrong', { has: page.locator(id('tensioner.tension')) });
  await row.waitFor();
  await expect.poll(() => row.locator('.failuretext').innerText()).toMatch(/-5 kN.*above 0 kN/);
  await expect.poll(() => page.locator('header .status').innerText()).toMatch(/1 error: tensioner tension/);
  await bench.shot(page, 'range-error');
});

test('an error leads to its field from any selection and workspace', async () => {
  await selectObject(page, 'pipe');
  await expect.poll(() => page.locator(id('tensioner.tension')).count()).toBe(0);
  await goTo(page, 'storm');
  await expect.poll(() => page.locator('.strip').innerText()).toMatch(/error[\s\S]*tensioner/);
  await page.click('header .status.bad');
  await page.waitForFunction(() => document.activeElement?.id === 'f-tensioner.tension');
  await page.keyboard.type('250');
  await page.fill(id('tensioner.tension'), '250');
  await page.keyboard.press('Enter');
  await solved(page);
  await expect.poll(() => page.locator(id('tensioner.tension')).inputValue()).toBe('250 kN');
});

test('a number without unit takes the previous unit, in the dialog and in the properties', async () => {
  await (await openField(page, 'environment.water_depth')).fill('300 ft');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => (document.querySelector('[id="f-environment.water_depth"] ~ .twin') as HTMLElement).innerText === '91.44 m');
  await page.fill(id('environment.water_depth'), '290');
  await page.keyboard.press('Enter');
  await expect.poll(text).toContain('water_depth: 290 ft');
  await page.click('header >> text=New…');
  await page.click('dialog >> text=Continue without saving');
  await page.waitForSelector('#n-depth');
  await page.fill('#n-depth', '300 ft');
  await page.press('#n-depth', 'Tab');
  await page.fill('#n-depth', '290');
  await page.press('#n-depth', 'Tab');
  await expect.poll(() => page.locator('#n-depth').inputValue()).toBe('290 ft');
  await expect.poll(() => page.locator('dialog .failuretext').count()).toBe(0);
  await page.keyboard.press('Escape');
});

test('text typed while an answer is pending is kept, with the unit of the previous value', async () => {
  let held = 0;
  await late(() => { ++held; });
  const depth = page.locator(id('environment.water_depth'));
  await depth.fill('302 ft');
  await depth.press('Enter');
  await depth.fill('291');
  await expect.poll(text).toContain('water_depth: 302 ft');
  await expect.poll(() => depth.getAttribute('data-written')).toBe('302 ft');
  await expect.poll(() => depth.inputValue()).toBe('291');
  await depth.press('Enter');
  await expect.poll(text, { timeout: 5000 }).toContain('water_depth: 291 ft');
  await depth.fill('92 m');
  await depth.press('Enter');
  await depth.fill('93');
  await depth.press('Enter');
  await expect.poll(text, { timeout: 5000 }).toContain('water_depth: 93 m');
  await expect.poll(() => depth.inputValue()).toBe('93 m');
  await page.unrouteAll();
  expect(held).toBeGreaterThanOrEqual(4);
  await solved(page);
});

test('an answer to an earlier value does not overwrite later text, and a restored value is sent', async () => {
  await late(() => undefined);
  const depth = page.locator(id('environment.water_depth'));
  for (const value of ['80 m', '81 m']) { await depth.fill(value); await depth.press('Enter'); }
  await depth.fill('82');
  for (const value of ['80 m', '81 m']) {
    await expect.poll(() => depth.getAttribute('data-written'), { interval: 20 }).toBe(value);
    await expect.poll(() => depth.inputValue()).toBe('82');
  }
  await depth.press('Enter');
  await depth.fill('81 m');
  await depth.press('Enter');
  await expect.poll(() => depth.getAttribute('data-written'), { interval: 20 }).toBe('82 m');
  await expect.poll(() => depth.getAttribute('data-written'), { timeout: 5000 }).toBe('81 m');
  await expect.poll(() => depth.inputValue()).toBe('81 m');
  await page.unrouteAll();
  await solved(page);
});

test('no errors were logged in the browser', () => expect(bench.complaints).toEqual([]));
