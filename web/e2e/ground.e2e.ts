// Supports of the pipe: an uneven seabed, a curved route, a hinged stinger.
import { expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { reading, showTab, solved, start, type Bench } from './harness';

async function opened(model: string, look: (page: Page, bench: Bench) => Promise<void>, size = { width: 1280, height: 720 }): Promise<void> {
  const bench = await start(model);
  try {
    const page = await bench.open(size);
    await solved(page);
    await look(page, bench);
    expect(bench.complaints).toEqual([]);
  } finally {
    await bench.stop();
  }
}

for (const [name, size] of Object.entries({ wide: { width: 1600, height: 900 }, middle: { width: 1024, height: 700 }, phone: { width: 390, height: 800 } })) {
  test(`free spans over a trench and a sleeper are listed, ${name}`, async () => {
    await opened('uneven-seabed.yaml', async (page, bench) => {
      await showTab(page, 'ground');
      const laid = page.locator('section[aria-label="Laid pipe"]');
      await expect.poll(() => laid.locator('tbody tr').count()).toBe(3);
      await expect.poll(() => laid.locator('caption').innerText()).toBe('3 free spans');
      expect(Number.parseFloat(await laid.locator('tbody tr').first().locator('td').nth(2).innerText())).toBeGreaterThan(40);
      await laid.scrollIntoViewIfNeeded();
      await bench.shot(page, `uneven-${name}`);
    }, size);
  });
}

test('the route shows the minimum radius that friction holds', async () => {
  await opened('curved_route.yaml', async (page, bench) => {
    await showTab(page, 'ground');
    await expect.poll(() => reading(page, 'radius of the route')).toBe(1500);
    await expect.poll(() => reading(page, 'minimum radius')).toBeCloseTo(1116, -1);
    await page.locator('section[aria-label="Lay route"]').scrollIntoViewIfNeeded();
    await bench.shot(page, 'route');
  });
});

test('a hinged stinger shows its angle, which goal seek supports', async () => {
  await opened('floating_stinger.yaml', async (page, bench) => {
    await showTab(page, 'stinger');
    expect(Math.abs(await reading(page, 'stinger angle'))).toBeLessThan(15);
    await expect.poll(() => reading(page, 'hinge force')).toBeGreaterThan(0);
    await expect.poll(() => page.locator('.kv', { hasText: 'stinger angle' }).locator('.make').count()).toBe(1);
    await bench.shot(page, 'stinger');
  });
});
