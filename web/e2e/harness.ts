// Starts the real program on a separate folder and opens its page in a browser.
// OVERBEND_SHOTS: folder for pictures, none without. OVERBEND_PROGRAM: the program, or OVERBEND_SINGLE: the single file, whose program is within the page. OVERBEND_ROOT: folder of examples/ and data/. OVERBEND_PREVIEW=1: serves the page from web/dist instead of from the program.
import { execFileSync, spawn, type ChildProcess } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, relative, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { chromium, type Browser, type Locator, type Page } from 'playwright-core';
import { preview, type PreviewServer } from 'vite';

const thisFolder = dirname(fileURLToPath(import.meta.url));
/** Folder of examples, data and validation. */
export const root = process.env.OVERBEND_ROOT ?? resolve(thisFolder, '../..');
const program = resolve(root, process.env.OVERBEND_PROGRAM ?? 'build/release/overbend');
const shots = process.env.OVERBEND_SHOTS ? resolve(thisFolder, '..', process.env.OVERBEND_SHOTS) : undefined;
/** True if pictures are taken: only where OVERBEND_SHOTS names their folder. */
export const takesPictures = shots !== undefined;
const shot = async (page: Page, name: string): Promise<void> => { if (shots) await page.screenshot({ path: join(shots, `${name}.png`) }); };

export interface Bench {
  folder: string;
  address: string;
  api: (path: string, options?: RequestInit) => Promise<Response>;
  /** `zoom`: browser zoom, with the window size in CSS pixels; `prepare` runs before the page is requested. */
  open: (size?: { width: number; height: number; zoom?: number }, prepare?: (page: Page) => Promise<void>) => Promise<Page>;
  shot: (page: Page, name: string) => Promise<void>;
  complaints: string[];
  /** Ends the program and closes the page. */
  halt: () => Promise<void>;
  stop: () => Promise<void>;
}

function started(child: ChildProcess): Promise<string> {
  return new Promise((done, fail) => {
    let text = '';
    const read = (data: Buffer): void => {
      text += String(data);
      const found = /http:\/\/127\.0\.0\.1:\d+\/\?token=\w+/.exec(text);
      if (found) done(found[0]);
    };
    child.stdout!.on('data', read);
    child.stderr!.on('data', read);
    child.on('error', fail);
    child.on('exit', (code) => fail(new Error(`the program ended with ${code}: ${text}`)));
    setTimeout(() => fail(new Error(`the program did not say its address: ${text}`)), 20_000).unref();
  });
}

/** Fixed fonts for the browser, independent of those of the machine: see tests/fonts. */
export type Fonts = 'dejavu' | 'liberation';
const families: Record<Fonts, string> = { dejavu: 'DejaVu Sans', liberation: 'Liberation Sans' };
function fontEnvironment(fonts: Fonts): Record<string, string> {
  return { ...process.env, FONTCONFIG_FILE: join(root, 'tests', 'fonts', `${fonts}.conf`) } as Record<string, string>;
}
export function installed(fonts: Fonts): boolean {
  return execFileSync('fc-match', ['sans', 'family'], { env: fontEnvironment(fonts), encoding: 'utf8' }).includes(families[fonts]);
}

