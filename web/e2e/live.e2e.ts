// Live statics, properties and YAML, reload and two tabs, with BGL-1.
import { readFileSync } from 'node:fs';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { openField, reading, rested, showTab, solved, start, takesPictures, tryValue, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('bgl1.yaml'); page = await bench.open(); await solved(page); });
afterAll(async () => { await bench?.stop(); });

/** Pins a key under the picture and returns its value. */
async function pin(p: Page, name: string): Promise<number> {
  await p.click('.pinned >> text=Pin a key');
  await p.fill('#find-pin', name);
  await p.locator('dialog [role=option]', { hasText: name }).first().click();
  return Number(await p.getByRole('slider', { name, exact: true }).inputValue());
}

/** Moves the cursor of the editor to a line by keyboard: only visible lines are in the page. */
async function line(number: number): Promise<void> {
  await page.waitForSelector('.cm-content');
  await page.locator('.cm-content').focus();
  await page.keyboard.press('Control+Home');
  for (let i = 1; i < number; ++i) await page.keyboard.press('ArrowDown');
}

test('the known solution', async () => {
  await expect.poll(() => reading(page, 'top tension')).toBeCloseTo(250, 0);
  await expect.poll(() => reading(page, 'lay-back')).toBeCloseTo(335.6, 0);
  await page.waitForTimeout(700);
  await bench.shot(page, 'bgl1');
});

test('code checks are shown by region, and colour the pipe', async () => {
  await showTab(page, 'checks');
  const panel = page.locator('section[aria-label="Code checks"]');
  await expect.poll(() => panel.locator('.region').first().innerText()).toMatch(/overbend\s+0\.\d+/);
  await expect.poll(() => panel.locator('.region').allInnerTexts()).toHaveLength(5);
  await expect.poll(() => panel.locator('tbody tr').count()).toBeGreaterThan(15);
  await expect.poll(() => panel.innerText()).toMatch(/Laying criterion II[\s\S]*not done/);
  await page.selectOption('[aria-label="Colour of the pipe"]', 'checks');
  await page.waitForFunction(() => Number.parseFloat((document.querySelector('.legend .ends span:last-child') as HTMLElement).innerText) < 5);
  await page.waitForTimeout(700);
  await bench.shot(page, 'checks');
  await page.selectOption('[aria-label="Colour of the pipe"]', 'von_mises');
});

test('the card shows the verdict and the governing check, and leads to its calculation', async () => {
  const card = page.locator('.right .verdict');
  await expect.poll(() => card.locator('h2').innerText()).toMatch(/^(Passes|Fails)/);
  const used = await card.locator('.used').innerText();
  expect(used).toMatch(/^\d+\.\d+$/);
  const governing = (await card.locator('.governing').innerText()).replace(/^governing: /, '').replace(/ in the .*/, '');
  await showTab(page, 'diagrams');
  await card.locator('text=calculation sheet').click();
  const sheet = page.locator('.checks button.fold[aria-expanded=true]', { hasText: governing });
  await sheet.waitFor();
  // its last line is the utilisation on the card
  await expect.poll(() => page.locator('.checks tr:has(button.fold[aria-expanded=true]) + tr').first().innerText()).toMatch(new RegExp(`utilisation[\\s\\S]*${used.replace('.', '\\.')}`));
});

test('tables of results are sorted, lead to their objects, and are saved', async () => {
  await showTab(page, 'tables');
  const tables = page.locator('section[aria-label="Tables of results"]');
  await tables.locator('summary', { hasText: 'Roller boxes' }).click();
  await tables.locator('button.sort', { hasText: 'resultant' }).click();
  const column = await tables.locator('th', { hasText: 'resultant' }).evaluate((head) => (head as HTMLTableCellElement).cellIndex);
  const reactions = (await tables.locator(`tbody tr td:nth-child(${column + 1})`).allInnerTexts()).map(Number);
  expect(reactions).toEqual([...reactions].sort((a, b) => b - a));
  await tables.locator('.linkname', { hasText: 'stinger 8' }).click();
  await page.waitForSelector('.properties[data-object="supports.stinger.boxes[7]"]');
  const [file] = await Promise.all([page.waitForEvent('download'), tables.locator('button', { hasText: 'csv' }).click()]);
  expect(file.suggestedFilename()).toBe('boxes.csv');
  expect(readFileSync((await file.path())!, 'utf8')).toMatch(/^Box,On,X \[m\],.*\r\n/);
  await showTab(page, 'diagrams');
  await expect.poll(() => page.locator('.slot .read').first().innerText()).toMatch(/^stinger 8,/);
});

