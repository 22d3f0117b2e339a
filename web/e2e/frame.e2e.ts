// The frame of the page: address, selection, tree by keyboard, panel sizes, drawers, contrast, many screen sizes.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { faint } from './contrast';
import { goTo, reading, selectObject, showTab, solved, start, workspaces, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('bgl1.yaml'); page = await bench.open({ width: 1440, height: 900 }); await solved(page); });
afterAll(async () => { await bench?.stop(); });

const text = async (): Promise<string> => (await (await bench.api('model')).json() as { text: string }).text;
const item = (path: string) => page.locator(`[role=treeitem][data-object="${path}"]`);
const hash = (): Promise<string> => page.evaluate(() => decodeURI(location.hash));
/** The selected object: exactly one, in the tree and in the properties. */
async function chosen(): Promise<string> {
  const inTree = await page.locator('[role=treeitem][aria-selected=true]').evaluateAll((all) => all.map((el) => (el as HTMLElement).dataset.object!));
  const shown = await page.locator('.properties').getAttribute('data-object');
  expect(inTree).toEqual([shown]);
  return shown!;
}

test('an object that is selected in the tree shows its properties, and nothing else is selected', async () => {
  for (const [path, field] of [['tensioner', 'tensioner.tension'], ['pipe', 'pipe.steel.outside_diameter'], ['environment.waves', 'environment.waves.hs']] as const) {
    await selectObject(page, path);
    await expect.poll(() => chosen()).toBe(path);
    await expect.poll(() => page.locator(`[id="f-${field}"]`).count()).toBe(1);
  }
  await expect.poll(() => page.locator('.properties').getAttribute('aria-label')).toBe('Properties of Sea');
});

test('workspace and object are in the address: reload and back return there', async () => {
  await goTo(page, 'storm');
  await selectObject(page, 'supports.stinger');
  await expect.poll(() => hash()).toBe('#/storm/supports.stinger');
  await page.reload();
  await solved(page);
  await page.waitForSelector('main[data-workspace=storm]');
  await expect.poll(() => chosen()).toBe('supports.stinger');
  await goTo(page, 'study');
  await selectObject(page, 'vessel');
  await expect.poll(() => hash()).toBe('#/study/vessel');
  await page.goBack();
  await page.waitForSelector('main[data-workspace=storm]');
  await expect.poll(() => chosen()).toBe('supports.stinger');
  await page.goForward();
  await page.waitForSelector('main[data-workspace=study]');
  await page.goBack();
  await page.goBack();
  await page.waitForSelector('main[data-workspace=lay]');
  await page.waitForSelector('#workspace-lay[aria-current=page]');
});

test('an address that names neither workspace nor object leads to Lay', async () => {
  await page.evaluate(() => { location.hash = '#/nowhere/nothing'; });
  await page.waitForSelector('main[data-workspace=lay]');
  await page.waitForSelector('.properties');
  await goTo(page, 'lay');
});

test('workspaces are chosen with arrow keys', async () => {
  await page.focus('#workspace-lay');
  await page.keyboard.press('ArrowRight');
  await page.waitForSelector('main[data-workspace=operation]');
  await expect.poll(() => page.evaluate(() => document.activeElement!.id)).toBe('workspace-operation');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowLeft');
  await page.waitForSelector('main[data-workspace=report]');
  await page.keyboard.press('ArrowRight');
  await page.waitForSelector('main[data-workspace=lay]');
});

test('a finding marks its object in the tree, and leads to it and to its place', async () => {
  await showTab(page, 'diagrams');
  await selectObject(page, 'vessel');
  await page.waitForSelector('[role=treeitem][data-object="supports"] .mark.warn');
  await page.locator('.findings button', { hasText: 'stinger 8' }).click();
  await page.waitForSelector('.properties[data-object="supports.stinger.boxes[7]"]');
  await expect.poll(() => chosen()).toBe('supports.stinger.boxes[7]');
  await page.waitForSelector('[role=treeitem][data-object="supports.stinger.boxes[7]"] .mark.warn');
  await expect.poll(() => page.locator('.slot .read').first().innerText()).toMatch(/^stinger 8,/);
});

