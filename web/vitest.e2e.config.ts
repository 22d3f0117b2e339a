import { defineConfig } from 'vitest/config';

// Every test file starts a real program and a browser: two files at a time, with time for a dynamic run.
export default defineConfig({
  test: { include: [process.env.OVERBEND_MEASURE ? '**/*.measure.ts' : '**/*.e2e.ts'], maxWorkers: 2, minWorkers: 2, expect: { poll: { timeout: 10_000 } }, testTimeout: 180_000, hookTimeout: 60_000 },
});
