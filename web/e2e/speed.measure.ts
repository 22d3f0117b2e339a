// How fast the picture follows a slider, and how fast it can be turned. Printed, with a modest least value:
// a machine without graphics card draws by the processor, which is what takes the time then.
import { loadavg } from 'node:os';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Page } from 'playwright-core';
import { solved, start, type Bench } from './harness';

let bench: Bench;
let page: Page;
beforeAll(async () => { bench = await start('bgl1.yaml'); page = await bench.open(); await solved(page); await page.waitForTimeout(1500); });
afterAll(async () => { await bench?.stop(); });

interface Watched { frames: number; redraw(): void }

test('slider to picture', async () => {
  const measured = await page.evaluate(async () => {
    const view = (window as unknown as { __view: Watched }).__view;
    const slider = document.querySelector<HTMLInputElement>('#s-tension')!;
    const asked = (): number => (window as unknown as { __solved: { count: number } }).__solved.count;
    const frame = (): Promise<unknown> => new Promise((done) => requestAnimationFrame(done));
    const move = (v: number): void => { slider.value = String(v); slider.dispatchEvent(new Event('input', { bubbles: true })); };
    const single: number[] = [];
    for (let i = 0; i < 20; ++i) {
      const before = asked(), drawn = view.frames, t = performance.now();
      move(250 + 3 * (i + 1));
      while ((asked() === before || view.frames === drawn) && performance.now() - t < 10_000) await new Promise((done) => setTimeout(done, 0));
      single.push(performance.now() - t);
    }
    const before = asked(), drawn = view.frames, t = performance.now();
    while (performance.now() - t < 4000) { move(250 + 100 * Math.sin((performance.now() - t) / 400)); await new Promise((done) => setTimeout(done, 16)); }
    const seconds = (performance.now() - t) / 1000;
    const rates = { solutions: (asked() - before) / seconds, pictures: (view.frames - drawn) / seconds };
    const start = view.frames, t2 = performance.now();
    while (performance.now() - t2 < 2000) { view.redraw(); await frame(); }
    return { single: single.sort((a, b) => a - b), ...rates, turning: ((view.frames - start) / (performance.now() - t2)) * 1000 };
  });
  const median = measured.single[Math.floor(measured.single.length / 2)]!;
  console.log(`slider to picture ${median.toFixed(0)} ms (median of 20, slowest ${measured.single.at(-1)!.toFixed(0)}); while dragging ${measured.solutions.toFixed(0)} solutions/s, ${measured.pictures.toFixed(0)} pictures/s; turning ${measured.turning.toFixed(0)} pictures/s; load ${loadavg()[0]!.toFixed(1)}`);
  expect(measured.solutions).toBeGreaterThan(2);
});