test('the tree is walked, unfolded and left for its fields by keyboard', async () => {
  await selectObject(page, 'environment');
  await item('environment').focus();
  await page.keyboard.press('Home');
  const first = await chosen();
  await page.keyboard.press('ArrowDown');
  const second = await chosen();
  expect(second).not.toBe(first);
  await page.keyboard.press('ArrowUp');
  await expect.poll(() => chosen()).toBe(first);
  await expect.poll(() => page.evaluate(() => (document.activeElement as HTMLElement).dataset.object)).toBe(first);
  await expect.poll(() => page.locator('[role=treeitem][tabindex="0"]').count()).toBe(1); // the tab key enters the tree at one item

  await selectObject(page, 'supports');
  await item('supports').focus();
  await page.keyboard.press('ArrowLeft');
  await expect.poll(() => item('supports').getAttribute('aria-expanded')).toBe('false');
  await expect.poll(() => item('supports.stinger').count()).toBe(0);
  await page.keyboard.press('ArrowRight');
  await expect.poll(() => item('supports').getAttribute('aria-expanded')).toBe('true');
  await page.keyboard.press('ArrowRight');
  const within = await chosen();
  expect(within).toMatch(/^supports\.\w+$/);
  await expect.poll(() => item(within).getAttribute('aria-level')).toBe('2');
  await page.keyboard.press('ArrowLeft'); // collapses an expanded item, otherwise moves to its parent
  await page.keyboard.press('ArrowLeft');
  await expect.poll(chosen).toBe('supports');

  await selectObject(page, 'tensioner');
  await item('tensioner').focus();
  await page.keyboard.press('Enter');
  await expect.poll(() => page.evaluate(() => document.activeElement!.closest('.properties') !== null && /^(INPUT|SELECT)$/.test(document.activeElement!.tagName))).toBe(true);
});

test('an object is deleted by keyboard, and undone', async () => {
  const before = await text();
  await selectObject(page, 'supports.stinger.boxes[2]');
  const boxes = await page.locator('[role=treeitem][data-object^="supports.stinger.boxes["]').count();
  await item('supports.stinger.boxes[2]').focus();
  await page.keyboard.press('Delete');
  await expect.poll(() => page.locator('[role=treeitem][data-object^="supports.stinger.boxes["]').count()).toBe(boxes - 1);
  await expect.poll(() => text()).not.toBe(before);
  await page.keyboard.press('Control+z');
  await expect.poll(text).toBe(before);
  await expect.poll(() => page.locator('[role=treeitem][data-object^="supports.stinger.boxes["]').count()).toBe(boxes);
  await solved(page);
});

test('the menu of an object opens at the pointer and by keyboard, duplicates, and shows the text', async () => {
  const before = await text();
  await item('supports.stinger.boxes[2]').click({ button: 'right' });
  await page.click('[role=menuitem] >> text=Duplicate');
  await expect.poll(text).not.toBe(before);
  await page.click('[aria-label=Undo]');
  await expect.poll(text).toBe(before);
  await selectObject(page, 'tensioner');
  await item('tensioner').focus();
  await page.keyboard.press('Shift+F10');
  await page.waitForSelector('[role=menu]');
  await page.keyboard.press('Escape');
  await expect.poll(() => page.locator('[role=menu]').count()).toBe(0);
  await expect.poll(() => page.evaluate(() => (document.activeElement as HTMLElement).dataset.object)).toBe('tensioner');
  await page.keyboard.press('Shift+F10');
  await page.click('[role=menuitem] >> text=Show in YAML');
  await page.waitForSelector('#docktab-yaml[aria-selected=true]');
  await expect.poll(() => page.locator('.cm-activeLine').first().innerText()).toMatch(/^tensioner:/);
  await showTab(page, 'diagrams');
});

/** Presses a key on a separator and returns the change in width or height of its panel. */
async function change(handle: string, part: string, measure: 'width' | 'height', key: string): Promise<number> {
  const size = async (): Promise<number> => (await page.locator(part).boundingBox())![measure];
  const before = await size();
  await page.locator(handle).press(key);
  return Math.round(await size() - before);
}

