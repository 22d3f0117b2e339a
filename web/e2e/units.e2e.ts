// One switch shows results, tables, messages and reports in US customary units; the model keeps its own units.
import { afterAll, beforeAll, expect, test } from 'vitest';
import { start, type Bench } from './harness';

let bench: Bench;
beforeAll(async () => { bench = await start('bgl1.yaml'); });
afterAll(() => bench.stop());

const metric = /\d ?(kN|MPa|mm|m)\b/;

test('everything that is shown changes its units by one click, and back', async () => {
  const page = await bench.open();
  const results = page.getByLabel('Key results');
  await results.getByText('top tension').waitFor();
  const values = async (): Promise<string> => (await results.locator('.kv').evaluateAll((rows) => rows.map((row) => `${row.querySelector('td')!.textContent} ${row.querySelector('th small')!.textContent}`))).join('\n');
  await expect.poll(() => values()).toMatch(/\b250 kN/);
  await page.getByRole('button', { name: 'Units: metric' }).click();
  await page.getByRole('button', { name: 'Units: US customary' }).waitFor();
  await results.getByText('top tension').waitFor();
  const text = await values();
  expect(text).toMatch(/\b56.2 kip/); // 250 kN over 4.44822 kN/kip
  expect(text).toMatch(/\b1101 ft/); // lay-back of 335.6 m
  expect(text.replace(/\n/g, ' ')).not.toMatch(metric);
  await expect.poll(() => page.locator('.slot').first().innerText()).not.toMatch(/\[m\]|\[kN\]|\[MPa\]/);
  await bench.shot(page, 'us-units');
  await page.getByRole('button', { name: 'Units: US customary' }).click();
  await page.getByRole('button', { name: 'Units: metric' }).waitFor();
  expect(bench.complaints).toEqual([]);
}, 60_000);