/** The same for the single file, OVERBEND_SINGLE: the model folder is in the browser, and there is no program to end. */
async function startSingle(file: string, outer: string, folder: string, fonts: Fonts, model?: string): Promise<Bench> {
  const context = await chromium.launchPersistentContext(join(outer, 'profile'), { executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'], env: fontEnvironment(fonts), acceptDownloads: true });
  const address = `${pathToFileURL(file).href}?debug`;
  const complaints: string[] = [];
  const files = [['models', folder], ['data', join(outer, 'data')]].flatMap(([name, from]) =>
    readdirSync(from!, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile()).map((entry) => {
      const path = join(entry.parentPath ?? entry.path, entry.name);
      return { path: `/${name}/${relative(from!, path)}`, base64: readFileSync(path).toString('base64') };
    }));
  let first: Page | undefined;
  const ready = (page: Page): Promise<unknown> => page.waitForFunction(() => (window as unknown as { __ready?: boolean }).__ready === true);
  const api = async (path: string, options: RequestInit = {}): Promise<Response> => {
    const { status, text } = await first!.evaluate(([method, path, body]) =>
      (window as unknown as { overbendTransport: { request: (method: string, path: string, body?: string) => Promise<{ status: number; text: string }> } }).overbendTransport.request(method!, path!, body),
    [options.method ?? 'GET', path, options.body as string | undefined]);
    return new Response(text, { status });
  };
  return {
    folder, address, complaints, api,
    open: async ({ zoom: _zoom = 1, ...size } = { width: 1280, height: 720 }, prepare) => {
      const page = await context.newPage();
      first ??= page;
      await page.setViewportSize(size);
      page.on('console', (m) => { if (m.type() === 'error') complaints.push(m.text()); });
      page.on('pageerror', (e) => complaints.push(e.message));
      await prepare?.(page);
      await page.goto(address);
      await ready(page);
      await page.evaluate(async (files) => {
        const database = await new Promise<IDBDatabase>((done, fail) => { const r = indexedDB.open('overbend', 1); r.onupgradeneeded = () => r.result.createObjectStore('files'); r.onsuccess = () => done(r.result); r.onerror = () => fail(r.error!); });
        const transaction = database.transaction('files', 'readwrite');
        for (const { path, base64 } of files) transaction.objectStore('files').put(Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)), path);
        await new Promise((done) => { transaction.oncomplete = done; });
      }, files);
      await page.reload();
      await ready(page);
      if (model) {
        await page.waitForSelector('dialog[open]');
        await page.keyboard.press('Escape');
        await page.click('header >> text=Open…');
        await page.locator('dialog .filelist button', { has: page.locator(`text="${model}"`) }).first().click();
      }
      return page;
    },
    shot,
    halt: () => Promise.reject(new Error('the single file has no program to end')),
    stop: async () => {
      await context.close();
      rmSync(outer, { recursive: true, force: true });
    },
  };
}

/** `edit`: change of the model before it is opened. */
export async function start(model?: string, edit: Record<string, string> = {}, fonts: Fonts = 'dejavu'): Promise<Bench> {
  if (!installed(fonts)) throw new Error(`${families[fonts]} is not installed: scripts/install.sh test`);
  const outer = mkdtempSync(join(tmpdir(), 'overbend-page-'));
  const folder = join(outer, 'models');
  cpSync(join(root, 'examples'), folder, { recursive: true });
  cpSync(join(root, 'data'), join(outer, 'data'), { recursive: true });
  if (model) writeFileSync(join(folder, model), Object.entries(edit).reduce((text, [from, to]) => text.replace(from, to), readFileSync(join(folder, model), 'utf8')));
  if (shots) mkdirSync(shots, { recursive: true });
  if (process.env.OVERBEND_SINGLE) return startSingle(resolve(root, process.env.OVERBEND_SINGLE), outer, folder, fonts, model);
  const child = spawn(program, ['serve', ...(model ? [join(folder, model)] : []), '--no-browser', '--folder', folder], { stdio: 'pipe' });
  const ownAddress = new URL(await started(child));
  let server: PreviewServer | null = null;
  let address = ownAddress.href;
  if (process.env.OVERBEND_PREVIEW) {
    const proxy = { '/api': { target: ownAddress.origin, changeOrigin: true, configure: (p: { on: (name: 'proxyReq', act: (r: { setHeader: (k: string, v: string) => void }) => void) => void }) => p.on('proxyReq', (r) => r.setHeader('origin', ownAddress.origin)) } };
    server = await preview({ root: resolve(thisFolder, '..'), preview: { port: 0, host: '127.0.0.1', proxy: proxy as never }, logLevel: 'error' });
    const where = server.httpServer.address();
    address = `http://127.0.0.1:${typeof where === 'object' && where ? where.port : 0}/${ownAddress.search}`;
  }
  const browser: Browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'], env: fontEnvironment(fonts) });
  const complaints: string[] = [];
  const token = ownAddress.searchParams.get('token')!;
  const halt = async (): Promise<void> => {
    if (child.exitCode !== null) return;
    const gone = new Promise((done) => child.once('exit', done));
    child.kill('SIGINT');
    await gone;
  };
  return {
    folder, address, complaints, halt,
    api: (path, options = {}) => fetch(`${ownAddress.origin}/api/${path}`, { ...options, headers: { 'X-Overbend-Token': token, ...options.headers } }),
    open: async ({ zoom = 1, ...size } = { width: 1280, height: 720 }, prepare) => {
      const context = await browser.newContext({ viewport: size, deviceScaleFactor: zoom, acceptDownloads: true });
      const page = await context.newPage();
      page.on('console', (m) => { if (m.type() === 'error') complaints.push(`${m.text()} ${m.location().url.replace(/token=\w+/, '')}`); });
      page.on('pageerror', (e) => complaints.push(e.message));
      await prepare?.(page);
      await page.goto(address);
      await page.waitForFunction(() => (window as unknown as { __ready?: boolean }).__ready === true); // as a string it would need eval, which the page forbids
      return page;
    },
    shot,
    stop: async () => {
      await browser.close();
      await server?.close();
      await halt();
      if (existsSync(outer)) rmSync(outer, { recursive: true, force: true });
    },
  };
}