test('the dock and the columns are resized by keyboard, kept, and reset', async () => {
  for (const [handle, part, measure, more, less] of [
    ['.dockhandle', '.dock', 'height', 'ArrowUp', 'ArrowDown'],
    ['.handle[data-side=left]', 'main > .left', 'width', 'ArrowRight', 'ArrowLeft'],
    ['.handle[data-side=right]', 'main > .right', 'width', 'ArrowLeft', 'ArrowRight'],
  ] as const) {
    expect(await change(handle, part, measure, more)).toBeCloseTo(16, -1);
    expect(await change(handle, part, measure, more)).toBe(16);
    expect(await change(handle, part, measure, less)).toBe(-16);
    await expect.poll(() => page.locator(handle).getAttribute('role')).toBe('separator');
    expect(Number(await page.locator(handle).getAttribute('aria-valuenow'))).toBeCloseTo((await page.locator(part).boundingBox())![measure], -1);
  }
  const sizes = (): Promise<number[]> => page.evaluate(() => ['main > .left', 'main > .right', '.dock'].map((part) => { const r = document.querySelector(part)!.getBoundingClientRect(); return part === '.dock' ? r.height : r.width; }));
  const before = await sizes();
  await page.reload();
  await solved(page);
  await expect.poll(() => sizes()).toEqual(before);
  for (const handle of ['.dockhandle', '.handle[data-side=left]', '.handle[data-side=right]']) await page.locator(handle).press('Home');
  const usual = await sizes();
  expect(usual.every((size, i) => Math.abs(size - before[i]! + 16) <= 1)).toBe(true);
});

test('tabs of the dock are chosen with arrow keys, and either part can be maximised', async () => {
  await page.focus('#docktab-diagrams');
  await page.keyboard.press('ArrowRight');
  await expect.poll(() => page.locator('.docktabs [aria-selected=true]').count()).toBe(1);
  await expect.poll(() => page.evaluate(() => document.activeElement!.getAttribute('aria-selected'))).toBe('true');
  await page.keyboard.press('ArrowLeft');
  await expect.poll(() => page.evaluate(() => document.activeElement!.id)).toBe('docktab-diagrams');
  await page.click('.docktabs button.fill');
  await expect.poll(() => page.locator('.centre').isVisible()).toBe(false);
  await page.click('.docktabs button.fill');
  await expect.poll(() => page.locator('.centre').isVisible()).toBe(true);
  await expect.poll(() => page.locator('.dock').isVisible()).toBe(true);
});

test('at 1024 px the columns are drawers, which Escape closes', async () => {
  await page.setViewportSize({ width: 1024, height: 768 });
  for (const [name, part] of [['Model', '.left'], ['Verdict', '.right']] as const) {
    const button = page.locator('.drawerbutton', { hasText: name });
    await expect.poll(() => page.locator(`main > ${part}`).isVisible()).toBe(false);
    await button.focus();
    await page.keyboard.press('Enter');
    await expect.poll(() => page.locator(`main > ${part}`).isVisible()).toBe(true);
    await expect.poll(() => button.getAttribute('aria-expanded')).toBe('true');
    await page.keyboard.press('Escape');
    await expect.poll(() => page.locator(`main > ${part}`).isVisible()).toBe(false);
    await expect.poll(() => button.getAttribute('aria-expanded')).toBe('false');
  }
  await page.click('.drawerbutton >> text=Verdict');
  await expect.poll(() => reading(page, 'top tension')).toBeGreaterThan(10);
  await page.locator('.findings button', { hasText: 'stinger 8' }).click(); // its object is in the other drawer
  await page.keyboard.press('Escape');
  await page.setViewportSize({ width: 1440, height: 900 });
  for (const part of ['.left', '.right']) await expect.poll(() => page.locator(`main > ${part}`).isVisible()).toBe(true);
});

