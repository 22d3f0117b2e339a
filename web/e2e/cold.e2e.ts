// Cold starts: whatever arrives last, there is a picture of the lay, the same as ever.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { colours, difference, picture, rested, solved, start, type Bench } from './harness';

const size = { width: 1120, height: 560 };
let bench: Bench;
let page: Page;
let usual = '';

const settled = async (p: Page): Promise<string> => { await solved(p); await rested(p); return picture(p, '.canvas'); };

beforeAll(async () => {
  bench = await start('bgl1.yaml');
  page = await bench.open(size);
  await solved(page);
  // the view is asked for by hand, with everything there: what cold starts are compared with
  await page.click('.viewbuttons >> text=overbend');
  await page.waitForTimeout(600);
  await page.click('.viewbuttons >> text=whole');
  usual = await settled(page);
});
afterAll(async () => { await bench?.stop(); });

test('hull, sky, water, seabed and pipe have many colours, another view is another picture', async () => {
  expect(await colours(page, usual)).toBeGreaterThan(8);
  await page.click('.viewbuttons >> text=stinger');
  await page.waitForTimeout(600);
  expect(await difference(page, await settled(page), usual)).toBeGreaterThan(8);
});

for (const late of ['/api/info', '/api/model', '/api/static', '/api/scene', '/assets/view3d', '/assets/three', '/assets/solver']) {
  test(`the picture is there on a cold start with ${late} late`, async () => {
    let delayed = 0;
    const cold = await bench.open(size, async (p) => {
      await p.context().route((url) => url.pathname.startsWith(late), async (route) => {
        ++delayed;
        await new Promise((done) => setTimeout(done, 700));
        await route.continue().catch(() => undefined);
      });
    });
    await solved(cold);
    await expect.poll(async () => difference(page, await picture(cold, '.canvas'), usual), { timeout: 20_000, interval: 300 }).toBeLessThan(1);
    expect(delayed).toBeGreaterThan(0);
    await cold.context().close();
  });
}

test('nothing was complained about', () => expect(bench.complaints).toEqual([]));
