// Tables of the lists of the model: typed, pasted, copied, moved, generated.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { start, solved, type Bench } from './harness';

let bench: Bench;
let page: Page;

interface ModelField { path: string; value: string | null; count?: number; kind: string }
const fieldsIn = async (): Promise<Map<string, ModelField>> => new Map((await (await bench.api('model')).json() as { fields: ModelField[] }).fields.map((f) => [f.path, f]));
const valueOf = async (path: string): Promise<string | null> => (await fieldsIn()).get(path)?.value ?? null;

const cell = (path: string) => page.locator(`[role=grid] td[data-path="${path}"]`);
/** Pastes text as a spreadsheet does with Ctrl+V. */
const paste = (text: string): Promise<void> => page.evaluate((t) => {
  const data = new DataTransfer();
  data.setData('text/plain', t);
  (document.activeElement ?? document.body).dispatchEvent(new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true }));
}, text);
const until = async (check: () => Promise<boolean>): Promise<void> => { for (let i = 0; i < 100 && !(await check()); ++i) await page.waitForTimeout(100); expect(await check()).toBe(true); };

beforeAll(async () => {
  bench = await start('bgl1.yaml');
  page = await bench.open({ width: 1440, height: 900 });
  await solved(page).catch(() => undefined);
  await page.locator('#docktab-boxes').click();
  await page.locator('[role=grid]').waitFor();
}, 60_000);
afterAll(async () => bench?.stop());

test('boxes of ramp and stinger are in one table with their results', async () => {
  await expect.poll(() => page.locator('[role=grid] tbody tr').count()).toBe(13);
  await until(async () => /\d/.test(await page.locator('[role=grid] td.result').nth(1).innerText()));
  await bench.shot(page, 'grid-boxes');
}, 60_000);

test('a number typed with another unit is written with it and shown in that of the column', async () => {
  await cell('supports.stinger.boxes[7].x').click();
  await page.keyboard.type('104 ft');
  await page.keyboard.press('Enter');
  await until(async () => (await valueOf('supports.stinger.boxes[7].x')) === '104 ft');
  await until(async () => (await cell('supports.stinger.boxes[7].x').innerText()) === '31.6992');
  await page.keyboard.press('Control+z');
  await until(async () => (await valueOf('supports.stinger.boxes[7].x')) === '31.224 m');
}, 60_000);

test('an unreadable cell keeps its text with the reason, and the model is unchanged', async () => {
  await cell('supports.stinger.boxes[6].z').click();
  await page.keyboard.type('abc');
  await page.keyboard.press('Enter');
  await page.locator('td.bad').waitFor();
  await expect.poll(() => cell('supports.stinger.boxes[6].z').innerText()).toContain('abc');
  await expect.poll(() => valueOf('supports.stinger.boxes[6].z')).toBe('-13.163 m');
  await bench.shot(page, 'grid-bad');
  await cell('supports.stinger.boxes[6].z').click();
  await page.keyboard.press('Escape');
  await until(async () => (await cell('supports.stinger.boxes[6].z').innerText()) === '-13.163');
}, 60_000);

test('the model values of a box are in its cells', async () => {
  await cell('supports.stinger.boxes[2].x').click();
  await page.keyboard.type('8');
  await page.keyboard.press('Tab');
  await page.locator('td.has-error .said').first().waitFor();
  await expect.poll(() => cell('supports.stinger.boxes[2].x').innerText()).toContain('increases from box to box');
  await bench.shot(page, 'grid-order');
  await page.keyboard.press('Control+z');
  await until(async () => (await page.locator('td.has-error').count()) === 0);
}, 60_000);

test('missing rows are added, and unreadable cells are kept for correction', async () => {
  await cell('supports.stinger.boxes[7].name').click();
  await paste('stinger 8\t31,224\t-14,980\nstinger 9\t34,8\t-16,9\nstinger 10\t38,3\tsee note');
  await until(async () => (await fieldsIn()).get('supports.stinger.boxes')?.count === 10);
  await expect.poll(() => valueOf('supports.stinger.boxes[8].length')).toMatch(/^4(\.000)? m$/);
  await page.locator('td.bad').waitFor();
  await expect.poll(() => cell('supports.stinger.boxes[9].z').innerText()).toContain('see note');
  await bench.shot(page, 'grid-added');
  await cell('supports.stinger.boxes[9].z').click();
  await page.keyboard.type('-19');
  await page.keyboard.press('Enter');
  await until(async () => (await valueOf('supports.stinger.boxes[9].z')) === '-19 m');
  await expect.poll(() => page.locator('td.bad').count()).toBe(0);
}, 60_000);

test('rows are duplicated, moved and removed', async () => {
  await cell('supports.stinger.boxes[9].name').click();
  await page.getByRole('button', { name: 'Remove', exact: true }).click();
  await until(async () => (await fieldsIn()).get('supports.stinger.boxes')?.count === 9);
  await cell('supports.stinger.boxes[8].name').click();
  await page.getByRole('button', { name: 'Duplicate' }).click();
  await until(async () => (await valueOf('supports.stinger.boxes[9].name')) === 'stinger 10');
  await cell('supports.stinger.boxes[9].name').click();
  await page.keyboard.press('Alt+ArrowUp');
  await until(async () => (await valueOf('supports.stinger.boxes[8].name')) === 'stinger 10');
}, 60_000);

test('a stinger is generated from radius, number and spacing, and written out as a list', async () => {
  await page.getByRole('button', { name: 'Generate stinger' }).click();
  await page.locator('.generate').waitFor();
  await page.locator('.generate input').first().fill('100 m');
  await expect.poll(() => page.locator('.generate tbody tr').count()).toBeGreaterThan(5);
  await bench.shot(page, 'grid-generate');
  await page.getByRole('button', { name: 'Write as a row' }).click();
  await until(async () => (await valueOf('supports.stinger.radius')) === '100 m');
  await page.getByRole('button', { name: 'Convert to a list' }).waitFor();
  await page.waitForFunction(() => document.querySelectorAll('[role=grid] td.fixed').length > 0);
  await bench.shot(page, 'grid-row');
  await page.getByRole('button', { name: 'Convert to a list' }).click();
  await until(async () => (await fieldsIn()).get('supports.stinger.boxes')?.kind === 'list');
  expect((await fieldsIn()).get('supports.stinger.radius')?.value ?? null).toBeNull();
}, 60_000);

test('any list has a table: the current, with the selected cells copied', async () => {
  await page.evaluate(() => { location.hash = '#/lay/environment.current'; });
  await page.locator('#docktab-objecttable').click();
  await page.locator('[role=grid] td[data-path="environment.current[0].speed"]').click();
  await page.keyboard.press('Shift+ArrowDown');
  const copied = await page.evaluate(() => {
    const data = new DataTransfer();
    document.activeElement!.dispatchEvent(new ClipboardEvent('copy', { clipboardData: data, bubbles: true, cancelable: true }));
    return data.getData('text/plain');
  });
  expect(copied).toBe('1.02\n1.02\n');
  await bench.shot(page, 'grid-current');
  expect(bench.complaints).toEqual([]);
}, 60_000);
