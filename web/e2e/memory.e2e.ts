// Memory is constant over a thousand drags.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { rested, solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('bgl1.yaml'); page = await bench.open({ width: 1024, height: 768 }); await solved(page); });
afterAll(async () => { await bench?.stop(); });

/** Moves the slider of the tension and waits for the answer, repeatedly. */
const drag = (times: number): Promise<void> => page.evaluate(async (count) => {
  const slider = document.querySelector<HTMLInputElement>('[id="s-tensioner.tension"]')!;
  const answers = (): number => (window as unknown as { __solved: { count: number } }).__solved.count;
  for (let i = 0; i < count; ++i) {
    const before = answers();
    slider.value = String(250 + (i % 50));
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    for (let waited = 0; answers() === before && waited < 200; ++waited) await new Promise((done) => setTimeout(done, 5));
  }
}, times);

async function used(): Promise<number> {
  await rested(page);
  const devtools = await page.context().newCDPSession(page);
  for (let i = 0; i < 2; ++i) await devtools.send('HeapProfiler.collectGarbage');
  const { usedSize } = await devtools.send('Runtime.getHeapUsage');
  await devtools.detach();
  return usedSize / 1e6;
}

test('memory after a thousand drags is within a tenth of that before', async () => {
  await drag(1000); // until the compiler of the browser and the caches of the page have settled
  const before = await used();
  await drag(1000);
  const after = await used();
  console.log(`memory ${before.toFixed(1)} MB, after a thousand drags ${after.toFixed(1)} MB`);
  expect(after).toBeLessThan(1.1 * before);
}, 600_000);