test.runIf(takesPictures)('a picture for the guide', async () => {
  const guide = await bench.open({ width: 1600, height: 900 });
  await solved(guide);
  await guide.click('.viewbuttons >> text=overbend');
  await guide.waitForTimeout(3000);
  await bench.shot(guide, 'serve-bgl1');
  await guide.close();
});

test('dragging the tension gives another S', async () => {
  await tryValue(page, 'tension', 400);
  await expect.poll(() => reading(page, 'lay-back')).toBeGreaterThan(380);
  await expect.poll(() => reading(page, 'top tension')).toBeCloseTo(400, 0);
});

test('a case without solution shows the reason and keeps the last solution', async () => {
  await tryValue(page, 'tension', 250);
  await expect.poll(() => reading(page, 'top tension')).toBeCloseTo(250, 0);
  await page.fill('[aria-label="tension, typed"]', '1 kN');
  await page.keyboard.press('Enter');
  await page.waitForSelector('.verdict.unsolved', { timeout: 60_000 });
  await bench.shot(page, 'no-solution');
  expect((await page.locator('.verdict.unsolved').innerText()).length).toBeGreaterThan(40);
  await expect.poll(() => page.locator('.results.old .keyresults .kv').count()).toBeGreaterThan(5); // from the last solution, and marked as outdated
  await page.click('.verdict >> text=Reset to the model');
  await page.waitForSelector('.verdict.unsolved', { state: 'detached' });
  await solved(page);
});

test('stinger radius and box height move rollers, and are written into the model as coordinates of the listed boxes', async () => {
  const typed = (): Promise<string> => page.locator('[aria-label="stinger radius, typed"]').inputValue();
  const before = await typed();
  expect(Number.parseFloat(before)).toBeGreaterThan(100);
  const fitted = (): Promise<number> => reading(page, 'stinger radius');
  await expect.poll(() => fitted()).toBeCloseTo(Number.parseFloat(before), 0);
  await tryValue(page, 'stinger radius', 170);
  await expect.poll(typed).toBe('170 m');
  await solved(page);
  await expect.poll(async () => Math.abs(await fitted() - 170)).toBeLessThan(2); // boxes off the circle before are off it afterwards
  const height = await pin(page, 'stinger 3 z');
  await tryValue(page, 'stinger 3 z', height + 0.1);
  await solved(page);
  await page.click('text=Apply to model');
  await page.waitForSelector('.notice.good');
  const { text, diagnostics } = await (await bench.api('model')).json() as { text: string; diagnostics: { severity: string }[] };
  expect(text).not.toMatch(/^ +radius: 170 m/m);
  expect(diagnostics.filter((d) => d.severity === 'error')).toEqual([]);
  expect(text).toContain('# three values corrected');
  await page.click('[aria-label=Undo]');
  await expect.poll(typed).toBe(before);
});

test.runIf(takesPictures)('pictures of all views', async () => {
  for (const view of ['overbend', 'stinger', 'sagbend', 'touchdown', 'from the pipe', 'whole']) {
    await page.click(`.viewbuttons >> text=${view}`);
    await page.waitForTimeout(600);
    await bench.shot(page, `view-${view.replaceAll(' ', '-')}`);
  }
});

test('a selected roller shows its reaction', async () => {
  await page.click('.viewbuttons >> text=stinger');
  await rested(page);
  // position of the first stinger roller in contact
  const spot = await page.evaluate(() => {
    interface Point { clone(): Point; project(c: unknown): { x: number; y: number } }
    const view = (window as unknown as { __view: { camera: unknown; stage: { rollers: { list: { support: { structure: string }; reaction: number; center: Point }[] } } } }).__view;
    const r = document.querySelector('.canvas canvas')!.getBoundingClientRect();
    const carrying = view.stage.rollers.list.filter((x) => x.support.structure === 'stinger' && x.reaction > 0);
    const p = carrying[Math.floor(carrying.length / 2)]!.center.clone().project(view.camera);
    return { x: r.left + ((p.x + 1) / 2) * r.width, y: r.top + ((1 - p.y) / 2) * r.height };
  });
  await page.mouse.click(spot.x, spot.y);
  await page.waitForFunction(() => /row \d/.test(document.querySelector('.values')?.textContent ?? ''));
  await expect.poll(() => page.locator('.values').innerText()).toMatch(/reaction\s+[\d.]+\s+kN/);
  await bench.shot(page, 'roller');
  await page.click('.viewbuttons >> text=whole');
});

