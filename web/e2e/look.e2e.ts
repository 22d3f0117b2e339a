// Readability: names and limits in the diagrams, short findings, and the page on small screens.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { difference, goTo, installed, openField, picture, rested, solved, start, workspaces, type Bench } from './harness';

let bench: Bench;
beforeAll(async () => { bench = await start('bgl1.yaml'); });
afterAll(async () => { await bench?.stop(); });

/** Records every text drawn on a canvas. */
async function listen(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const said = new Set<string>();
    (window as unknown as { __said: Set<string> }).__said = said;
    const { fillText } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.fillText = function (text: string, ...rest: [number, number, number?]) { said.add(text); fillText.call(this, text, ...rest); };
  });
}
const said = (page: Page): Promise<string[]> => page.evaluate(() => [...(window as unknown as { __said: Set<string> }).__said]);

test('diagrams name their axes, their boxes and what is allowed', async () => {
  const page = await bench.open({ width: 1280, height: 720 }, listen);
  await solved(page);
  await page.selectOption('[aria-label="Diagram 1"]', 'von_mises');
  await page.selectOption('[aria-label="Diagram 2"]', 'reactions');
  await page.click('.docktabs button.fill'); // with room for complete names
  for (const word of ['arc length from the tensioner [m]', 'von Mises stress [MPa]', 'reaction [kN]', 'yield', 'stinger 1']) await expect.poll(() => said(page)).toContain(word);
  await page.selectOption('[aria-label="Diagram 1"]', 'elevation');
  for (const word of ['horizontal distance from the tensioner [m]', 'height above water [m]', 'water', 'seabed']) await expect.poll(() => said(page)).toContain(word);
  await page.selectOption('[aria-label="Diagram 1"]', 'strain');
  await expect.poll(async () => (await said(page)).some((w) => /^allowable, DNV/.test(w))).toBe(true);
  // under the pointer, a bar shows the name of its box
  const bars = (await page.locator('.slot').nth(1).locator('.u-over').boundingBox())!;
  await page.mouse.move(bars.x + bars.width / 2, bars.y + bars.height / 2);
  await expect.poll(() => page.locator('.slot').nth(1).locator('.read').innerText()).toMatch(/^(ramp|stinger) \d, /);
  await page.context().close();
});

/** Records for every name on an axis by how many pixels it extends beyond its diagram. */
async function measureNames(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const over: Record<string, number> = {};
    (window as unknown as { __over: Record<string, number> }).__over = over;
    const { fillText } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.fillText = function (text: string, ...rest: [number, number, number?]) {
      if (text.endsWith('from the tensioner [m]')) over[text] = this.measureText(text).width - this.canvas.width;
      fillText.call(this, text, ...rest);
    };
  });
}

/** Number of field parts that extend beyond the right edge of the properties, for any object. */
async function overhanging(page: Page): Promise<string[]> {
  const out: string[] = [];
  for (const item of await page.locator('[role=treeitem]').all()) {
    await item.click();
    out.push(...await page.locator('.properties .row > *').evaluateAll((all) => {
      const edge = document.querySelector('.properties')!.getBoundingClientRect().right;
      return all.filter((el) => el.getBoundingClientRect().right > edge + 1).map((el) => `${el.parentElement!.innerText}`);
    }));
  }
  return out;
}

for (const [fonts, name] of [['dejavu', 'from the tensioner [m]'], ['liberation', 'arc length from the tensioner [m]']] as const) {
  test.skipIf(!installed(fonts))(`at 1100 px fields stay in their column and names of axes in their diagram, in ${fonts}`, async () => {
    const separate = await start('bgl1.yaml', {}, fonts);
    const page = await separate.open({ width: 1600, height: 900 }, async (p) => {
      await measureNames(p);
      await p.addInitScript(() => {
        localStorage.setItem('overbend.diagrams', JSON.stringify(['bending_stress', 'elevation']));
        localStorage.setItem('overbend.left', '440'); // leaves the diagram 230 px
        localStorage.setItem('overbend.right', '430');
      });
    });
    await solved(page);
    await page.evaluate(() => { const { __over: over } = window as unknown as { __over: Record<string, number> }; for (const text of Object.keys(over)) delete over[text]; });
    await page.setViewportSize({ width: 1100, height: 800 });
    const over = (): Promise<Record<string, number>> => page.evaluate(() => (window as unknown as { __over: Record<string, number> }).__over);
    await expect.poll(async () => Object.keys(await over())).toContain(name); // complete if there is room, otherwise its end
    expect((await over())[name]).toBeLessThan(0);
    await page.locator('.handle[data-side=left]').press('Home');
    await expect.poll(() => overhanging(page)).toEqual([]);
    for (let i = 0; i < 8; ++i) await page.locator('.handle[data-side=left]').press('ArrowLeft');
    expect((await page.locator('main > .left').boundingBox())!.width).toBeCloseTo(200, -1);
    await expect.poll(() => overhanging(page)).toEqual([]);
    await page.context().close();
    expect(separate.complaints).toEqual([]);
    await separate.stop();
  });
}

