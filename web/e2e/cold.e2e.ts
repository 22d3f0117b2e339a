// Cold starts: the picture of the lay is the same in whichever order its parts arrive.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { colours, difference, picture, rested, solved, start, type Bench } from './harness';

const size = { width: 1120, height: 560 };
let bench: Bench;
let page: Page;
let usual = '';

/** The settled picture: two shots half a second apart are the same. */
async function settled(p: Page): Promise<string> {
  await solved(p);
  let before = '', latest = '';
  do {
    before = latest;
    await rested(p);
    latest = await picture(p, '.canvas');
  } while (latest !== before);
  return latest;
}

beforeAll(async () => {
  bench = await start('bgl1.yaml');
  page = await bench.open(size);
  await solved(page);
  // the view is requested with everything loaded: the reference for cold starts
  await page.click('.viewbuttons >> text=overbend');
  await settled(page);
  await page.click('.viewbuttons >> text=whole');
  usual = await settled(page);
});
afterAll(async () => { await bench?.stop(); });

test('hull, sky, water, seabed and pipe have many colours, another view is another picture', async () => {
  expect(await colours(page, usual)).toBeGreaterThan(8);
  await page.click('.viewbuttons >> text=stinger');
  await expect.poll(async () => difference(page, await settled(page), usual)).toBeGreaterThan(8);
});

test('a solution that comes again leaves the picture sharp where it is, another view is flown to', async () => {
  await page.click('.viewbuttons >> text=whole');
  await settled(page);
  const flown = await page.evaluate(() => {
    const view = (window as unknown as { __view: { stage: { solution: unknown }; flight: { path: unknown }; setSolution: (s: unknown) => void; go: (v: string) => void } }).__view;
    view.setSolution(view.stage.solution);
    const again = view.flight.path !== null;
    view.go('stinger');
    return [again, view.flight.path !== null];
  });
  expect(flown).toEqual([false, true]);
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

test('no errors were logged in the browser', () => expect(bench.complaints).toEqual([]));