test('a diagram goes out as PNG', async () => {
  const [file] = await Promise.all([page.waitForEvent('download'), page.locator('.slot').first().locator('text=png').click()]);
  const bytes = readFileSync(await file.path());
  expect(bytes.subarray(1, 4).toString()).toBe('PNG');
  expect(bytes.readUInt32BE(16)).toBe(1800);
  expect(bytes.length).toBeGreaterThan(10_000);
});

test('the left column is resized by mouse and by keys, and reset', async () => {
  const width = async (): Promise<number> => (await page.locator('.left').boundingBox())!.width;
  const before = await width();
  await page.mouse.move(before, 300);
  await page.mouse.down();
  await page.mouse.move(before + 90, 300, { steps: 3 });
  await page.mouse.up();
  await expect.poll(() => width()).toBeCloseTo(before + 90, -1);
  await page.locator('.handle[data-side=left]').press('ArrowLeft');
  await expect.poll(() => width()).toBeCloseTo(before + 74, -1);
  await page.locator('.handle[data-side=left]').press('Home');
  await expect.poll(() => width()).toBeCloseTo(before, 0);
});

test('an error is shown at its line in YAML and at its field, and can be corrected', async () => {
  await showTab(page, 'yaml');
  await page.waitForSelector('.cm-content');
  await line(23);
  await page.keyboard.press('End');
  await page.keyboard.type('m');
  await page.waitForSelector('.diagnosticlist .error');
  await expect.poll(() => page.locator('.diagnosticlist .error').first().innerText()).toContain('line 23');
  await page.waitForSelector('.cm-lint-marker-error');
  await bench.shot(page, 'yaml-error');
  await page.waitForSelector('[role=treeitem][data-object=pipe] .mark.bad');
  const field = await openField(page, 'pipe.steel.wall_thickness');
  await expect.poll(() => page.locator('.row.wrong label').first().innerText()).toContain('wall thickness');
  await bench.shot(page, 'form-error');
  await field.fill('0.5 in');
  await page.keyboard.press('Enter');
  await solved(page);
  const { text } = await (await bench.api('model')).json() as { text: string };
  expect(text).toContain('wall_thickness: 0.5 in');
});

test('completion knows the keys of the place', async () => {
  await showTab(page, 'yaml');
  await line(25);
  await page.keyboard.press('End');
  await page.keyboard.press('Enter');
  await page.keyboard.type('ten');
  await page.waitForSelector('.cm-tooltip-autocomplete');
  await expect.poll(() => page.locator('.cm-tooltip-autocomplete').innerText()).toContain('tensile_strength');
  await bench.shot(page, 'completion');
  await page.keyboard.press('Escape');
  for (let i = 0; i < 3; ++i) await page.keyboard.press('Backspace');
  await page.waitForTimeout(600);
  await solved(page);
});

test('reload keeps the open model', async () => {
  const before = (await (await bench.api('model')).json() as { text: string }).text;
  await page.reload();
  await solved(page);
  await expect.poll(() => page.locator('#f-pipe\\.steel\\.wall_thickness').inputValue()).toBe('0.5 in'); // of the object that was selected
  expect((await (await bench.api('model')).json() as { text: string }).text).toBe(before);
});

test.runIf(takesPictures)('pictures in the dark, and of a large screen', async () => {
  await page.click('[aria-label="Dark colours"]');
  await page.waitForTimeout(500);
  await bench.shot(page, 'dark');
  await page.click('[aria-label="Light colours"]');
  const large = await bench.open({ width: 3840, height: 2160 });
  await solved(large);
  await large.waitForTimeout(2500);
  await bench.shot(large, '4k');
  await large.close();
});

test('no errors were logged in the browser', () => expect(bench.complaints.filter((c) => !/409|422/.test(c))).toEqual([]));