/** Status of the live statics in the header. */
export const solved = (page: Page): Promise<unknown> => page.waitForSelector('.status.good', { timeout: 30_000 });

/** First number of a result: from the static column of the table of key results, otherwise from a list in the dock. */
export async function reading(page: Page, name: string): Promise<number> {
  const row = page.locator('.keyresults .kv, .dock .kv', { hasText: name }).first();
  return Number.parseFloat(await row.locator('td, dd').first().innerText());
}

export const workspaces = ['lay', 'operation', 'storm', 'study', 'runs', 'report'] as const;
export type Workspace = (typeof workspaces)[number];
export async function goTo(page: Page, workspace: Workspace): Promise<void> {
  await page.click(`#workspace-${workspace}`);
  await page.waitForSelector(`main[data-workspace="${workspace}"]`);
}

/** Shows a tab of the dock in the open workspace. */
export async function showTab(page: Page, tab: string): Promise<void> {
  await page.click(`#docktab-${tab}`);
  await page.waitForSelector(`#docktab-${tab}[aria-selected="true"]`);
}

/** Opens the drawer of a side column on narrow screens. */
export async function openDrawer(page: Page, name: 'Model' | 'Verdict'): Promise<void> {
  const button = page.locator('.drawerbutton', { hasText: name });
  if (await button.isVisible() && await button.getAttribute('aria-expanded') === 'false') await button.click();
}

