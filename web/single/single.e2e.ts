// The single file, opened cold from a folder: no server, nothing loaded, everything kept in the browser.
// OVERBEND_SINGLE: the file.
import { mkdtempSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium, type BrowserContext, type Page } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { goTo, reading, solved } from '../e2e/harness';

const file = process.env.OVERBEND_SINGLE!;
const profile = mkdtempSync(join(tmpdir(), 'overbend-single-'));
let context: BrowserContext;
let page: Page;
const requests: string[] = [];
const complaints: string[] = [];

async function launch(): Promise<void> {
  context = await chromium.launchPersistentContext(profile, { executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'], viewport: { width: 1440, height: 900 }, acceptDownloads: true });
  page = context.pages()[0] ?? await context.newPage();
  page.on('request', (request) => { if (/^(https?|ws):/.test(request.url())) requests.push(request.url()); });
  page.on('console', (message) => { if (message.type() === 'error') complaints.push(message.text()); });
  page.on('pageerror', (error) => complaints.push(error.message));
  await page.goto(pathToFileURL(file).href);
}

beforeAll(launch);
afterAll(async () => { await context?.close(); rmSync(profile, { recursive: true, force: true }); });

async function openExample(name: string): Promise<void> {
  await page.keyboard.press('Escape');
  await page.click('header >> text=Open…');
  await page.locator('dialog .filelist button', { has: page.locator('.brief', { hasText: new RegExp(`^${name}$`) }) }).click();
  await solved(page);
}

test('it is smaller than 10 MB', () => {
  expect(statSync(file).size).toBeLessThan(10e6);
});

test('an example is solved', async () => {
  await page.waitForSelector('dialog[open]');
  await openExample('bgl1');
  await expect.poll(() => reading(page, 'top tension')).toBeCloseTo(250, 0);
  await expect.poll(() => reading(page, 'lay-back')).toBeCloseTo(335.6, 0);
});

test('a slider is dragged with live statics', async () => {
  await page.locator('[id="s-tensioner.tension"]').fill('300');
  await expect.poll(() => reading(page, 'top tension')).toBeCloseTo(300, 0);
});

test('a run in time is followed, and leaves histories and a report', async () => {
  await goTo(page, 'storm');
  await page.locator('.stormacts button.main').click();
  await page.waitForSelector('.stormbar [role=progressbar]');
  await page.waitForFunction(() => document.querySelectorAll('.stormplots .u-wrap').length >= 2, undefined, { timeout: 150_000 });
  await page.locator('.stormbar').getByRole('button', { name: 'Cancel' }).click();
  await page.waitForFunction(() => !document.querySelector('.stormbar [role=progressbar]'), undefined, { timeout: 60_000 });
  await goTo(page, 'runs');
  await expect.poll(() => page.locator('table.runlist tbody tr').first().innerText(), { timeout: 120_000 }).toMatch(/done|cancel|stopped|passed|exceeded/i);
});

test('the report is made and shown', async () => {
  await goTo(page, 'report');
  await page.getByRole('button', { name: 'Make the report' }).click();
  await page.frameLocator('iframe.reportpage').locator('h1').waitFor({ timeout: 60_000 });
});

test('a model that was saved is there in another tab, and after the browser was closed', async () => {
  const secondTab = await context.newPage();
  await secondTab.goto(pathToFileURL(file).href);
  await secondTab.waitForSelector('dialog[open]');
  await secondTab.keyboard.press('Escape');
  await page.bringToFront();
  await goTo(page, 'lay');
  await page.click('[aria-label="More save options"]');
  await page.click('[role=menuitem] >> text=Save as…');
  await page.fill('#save-name', 'mine');
  await page.click('dialog button.main');
  await page.waitForSelector('.notice.good');
  await page.waitForTimeout(500);
  await secondTab.bringToFront();
  await secondTab.click('header >> text=Open…');
  await secondTab.locator('dialog .filelist button', { hasText: 'mine.yaml' }).waitFor();
  await context.close();
  await launch();
  await page.waitForSelector('dialog[open]');
  await page.keyboard.press('Escape');
  await page.click('header >> text=Open…');
  await page.locator('dialog .filelist button', { hasText: 'mine.yaml' }).click();
  await solved(page);
});

test('nothing was requested, and no errors were logged', () => {
  expect(requests).toEqual([]);
  expect(complaints).toEqual([]);
});
