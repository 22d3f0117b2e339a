// Moorings: plan, table, stages, a mooring spread from the dialog; models without a pipe.
import { afterAll, beforeAll, expect, test } from 'vitest';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { colours, goTo, picture, rested, runStorm, showTab, solved, start, type Bench } from './harness';

interface Summary { static: { vessel: { natural_periods: { mode: string; period: number }[] }; moorings: { name: string; fairlead_tension: number; on_bed: number }[] } }

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('moored-barge.yaml'); page = await bench.open({ width: 1440, height: 820 }); await solved(page); });
afterAll(async () => { await bench?.stop(); });

const text = async (): Promise<string> => (await (await bench.api('model')).json() as { text: string }).text;
async function put(next: string, name?: string): Promise<void> {
  const { revision } = await (await bench.api('model')).json() as { revision: number };
  expect((await bench.api('model', { method: 'PUT', body: JSON.stringify({ text: next, revision, ...(name ? { name } : {}) }) })).status).toBe(200);
}
const rows = (): Promise<string[][]> => page.locator('.dock table.moorings tbody tr').evaluateAll((all) => all.map((row) => [...row.children].map((cell) => (cell as HTMLElement).innerText.trim())));

test('a moored barge without a pipe shows its lines, with the values of summary.json', async () => {
  await expect.poll(() => page.locator('.viewbuttons button').allInnerTexts()).toEqual(['vessel', 'moorings', 'side', 'plan']);
  const { id } = await (await bench.api('runs', { method: 'POST', body: JSON.stringify({ kind: 'static' }) })).json() as { id: string };
  await expect.poll(async () => (await bench.api(`runs/${id}/summary`)).status, { timeout: 20_000 }).toBe(200);
  const summary = await (await bench.api(`runs/${id}/summary`)).json() as Summary;
  await showTab(page, 'moorings');
  const shown = await rows();
  expect(shown.map((r) => r[0])).toEqual(summary.static.moorings.map((l) => l.name));
  shown.forEach((r, i) => {
    expect(Number(r[1])).toBeCloseTo(summary.static.moorings[i]!.fairlead_tension / 1e3, 0);
    expect(Number(r[3])).toBeCloseTo(summary.static.moorings[i]!.on_bed, 0);
  });
  const surge = summary.static.vessel.natural_periods.find((p) => p.mode === 'surge')!;
  await expect.poll(() => page.locator('.moored .kv', { hasText: 'T surge' }).locator('dd').innerText()).toContain(surge.period.toPrecision(3));
  expect(await colours(page, await picture(page, '.canvas'))).toBeGreaterThan(6);
  await bench.shot(page, 'moored-3d');
});

test('the table is sorted by a click, and a selected line shows its values', async () => {
  await page.click('.dock table.moorings thead button:has-text("fairlead")');
  const tensions = (await rows()).map((r) => Number(r[1]));
  expect(tensions).toEqual([...tensions].sort((a, b) => b - a));
  await page.click('.dock table.moorings tbody tr:first-child .linkname');
  await expect.poll(() => page.locator('.values').innerText()).toContain((await rows())[0]![0]);
});

test('the plan names eight lines with their tensions, at three sizes', async () => {
  await page.click('.viewbuttons >> text=plan');
  await page.waitForSelector('.planview .planline');
  await expect.poll(() => page.locator('.planview .planline .name').count()).toBe(8);
  const loads = await page.locator('.planview .planline .load').allTextContents();
  expect(loads.every((l) => /^\d+(\.\d+)? kN$/.test(l))).toBe(true);
  for (const [name, width, height] of [['large', 1920, 1080], ['middle', 1280, 720], ['small', 390, 780]] as const) {
    await page.setViewportSize({ width, height });
    // names stay within the drawing
    const outside = (): Promise<number> => page.locator('.planview .name').evaluateAll((all) => all.filter((t) => { const r = t.getBoundingClientRect(), b = t.closest('svg')!.getBoundingClientRect(); return r.left < b.left - 1 || r.right > b.right + 1 || r.top < b.top || r.bottom > b.bottom + 1; }).length);
    await expect.poll(outside, { message: name }).toBe(0);
    await bench.shot(page, `plan-${name}`);
  }
  await page.setViewportSize({ width: 1440, height: 820 });
});

test('the barge moves on its lines in a dynamic run, and is animated', async () => {
  const id = await runStorm(bench, page, 40);
  await page.waitForSelector('.animation');
  await showTab(page, 'moorings');
  await page.waitForSelector('table[aria-label="Moorings over time"] tbody tr');  // comes with the summary, with or without a picture
  const { dynamic } = await (await bench.api(`runs/${id}/summary`)).json() as { dynamic: { vessel: { pitch: { max: number } }; moorings: { name: string; fairlead_tension: { max: number } }[] } };
  const over = await page.locator('table[aria-label="Moorings over time"] tbody tr').evaluateAll((all) => all.map((row) => [...row.children].map((cell) => (cell as HTMLElement).innerText.trim())));
  expect(over.length).toBe(14);
  expect(Number(over.find((r) => r[0]!.startsWith('pitch'))![2])).toBeCloseTo(dynamic.vessel.pitch.max * 180 / Math.PI, 1);
  expect(Number(over.find((r) => r[0]!.startsWith('port bow'))![2])).toBeCloseTo(dynamic.moorings[0]!.fairlead_tension.max / 1e3, 0);
  await expect.poll(() => page.locator('.standing').innerText()).toBe('40 s, seed 1');
  await page.locator('table.overtime button', { hasText: 'port bow' }).click();
  await page.waitForSelector('#docktab-histories[aria-selected=true]');
  await expect.poll(() => page.locator('[aria-label="History 1"]').inputValue()).toBe('mooring/port bow/fairlead_tension');
  await page.click('[aria-label=Play]');
  const clock = async (): Promise<number> => Number.parseFloat(await page.locator('.clock').innerText());
  const first = await clock();
  await expect.poll(clock).not.toBe(first);
  await page.click('[aria-label=Pause]');
  for (const [name, width, height] of [['large', 1920, 1080], ['middle', 1280, 720], ['small', 390, 780]] as const) {
    await page.setViewportSize({ width, height });
    await page.waitForTimeout(500);
    await bench.shot(page, `moored-run-${name}`);
  }
  await page.setViewportSize({ width: 1440, height: 820 });
  await page.click('.right [aria-label="Back to the model"]');
  await goTo(page, 'lay');
  await showTab(page, 'moorings');
});