/** An object and its parents: "supports", "supports.stinger", "supports.stinger.boxes", "supports.stinger.boxes[2]". */
const downTo = (path: string): string[] => [...path.matchAll(/\.|\[|$/g)].map((end) => path.slice(0, end.index)).filter(Boolean);

/** Selects an object in the tree and expands its parents. */
export async function selectObject(page: Page, path: string): Promise<void> {
  await openDrawer(page, 'Model');
  for (const step of downTo(path)) {
    const item = page.locator(`[role=treeitem][data-object="${step}"]`);
    if (await item.getAttribute('aria-selected') !== 'true') await item.click();
  }
  await page.waitForSelector(`.properties[data-object="${path}"]`);
}

/** Field of a key in the properties of its object; optional fields are expanded if necessary. */
export async function openField(page: Page, path: string): Promise<Locator> {
  await selectObject(page, path.replace(/(\.[^.[]*|\[\d+\])$/, ''));
  const field = page.locator(`[id="f-${path}"]`), more = page.locator('.properties > button.more[aria-expanded=false]');
  if (!await field.count() && await more.count()) await more.click();
  await field.waitFor();
  return field;
}

/** Moves the slider of a pinned key; the trial value is not yet in the model. */
export async function tryValue(page: Page, name: string, value: number): Promise<void> {
  await page.getByRole('slider', { name, exact: true }).evaluate((el, v) => {
    const input = el as HTMLInputElement;
    input.value = String(v);
    input.dispatchEvent(new Event('input', { bubbles: true }));
  }, value);
}

/** Runs the model, waits for its end and returns the name of its folder. `order`: body of POST runs. */
export async function runToEnd(bench: Bench, order: object): Promise<string> {
  const { id } = await (await bench.api('runs', { method: 'POST', body: JSON.stringify(order) })).json() as { id: string };
  const state = async (): Promise<string> => (await (await bench.api('runs')).json() as { id: string; state: string }[]).find((run) => run.id === id)!.state;
  for (let current = await state(); current !== 'done'; current = await state()) {
    if (current !== 'running' && current !== 'queued') throw new Error(`the run ${id} is ${current}`);
    await new Promise((wait) => setTimeout(wait, 200));
  }
  return id;
}

/** Runs a dynamic analysis of the model and opens its results in the workspace Storm. */
export async function runStorm(bench: Bench, page: Page, seconds: number): Promise<string> {
  const id = await runToEnd(bench, { kind: 'dynamic', duration: seconds });
  await goTo(page, 'storm');
  await page.selectOption('select[aria-label="Run shown"]', id);
  await page.locator('.right .standing', { hasText: /seed \d/ }).waitFor({ timeout: 30_000 });
  return id;
}

/** Screenshot of a part of the page, to be compared with others. */
export const picture = async (page: Page, selector: string): Promise<string> => `data:image/png;base64,${(await page.locator(selector).screenshot()).toString('base64')}`;

/** Mean difference of two pictures of the same size, 0 to 255; decoded in the browser. */
export function difference(page: Page, a: string, b: string): Promise<number> {
  return page.evaluate(async (sources) => {
    const [first, second] = await Promise.all(sources.map(async (source) => {
      const image = new Image();
      image.src = source;
      await image.decode();
      const canvas = document.createElement('canvas');
      canvas.width = image.width; canvas.height = image.height;
      canvas.getContext('2d')!.drawImage(image, 0, 0);
      return canvas.getContext('2d')!.getImageData(0, 0, image.width, image.height);
    }));
    if (first!.width !== second!.width || first!.height !== second!.height) return 255;
    let sum = 0;
    for (let i = 0; i < first!.data.length; ++i) sum += Math.abs(first!.data[i]! - second!.data[i]!);
    return sum / first!.data.length;
  }, [a, b]);
}

/** Number of distinct colours (of 8 x 8 x 8 bins), each in at least one of a thousand pixels. */
export function colours(page: Page, a: string): Promise<number> {
  return page.evaluate(async (source) => {
    const image = new Image();
    image.src = source;
    await image.decode();
    const canvas = document.createElement('canvas');
    canvas.width = image.width; canvas.height = image.height;
    canvas.getContext('2d')!.drawImage(image, 0, 0);
    const { data } = canvas.getContext('2d')!.getImageData(0, 0, image.width, image.height);
    const counts = new Map<number, number>();
    for (let i = 0; i < data.length; i += 4) { const k = ((data[i]! >> 5) << 6) | ((data[i + 1]! >> 5) << 3) | (data[i + 2]! >> 5); counts.set(k, (counts.get(k) ?? 0) + 1); }
    return [...counts.values()].filter((n) => n > data.length / 4000).length;
  }, a);
}

/** Waits until the picture is at rest and drawn at full resolution, at any frame rate. */
export async function rested(page: Page): Promise<void> {
  await page.waitForFunction(async () => {
    const view = (window as unknown as { __view?: { frames: number; coarse: number; flight: { path: unknown } } }).__view;
    if (!view) return false;
    const before = view.frames;
    await new Promise((done) => setTimeout(done, 400));
    return before > 0 && view.frames === before && view.coarse === 1 && !view.flight.path;
  }, undefined, { timeout: 20_000 });
}
