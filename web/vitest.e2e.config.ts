import { defineConfig } from 'vitest/config';
import { BaseSequencer, type TestSpecification } from 'vitest/node';

/** Files that last longest begin first, so that none runs alone at the end. */
class LongestFirst extends BaseSequencer {
  override async sort(files: TestSpecification[]): Promise<TestSpecification[]> {
    const longest = ['memory', 'frame', 'sweep', 'look'];
    const rank = (file: TestSpecification): number => {
      const index = longest.findIndex((name) => file.moduleId.includes(`/${name}.`));
      return index < 0 ? longest.length : index;
    };
    return (await super.sort(files)).sort((a, b) => rank(a) - rank(b));
  }
}

// Every test file starts a real program and a browser: two files at a time, with time for a dynamic run.
export default defineConfig({
  test: { include: [process.env.OVERBEND_MEASURE ? '**/*.measure.ts' : '**/*.e2e.ts'], sequence: { sequencer: LongestFirst }, maxWorkers: 2, minWorkers: 2, expect: { poll: { timeout: 10_000 } }, testTimeout: 180_000, hookTimeout: 60_000 },
});