test('a stage of the operation is followed by plan and table', async () => {
  await put(`${await text()}\noperation:\n  type: moored\n  stages:\n    - {name: still}\n    - {name: port bow parted, parted: [port bow]}\n`);
  await page.waitForSelector('.planacts select');
  const before = await page.locator('.planview .load').allTextContents();
  await page.selectOption('.planacts select', { label: 'port bow parted' });
  await expect.poll(() => page.locator('.planview .load').count()).toBe(7);
  await expect.poll(() => page.locator('.planview .load').allTextContents()).not.toEqual(before);
  expect((await rows()).find((r) => r[0] === 'port bow')![1]).toBe('-');
  await page.click('.viewbuttons >> text=moorings');
  await page.waitForTimeout(600);
  await bench.shot(page, 'stage-3d');
});

test('a mooring spread from the dialog is added to a lay, solves, and is undone', async () => {
  await put(readFileSync(join(bench.folder, 'bgl1.yaml'), 'utf8'), 'bgl1.yaml');
  await expect.poll(() => page.locator('.viewbuttons button').allInnerTexts()).toContain('touchdown');
  await solved(page);
  await page.click('text=add to the model');
  await page.click('[role=menuitem] >> text=Moorings');
  await page.fill('#m-angles', '25');
  await expect.poll(() => page.locator('dialog .failuretext').innerText()).toMatch(/4 angles/);
  await page.selectOption('#m-count', '6');
  await page.fill('#m-tension', '250 kN');
  await bench.shot(page, 'spread');
  await page.click('dialog >> text=Apply');
  await expect.poll(() => page.locator('.planview .planline').count(), { timeout: 20_000 }).toBe(6);
  await solved(page);
  await expect.poll(() => page.locator('header .status').innerText()).toMatch(/solved/);
  await showTab(page, 'moorings');
  expect((await rows()).map((r) => Number(r[1]))).toEqual(Array(6).fill(250));
  await bench.shot(page, 'spread-plan');
  await page.click('[aria-label="Undo"]');
  await expect.poll(text).not.toContain('moorings');
});

test('a barge held by thrusters only is shown without lines', async () => {
  const moored = readFileSync(join(bench.folder, 'moored-barge.yaml'), 'utf8');
  const dp = 'station_keeping: {dp: {surge: {stiffness: 100 kN/m}, sway: {stiffness: 100 kN/m}, yaw: {stiffness: 2e5 kN*m}}}\n\n';
  await put(moored.replace(/^moorings:[\s\S]*?(?=^analysis:)/m, dp), 'moored-barge.yaml');
  await expect.poll(() => page.locator('.viewbuttons button').allInnerTexts(), { timeout: 20_000 }).toEqual(['vessel', 'side', 'plan']);
  await solved(page);
  await page.click('.viewbuttons >> text=vessel');
  await rested(page);
  await showTab(page, 'moorings');
  await page.waitForSelector('section[aria-label="Station keeping"]');
  await expect.poll(() => page.locator('section[aria-label="Station keeping"] table').count()).toBe(0);
  await showTab(page, 'diagrams');
  await expect.poll(() => page.locator('.slot .empty').first().innerText()).toMatch(/neither pipe nor lines/);
  expect(await colours(page, await picture(page, '.canvas'))).toBeGreaterThan(8);
  await bench.shot(page, 'positioned');
  await runStorm(bench, page, 20);
  await showTab(page, 'moorings');
  const inTime = page.locator('table.overtime');
  await inTime.locator('tr', { hasText: 'DP yaw' }).waitFor();
  await inTime.locator('button', { hasText: 'DP sway' }).click();
  await expect.poll(() => page.locator('[aria-label="History 1"]').inputValue()).toBe('thrust/sway');
  await bench.shot(page, 'thrust-in-time');
  await page.click('.right [aria-label="Back to the model"]');
  await goTo(page, 'lay');
});

test('a model of a single line is drawn, with the diagrams of the line', async () => {
  await put(readFileSync(join(bench.folder, 'jumper.yaml'), 'utf8'), 'jumper.yaml');
  await expect.poll(() => page.locator('.viewbuttons button').allInnerTexts(), { timeout: 20_000 }).toEqual(['lines', 'side', 'plan']);
  await solved(page);
  await showTab(page, 'lines');
  await expect.poll(() => page.locator('.moored .kv', { hasText: 'length' }).first().locator('dd').innerText()).toMatch(/^170/);
  await showTab(page, 'diagrams');
  await page.waitForSelector('.slot .plot canvas');
  await page.waitForTimeout(300);
  await bench.shot(page, 'jumper');
});

test('no errors were logged in the browser', () => expect(bench.complaints).toEqual([]));