test('findings are short, named, without paths of this machine, and folded after four', async () => {
  const page = await bench.open({ width: 1280, height: 720 }, async (p) => {
    await p.context().route('**/api/static', async (route) => {
      const answer = await route.fetch().catch(() => null); // the page may already be closed
      if (!answer) return;
      const json = await answer.json() as { findings?: object[] };
      json.findings?.push(...['/home/me/models/rao.csv: 3 headings only', 'a second', 'a third', 'the pipe has left the box over the side to port: it lies up to 1.47 m beyond the ends of the bottom rollers, which no longer hold it'].map((message) => ({ code: 'unknown', severity: 'caution', message })));
      await route.fulfill({ response: answer, json });
    });
  });
  await solved(page);
  const box = page.locator('.findings');
  await expect.poll(() => box.locator('li').count()).toBe(4);
  await expect.poll(() => box.locator('li').first().innerText()).toMatch(/^caution:\s+the pipe runs off[\s\S]*stinger 8$/);
  await expect.poll(() => box.innerText()).toContain('rao.csv: 3 headings');
  await expect.poll(() => box.innerText()).not.toContain('/home/me');
  await box.locator('text=2 more').click();
  await expect.poll(() => box.locator('li').count()).toBe(6);
  await expect.poll(() => box.locator('li').last().innerText()).toMatch(/^caution:\s+the pipe has left the box over the side to port …$/);
  await page.context().close();
});

/** Elements that extend beyond the window. */
const overEdge = (page: Page): Promise<string[]> => page.evaluate(() => [...document.querySelectorAll('header.top *, main *')].filter((el) => {
  const r = el.getBoundingClientRect();
  // elements that scroll within their own box may be wider
  const scrolled = el.closest('.labels3d, .u-wrap, .cm-editor, .fold .brief, .pins, .viewbuttons, .underpicture, .dockpanel, .docktabs, .workspaces, .strip');
  return r.width > 0 && getComputedStyle(el).visibility === 'visible' && !scrolled && (r.right > innerWidth + 1 || r.left < -1);
}).map((el) => `${el.tagName} ${el.className} in ${el.parentElement!.className}`));

for (const [width, height] of [[390, 844], [1024, 700]] as const) {
  test(`at ${width} px the side columns are drawers, and nothing hangs over the edge`, async () => {
    const page = await bench.open({ width, height });
    await solved(page);
    const drawers = { Model: '.left', Verdict: '.right' };
    for (const [name, pane] of Object.entries(drawers)) {
      await expect.poll(() => page.locator(`main > ${pane}`).isVisible()).toBe(false);
      await page.click(`.drawerbutton >> text=${name}`);
      for (const drawer of Object.values(drawers)) await expect.poll(() => page.locator(`main > ${drawer}`).isVisible()).toBe(drawer === pane);
      await expect.poll(() => overEdge(page)).toEqual([]);
      await bench.shot(page, `small-${width}-${name.toLowerCase()}`);
      await page.keyboard.press('Escape');
    }
    for (const workspace of [...workspaces, 'lay'] as const) {
      await goTo(page, workspace);
      expect(await overEdge(page), workspace).toEqual([]);
      await bench.shot(page, `small-${width}-${workspace}`);
    }
    await rested(page);
    const before = await picture(page, '.canvas');
    await page.click('.viewbuttons >> text=stinger');
    await expect.poll(async () => { await rested(page); return difference(page, before, await picture(page, '.canvas')); }).toBeGreaterThan(5);
    await (await openField(page, 'environment.water_depth')).fill(width === 390 ? '90 m' : '89 m');
    await page.keyboard.press('Enter');
    await solved(page);
    await page.context().close();
  });
}

test('no errors were logged in the browser', () => expect(bench.complaints).toEqual([]));
