// Sensitivities of a key result, with BGL-1.
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { goTo, showTab, solved, start, tryValue, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('bgl1.yaml'); page = await bench.open({ width: 1440, height: 900 }); await solved(page); await page.click('#docktab-sensitivities'); });
afterAll(async () => { await bench?.stop(); });

test('a tornado of the chosen result', async () => {
  await showTab(page, 'sensitivities');
  const panel = page.locator('section[aria-label="Sensitivities"]');
  await panel.locator('button').click();
  await panel.locator('.tornado li').first().waitFor();
  await panel.locator('select').selectOption('static.bottom_tension');
  // The top tension is the tension at touchdown plus the weight of the suspended pipe, and nothing else.
  const foremost = panel.locator('.tornado li').first();
  await expect.poll(() => foremost.locator('.what').innerText()).toMatch(/^tensioner\.tension ± 2\.5 kN/);
  await expect.poll(() => foremost.locator('b').innerText()).toMatch(/^\+2\.\d+ kN/);
  await expect.poll(() => panel.locator('.tornado li').count()).toBe(12);
  await panel.scrollIntoViewIfNeeded();
  await bench.shot(page, 'sensitivities');
});

test('they are marked as outdated during a trial', async () => {
  await tryValue(page, 'tension', 300);
  await page.locator('section.sensitivities.old').waitFor();
});

const anew = async (): Promise<void> => {
  const panel = page.locator('section[aria-label="Sensitivities"]');
  await panel.locator('button').click();
  await panel.locator('.tornado li').first().waitFor();
};

test('they vanish when the model is changed', async () => {
  await page.click('text=Apply to model');
  await expect.poll(() => page.locator('.tornado').count()).toBe(0);
  await anew();
  await page.click('[aria-label=Undo]');
  await expect.poll(() => page.locator('.tornado').count()).toBe(0);
});

test('a key shows its own effect from the menu of its field', async () => {
  await anew();
  await page.click('[role=treeitem][data-object="tensioner"]');
  await page.locator('label[for="f-tensioner.tension"]').click({ button: 'right' });
  await page.click('.menu >> text=Sensitivity');
  const effect = page.locator('dialog tbody tr', { hasText: 'bottom tension' });
  await effect.waitFor();
  await expect.poll(() => effect.innerText()).toMatch(/\+\d(\.\d+)? kN\s+-\d/);
  await bench.shot(page, 'key-sensitivity');
  await page.keyboard.press('Escape');
  await page.waitForSelector('dialog', { state: 'detached' });
});

test('a new model has neither those of the earlier one nor its lay table', async () => {
  await expect.poll(() => page.locator('.tornado li').count()).toBeGreaterThan(0);
  await goTo(page, 'study');
  await page.selectOption('#lt-over', 'tension');
  await page.fill('[aria-label="from … to, in steps, from"]', '250 kN');
  await page.fill('[aria-label="from … to, in steps, to"]', '400 kN');
  await page.fill('[aria-label="from … to, in steps, steps"]', '2');
  await page.click('.studystrip .main');
  await page.locator('table.lay-rows tbody tr').first().waitFor({ timeout: 60_000 });
  await page.click('header >> text=New…');
  if (await page.locator('text=Continue without saving').count()) await page.click('text=Continue without saving');
  await page.waitForSelector('#n-depth');
  await page.fill('#n-depth', '60 m');
  await page.click('dialog button.main');
  await expect.poll(() => page.locator('dialog[open]').count(), { timeout: 30_000 }).toBe(0);
  await solved(page);
  await expect.poll(() => page.locator('table.lay-rows').count()).toBe(0);
  await goTo(page, 'lay');
  await showTab(page, 'sensitivities');
  await expect.poll(() => page.locator('.tornado').count()).toBe(0);
  await expect.poll(() => page.locator('section[aria-label="Sensitivities"] button').innerText()).toMatch(/^Compute the/);
});
