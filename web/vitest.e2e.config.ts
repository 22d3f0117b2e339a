import { defineConfig } from 'vitest/config';

// The tests drive one real program and one browser each: one after another, with room for a run in time.
export default defineConfig({
  test: { include: ['**/*.e2e.ts'], fileParallelism: false, testTimeout: 180_000, hookTimeout: 60_000 },
});
