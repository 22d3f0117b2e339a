// Playback of a dynamic run: clock, impacts, contents of frames, the sea and statics of the run.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
let id = '';

beforeAll(async () => {
  bench = await start('bgl1-workable-sea.yaml', { 'seed: 1': 'seed: 3' });
  page = await bench.open({ width: 1440, height: 900 });
  await solved(page);
  id = ((await (await bench.api('runs', { method: 'POST', body: JSON.stringify({ kind: 'dynamic', duration: 20 }) })).json()) as { id: string }).id;
  await page.click('#workspace-runs');
  await page.locator(`tr[data-run="${id}"]`, { hasText: 'done' }).waitFor({ timeout: 150_000 });
  await page.locator(`tr[data-run="${id}"] td.name`).click();
  await page.click('.runacts >> text=Open in Storm');
}, 300_000);
afterAll(async () => { await bench?.stop(); });

test('it is animated', async () => {
  await page.waitForSelector('.animation');
  await page.click('[aria-label=Play]');
  const clock = async (): Promise<number> => Number.parseFloat(await page.locator('.clock').innerText());
  const first = await clock();
  await expect.poll(clock, { timeout: 20_000 }).not.toBe(first);
  await page.click('[aria-label=Pause]');
});

test('impacts light up, and boxes have the colour of their reaction', async () => {
  const { impacts } = await (await bench.api(`runs/${id}/impacts`)).json() as { impacts: { time: number }[] };
  expect(impacts.length).toBeGreaterThan(0);
  const hardest = impacts.find((i) => i.time > 0 && i.time < 19)!;
  await page.locator('[aria-label=Time]').evaluate((el, t) => { const input = el as HTMLInputElement; input.value = String(t); input.dispatchEvent(new Event('input', { bubbles: true })); }, Math.ceil((hardest.time + 0.05) * 20) / 20);
  await page.waitForFunction(() => Number((document.querySelector('.legend') as HTMLElement).dataset.flashes) > 0);
  await expect.poll(() => page.evaluate(() => (window as unknown as { __view: { stage: { flashGroup: { children: unknown[] } } } }).__view.stage.flashGroup.children.length)).toBeGreaterThan(0);
  await expect.poll(() => page.locator('.rollerkey').innerText()).toMatch(/box, to [\d.]+ kN/);
});

test('quantities missing in the frames cannot be selected during playback', async () => {
  const closed = await page.locator('[aria-label="Colour of the pipe"] option:disabled').allInnerTexts();
  expect(closed.join()).toMatch(/Bending stress.*Strain.*Utilisation/);
});

test('the sea of the picture is that of the run', async () => {
  const { waves, stern_shoe: shoe } = await (await bench.api(`runs/${id}/scene`)).json() as { waves: { amplitude: number; number: number; frequency: number; phase: number; direction: number }[]; stern_shoe: number[] };
  const shown = await page.evaluate(() => (window as unknown as { __view: { stage: { sea: { waves: { phase: number }[] } } } }).__view.stage.sea.waves);
  expect(shown).toEqual(waves);
  const { t, min } = await (await bench.api(`runs/${id}/series?name=elevation&t0=0&px=1000`)).json() as { t: number[]; min: number[] };
  expect(t.length).toBeGreaterThan(30);
  t.forEach((time, i) => {
    const drawn = waves.reduce((sum, w) => sum + w.amplitude * Math.cos(w.number * (shoe[0]! * Math.cos(w.direction) + shoe[1]! * Math.sin(w.direction)) - w.frequency * time + w.phase), 0);
    expect(drawn).toBeCloseTo(min[i]!, 3);
  });
});

test('no errors were logged in the browser', () => expect(bench.complaints).toEqual([]));
