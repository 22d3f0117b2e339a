// Numbers that are dragged, stepped, pinned and found by goal seek, and the search, with BGL-1.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Locator, Page } from 'playwright-core';
import { solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('bgl1.yaml'); page = await bench.open({ width: 1440, height: 900 }); await solved(page); });
afterAll(async () => { await bench?.stop(); });

const tension = (): Locator => page.locator('[id="f-tensioner.tension"]');
const label = (path: string): Locator => page.locator(`label[for="f-${path}"]`);
const pin = (name: string): Locator => page.locator('.pin', { hasText: name });
const modelText = async (): Promise<string> => (await (await bench.api('model')).json() as { text: string }).text;
const result = async (name: string): Promise<number> => Number.parseFloat(await page.locator('.keyresults tr', { hasText: name }).first().locator('td').first().innerText());

async function find(query: string): Promise<void> {
  await page.keyboard.press('Control+k');
  await page.waitForFunction(() => document.activeElement?.id === 'find');
  await page.keyboard.type(query);
  await page.waitForSelector('.found-entries [aria-selected=true]');
  await page.keyboard.press('Enter');
}

async function focused(id: string): Promise<void> { await page.waitForFunction((wanted) => document.activeElement?.id === wanted, id); }

test('the search leads to a key, and arrow keys vary it with live statics', async () => {
  await find('tension');
  await focused('f-tensioner.tension');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Shift+ArrowUp');
  await expect.poll(() => tension().inputValue()).toBe('261 kN');
  await expect.poll(() => result('top tension')).toBeCloseTo(261, 0);
  await page.keyboard.press('Escape');
  await expect.poll(() => tension().inputValue()).toBe('250 kN');
  await expect.poll(() => result('top tension')).toBeCloseTo(250, 0);
  await expect.poll(() => modelText()).toContain('tension: 250 kN');
});

test('a value varied with keys is written with Enter, as one step', async () => {
  await tension().focus();
  for (let i = 0; i < 4; ++i) await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await expect.poll(modelText).toContain('tension: 246 kN');
  await page.click('[aria-label=Undo]');
  await expect.poll(modelText).toContain('tension: 250 kN');
});

async function dragLabel(path: string, pixels: number, end: () => Promise<void>): Promise<void> {
  const box = (await label(path).boundingBox())!, x = box.x + 8, y = box.y + box.height / 2;
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + pixels, y, { steps: 10 });
  await end();
  await page.mouse.up();
}

test('a label is dragged: the lay follows, release writes, one undo goes back', async () => {
  await dragLabel('tensioner.tension', 30, async () => {
    await expect.poll(() => result('top tension')).toBeCloseTo(280, 0);
    await expect.poll(() => modelText()).toContain('tension: 250 kN');
  });
  await expect.poll(modelText).toContain('tension: 280 kN');
  await page.click('[aria-label=Undo]');
  await expect.poll(modelText).toContain('tension: 250 kN');
  await expect.poll(() => tension().inputValue()).toBe('250 kN');
});

test('Esc during a drag goes back to the value of the model', async () => {
  await dragLabel('tensioner.tension', 25, async () => {
    await expect.poll(() => tension().inputValue()).toBe('275 kN');
    await page.keyboard.press('Escape');
  });
  await expect.poll(() => tension().inputValue()).toBe('250 kN');
  await expect.poll(() => modelText()).toContain('tension: 250 kN');
});

test('a key is pinned from the menu of its field, and unpinned', async () => {
  await find('wall thickness');
  await focused('f-pipe.steel.wall_thickness');
  await page.keyboard.press('Shift+F10');
  await page.click('.menu >> text=Pin as slider');
  await pin('wall thickness').waitFor();
  await page.reload();
  await solved(page);
  await pin('wall thickness').hover();
  await bench.shot(page, 'pinned');
  await pin('wall thickness').locator('button.more').click();
  await page.click('.menu >> text=Unpin');
  await pin('wall thickness').waitFor({ state: 'detached' });
});

test('sliders set trial values, which are written on request', async () => {
  await expect.poll(() => page.locator('.pinned .apply').count()).toBe(0);
  await page.fill('[aria-label="tension, typed"]', '300');
  await page.keyboard.press('Enter');
  await expect.poll(() => result('top tension')).toBeCloseTo(300, 0);
  await expect.poll(() => modelText()).toContain('tension: 250 kN');
  await page.click('.pinned .apply >> text=Reset');
  await expect.poll(() => result('top tension')).toBeCloseTo(250, 0);
  await page.fill('[aria-label="tension, typed"]', '60 kip');
  await page.keyboard.press('Enter');
  await page.click('.pinned .apply >> text=Apply to model');
  await expect.poll(modelText).toContain('tension: 266.89');
  await page.click('[aria-label=Undo]');
  await expect.poll(modelText).toContain('tension: 250 kN');
});

test('the range in which every check passes is found, and dropped when another value changes', async () => {
  await expect.poll(() => pin('water depth').getAttribute('title'), { timeout: 60_000 }).toMatch(/every check passes from 7\d(\.\d+)? m to 1[12]\d(\.\d+)? m/);
  await expect.poll(() => pin('water depth').locator('.strip i').count()).toBe(1);
  await bench.shot(page, 'ranges');
  await page.locator('[id="s-tensioner.tension"]').focus();
  await page.keyboard.press('ArrowRight');
  await expect.poll(() => pin('water depth').locator('.strip').count()).toBe(0);
  await page.keyboard.press('Escape');
});

test('commands are found as well, and Esc closes the search', async () => {
  await find('dark');
  await page.waitForFunction(() => document.documentElement.dataset.theme === 'dark');
  await page.keyboard.press('Control+k');
  await focused('find');
  await page.keyboard.type('stinger 8');
  await page.waitForSelector('.found-entries >> text=stinger 8');
  await bench.shot(page, 'search');
  await page.keyboard.press('Escape');
  await expect.poll(() => page.locator('.found-entries').count()).toBe(0);
  await find('light');
});

test('on a narrow screen the search opens its column', async () => {
  await page.setViewportSize({ width: 1024, height: 768 });
  await page.keyboard.press('Control+k');
  await focused('find');
  await page.keyboard.press('Escape');
  await bench.shot(page, 'numbers-narrow');
  await page.setViewportSize({ width: 1440, height: 900 });
});

test('no errors were logged in the browser', () => expect(bench.complaints.filter((c) => !/model\/disk|409|422/.test(c))).toEqual([]));
