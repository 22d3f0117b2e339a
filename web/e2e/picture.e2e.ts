// The picture: views, drawings, dragged boxes, shared selection, ruler, image, and playback of a run.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { colours, goTo, picture, rested, solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => {
  bench = await start('bgl1-workable-sea.yaml', { 'seed: 1': 'seed: 3', 'duration: 10800 s, build_up: 60 s': 'duration: 20 s, build_up: 60 s' });
  page = await bench.open({ width: 1440, height: 900 }, pictureOnly);
  await solved(page);
});
afterAll(async () => { await bench?.stop(); });

/** Hides the dock, so that the picture has its full size. */
async function pictureOnly(p: Page): Promise<void> { await p.addInitScript(() => { localStorage.setItem('overbend.middle', '"picture"'); }); }

const view = (name: string): Promise<void> => page.locator('.viewbuttons button', { hasText: new RegExp(`^${name}$`) }).click();
const text = async (): Promise<string> => (await (await bench.api('model')).json() as { text: string }).text;
const selectedPath = (): Promise<string> => page.evaluate(() => decodeURI(location.hash));

async function middle(box: string): Promise<[number, number]> {
  const r = (await page.locator(`[data-box="${box}"]`).boundingBox())!;
  return [r.x + r.width / 2, r.y + r.height / 2];
}

test('the legend ends at the yield stress, and names that are drawn do not cover each other', async () => {
  await view('overbend');
  await rested(page);
  await expect.poll(() => page.locator('.legend').innerText()).toMatch(/414 MPa[\s\S]*yield/);
  const covered = await page.locator('.label3d:visible').evaluateAll((all) => {
    const boxes = all.map((el) => el.getBoundingClientRect());
    const cards = [...document.querySelectorAll('section.picture [data-clear]')].map((el) => el.getBoundingClientRect());
    const over = (a: DOMRect, b: DOMRect): boolean => a.left < b.right - 1 && a.right > b.left + 1 && a.top < b.bottom - 1 && a.bottom > b.top + 1;
    return boxes.filter((a, i) => boxes.slice(i + 1).some((b) => over(a, b)) || cards.some((b) => over(a, b))).length;
  });
  expect(covered).toBe(0);
  await bench.shot(page, 'picture-overbend');
});

test('the side view draws pipe, hull and boxes and shows its scale', async () => {
  await view('side');
  await page.waitForSelector('.sideview');
  await expect.poll(() => page.locator('.boxhandle').count()).toBe(13);
  await expect.poll(() => page.locator('.scalewords').count()).toBe(0);
  await page.locator('.sidechoices button', { hasText: 'true scale' }).click();
  await expect.poll(() => page.locator('.scalewords').innerText()).toMatch(/heights × /);
  await bench.shot(page, 'picture-side-high');
  await page.locator('.sidechoices button', { hasText: 'true scale' }).click();
});

test('a box that is clicked in one view is selected in all', async () => {
  await page.locator('.sidechoices button', { hasText: 'boxes' }).click();
  await page.mouse.click(...await middle('stinger 4'));
  await expect.poll(selectedPath).toContain('supports.stinger.boxes[3]');
  await expect.poll(() => page.locator('.boxhandle.chosen').getAttribute('data-box')).toBe('stinger 4');
  await expect.poll(() => page.locator('.values').innerText()).toMatch(/stinger 4[\s\S]*reaction/);
  await bench.shot(page, 'picture-side-boxes');
  await view('section');
  await expect.poll(() => page.locator('.sectiontitle').innerText()).toMatch(/stinger 4/);
  await expect.poll(() => page.locator('.sectionrow').count()).toBe(3);
  await bench.shot(page, 'picture-section');
  await page.click('[aria-label="Next box"]');
  await expect.poll(selectedPath).toContain('supports.stinger.boxes[4]');
  await view('plan');
  await page.waitForSelector('.planbox.chosen title', { state: 'attached' });
  await expect.poll(() => page.locator('.planbox.chosen title').textContent()).toBe('stinger 5');
  await bench.shot(page, 'picture-plan');
  await view('stinger');
  await expect.poll(() => page.locator('.label3d.chosen').innerText()).toBe('stinger 5');
});

test('a box is dragged with live statics, put back by Esc, and written as one step of undo', async () => {
  await view('side');
  await page.locator('.sidechoices button', { hasText: 'boxes' }).click();
  const before = await text();
  const [x, y] = await middle('stinger 5');
  const asked = (): Promise<number> => page.evaluate(() => (window as unknown as { __solved: { count: number } }).__solved.count);
  const had = await asked();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 6, y + 6, { steps: 6 });
  await expect.poll(asked).toBeGreaterThan(had);
  await expect.poll(() => page.locator('.dragreading').innerText()).toMatch(/stinger 5 x [\d.]+ m, z -[\d.]+ m/);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await expect.poll(() => page.locator('.dragreading').count()).toBe(0);
  await expect.poll(() => text()).toBe(before);

  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 5, y + 5, { steps: 5 });
  await bench.shot(page, 'picture-drag');
  await page.mouse.up();
  await expect.poll(text).not.toBe(before);
  const after = await text();
  expect(after).not.toMatch(/stinger 5, x: 20\.348 m/);
  expect(after).not.toMatch(/x: [\d.]+ m, z: -9\.858 m/);
  await page.click('[aria-label="Undo"]');
  await expect.poll(text).toBe(before);
});