test('no text is fainter than 4.5 : 1, in any workspace or tab, light and dark', async () => {
  await bench.api('runs', { method: 'POST', body: JSON.stringify({ kind: 'static' }) });
  const found = new Map<string, string>(); // each with its first occurrence
  for (const colours of ['Light', 'Dark']) {
    if (await page.locator(`[aria-label="${colours} colours"]`).count()) await page.click(`[aria-label="${colours} colours"]`);
    for (const workspace of workspaces) {
      await goTo(page, workspace);
      const tabs = await page.locator('.docktabs [role=tab]').evaluateAll((all) => all.map((tab) => tab.id.replace('docktab-', '')));
      for (const tab of tabs.length ? tabs : ['']) {
        if (tab) await showTab(page, tab);
        await page.mouse.move(0, 0);
        await page.waitForTimeout(200);
        for (const text of await faint(page)) if (!found.has(text)) found.set(text, `${colours} ${workspace} ${tab}`);
      }
      await bench.shot(page, `frame-${colours.toLowerCase()}-${workspace}`);
      if (tabs.length) await showTab(page, tabs[0]!);
    }
  }
  expect([...found]).toEqual([]);
  await page.click('[aria-label="Light colours"]');
  await goTo(page, 'lay');
}, 400_000);

/** Parts that are wider than their container, or extend beyond the window. */
const tooWide = (p: Page): Promise<string[]> => p.evaluate(() => {
  const name = (el: Element): string => `${el.tagName.toLowerCase()}${el.id ? `#${el.id}` : ''}.${String((el as HTMLElement).className).replaceAll(' ', '.')}`;
  const parts = ['html', 'header.top', 'main', 'main > .left', 'main > .right', '.modeltree', '.properties', '.middle', '.underpicture', '.ownmiddle', '.strip'];
  const wide = [...document.querySelectorAll(parts.join(','))].filter((el) => el.scrollWidth > el.clientWidth + 1 && getComputedStyle(el).visibility === 'visible').map((el) => `${name(el)} ${el.scrollWidth} > ${el.clientWidth}`);
  const over = [...document.querySelectorAll('header.top button, header.top h1, .status, .docktabs, .viewbuttons')].filter((el) => {
    const r = el.getBoundingClientRect();
    return r.width > 0 && getComputedStyle(el).visibility === 'visible' && (r.left < -1 || r.right > innerWidth + 1);
  }).map((el) => `${name(el)} over the edge`);
  return [...wide, ...over];
});
/** Buttons of the header that overlap. */
const covered = (p: Page): Promise<string[]> => p.evaluate(() => {
  const shown = [...document.querySelectorAll('header.top > *, header.top .workspaces button')].filter((el) => el.getBoundingClientRect().width > 0);
  const out: string[] = [];
  for (const a of shown) for (const b of shown) {
    if (a === b || a.contains(b) || b.contains(a) || !(a.compareDocumentPosition(b) & Node.DOCUMENT_POSITION_FOLLOWING)) continue;
    const r = a.getBoundingClientRect(), q = b.getBoundingClientRect();
    if (Math.min(r.right, q.right) - Math.max(r.left, q.left) > 1 && Math.min(r.bottom, q.bottom) - Math.max(r.top, q.top) > 1) out.push(`${a.textContent} and ${b.textContent}`);
  }
  return out;
});

for (const [width, height, zoom] of [[1280, 720, 1], [1440, 900, 1], [2560, 1440, 1], [1024, 768, 1], [960, 600, 1.5]] as const) {
  test(`nothing is wider than its place at ${width * zoom} x ${height * zoom}${zoom > 1 ? ` and ${100 * zoom} %` : ''}`, async () => {
    const zoomed = await bench.open({ width, height, zoom });
    await solved(zoomed);
    for (const workspace of workspaces) {
      await goTo(zoomed, workspace);
      await zoomed.waitForTimeout(200);
      expect([...await tooWide(zoomed), ...await covered(zoomed)], workspace).toEqual([]);
      if (workspace !== 'runs' && workspace !== 'report' && workspace !== 'study') {
        const seen = (await zoomed.locator('.canvas').boundingBox())!;
        expect(seen.height, `picture of ${workspace}`).toBeGreaterThan(0.15 * height);
        expect((await zoomed.locator('.dockpanel').boundingBox())!.height, `dock of ${workspace}`).toBeGreaterThan(100);
      }
      await bench.shot(zoomed, `frame-${width}-${workspace}`);
    }
    await zoomed.context().close();
  });
}

test('no errors were logged in the browser', () => expect(bench.complaints).toEqual([]));
