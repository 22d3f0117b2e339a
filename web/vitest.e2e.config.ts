import { defineConfig } from 'vitest/config';

// Every file of tests drives a real program and a browser of its own: two files at a time, with room for a run in time.
export default defineConfig({
  test: { include: [process.env.OVERBEND_MEASURE ? '**/*.measure.ts' : '**/*.e2e.ts'], maxWorkers: 2, minWorkers: 2, expect: { poll: { timeout: 10_000 } }, testTimeout: 180_000, hookTimeout: 60_000 },
});
