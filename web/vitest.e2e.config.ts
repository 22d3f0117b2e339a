import { defineConfig } from 'vitest/config';

// The tests drive one real program and one browser each: one after another, with room for a run in time.
export default defineConfig({
  test: { include: [process.env.OVERBEND_MEASURE ? '**/*.measure.ts' : '**/*.e2e.ts'], fileParallelism: false, expect: { poll: { timeout: 10_000 } }, testTimeout: 180_000, hookTimeout: 60_000 },
});