test('the ruler measures between two clicks, and Esc ends it', async () => {
  await page.locator('.sidechoices button', { hasText: 'whole' }).click();
  const svg = (await page.locator('.sideview').boundingBox())!, y = svg.y + 0.45 * svg.height;
  await page.locator('.picturetools button', { hasText: 'ruler' }).click();
  await page.mouse.click(svg.x + 300, y);
  await page.mouse.click(svg.x + 400, y);
  await expect.poll(() => page.locator('.measured').innerText()).toMatch(/^[\d.]+ m\s+dx -[\d.]+\s+dy 0.00\s+dz 0.00/);
  await view('whole');
  await rested(page);
  const canvas = (await page.locator('.canvas').boundingBox())!;
  await page.mouse.click(canvas.x + 300, canvas.y + 0.5 * canvas.height);
  await page.mouse.click(canvas.x + 420, canvas.y + 0.6 * canvas.height);
  await expect.poll(() => page.locator('.measured').innerText()).toMatch(/^[\d.]+ m/);
  await page.keyboard.press('Escape');
  await expect.poll(() => page.locator('.measured').count()).toBe(0);
});

test('the picture is saved as PNG, of the 3-D view and of a drawing', async () => {
  for (const name of ['overbend', 'side']) {
    await view(name);
    const [file] = await Promise.all([page.waitForEvent('download'), page.locator('.picturetools button', { hasText: 'PNG' }).click()]);
    const data = readFileSync(await file.path());
    expect(data.subarray(1, 4).toString()).toBe('PNG');
    expect(await colours(page, `data:image/png;base64,${data.toString('base64')}`)).toBeGreaterThan(6);
  }
});

for (const [name, width, height] of [['flat', 1440, 560], ['narrow', 1024, 768]] as const) {
  test(`no part of the picture hangs over its edge, ${name}`, async () => {
    await page.setViewportSize({ width, height });
    for (const shown of ['overbend', 'side', 'section', 'plan']) {
      await view(shown);
      await page.waitForTimeout(300);
      const outside = await page.evaluate(() => {
        const box = document.querySelector('section.picture')!.getBoundingClientRect();
        return [...document.querySelectorAll('section.picture [data-clear]')].filter((el) => {
          const r = el.getBoundingClientRect();
          return r.width > 0 && (r.left < box.left - 1 || r.right > box.right + 1 || r.bottom > box.bottom + 1);
        }).map((el) => el.className);
      });
      expect(outside).toEqual([]);
      await bench.shot(page, `picture-${name}-${shown}`);
    }
    await page.setViewportSize({ width: 1440, height: 900 });
    await view('overbend');
  });
}

test('playback goes to the events of a run in turn, and to the maximum of any history', async () => {
  await goTo(page, 'storm');
  await page.locator('.stormacts button.main').click();
  await page.waitForSelector('.animation', { timeout: 150_000 });
  await page.getByRole('button', { name: 'worst impact' }).click();
  const clock = async (): Promise<number> => Number.parseFloat(await page.locator('.clock').innerText());
  await page.getByRole('button', { name: 'Previous event' }).click();
  const first = await clock();
  await page.getByRole('button', { name: /^next event/ }).click();
  await expect.poll(clock).toBeGreaterThan(first);
  await page.selectOption('[aria-label="Go to extreme of"]', { label: 'Top tension' });
  await expect.poll(() => page.locator('.caption .reached').innerText()).toMatch(/largest: Top tension, [\d.]+ kN/);
  await expect.poll(() => page.locator('.caption').innerText()).toMatch(/t = [\d.]+ s · roll -?[\d.]+° · heave -?[\d.]+ m · tension [\d.]+ kN/);
  await view('side');
  await page.waitForTimeout(300);
  await bench.shot(page, 'picture-storm-side');
  await expect.poll(() => page.locator('.boxhandle.movable').count()).toBe(0);
  await view('whole');
});

test('in the dark, at 1024 px, the picture is readable', async () => {
  await page.evaluate(() => { location.hash = '#/lay'; });
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.evaluate(() => { document.documentElement.dataset.theme = 'dark'; });
  await page.setViewportSize({ width: 1024, height: 768 });
  // a drawing has few colours on a dark background
  for (const [name, least] of [['whole', 5], ['side', 4], ['section', 4], ['plan', 4]] as const) {
    await view(name);
    await page.waitForTimeout(600);
    await bench.shot(page, `picture-dark-${name}`);
    expect(await colours(page, await picture(page, 'section.picture')), name).toBeGreaterThanOrEqual(least);
  }
});

test('models of other kinds have the drawings that they need', async () => {
  const put = async (name: string): Promise<void> => {
    const { revision } = await (await bench.api('model')).json() as { revision: number };
    await bench.api('model', { method: 'PUT', body: JSON.stringify({ text: readFileSync(join(bench.folder, name), 'utf8'), revision, name }) });
  };
  for (const [name, expected] of [['moored-barge.yaml', ['side', 'plan']], ['jumper.yaml', ['side', 'plan']], ['shore-pull.yaml', ['side', 'section', 'plan']]] as const) {
    await put(name);
    const drawings = async (): Promise<string[]> => (await page.locator('.viewbuttons button').allInnerTexts()).filter((b) => ['side', 'section', 'plan'].includes(b));
    await expect.poll(drawings, { timeout: 30_000 }).toEqual(expected);
    for (const drawing of expected) {
      await view(drawing);
      await page.waitForSelector('svg.pictured');
      await page.waitForTimeout(300);
      await bench.shot(page, `picture-${name.replace('.yaml', '')}-${drawing}`);
    }
  }
});

test('no errors were logged in the browser', () => expect(bench.complaints.filter((c) => !c.includes('api/model/disk'))).toEqual([]));
