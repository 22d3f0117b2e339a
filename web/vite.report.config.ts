// The page of the HTML report: one classic script and one style sheet, which the program writes into every report.
import { defineConfig, type Plugin } from 'vite';

/** Lists the bundled packages, whose licences are included in every report. The script must not end its element. */
function listPackages(): Plugin {
  return {
    name: 'list-packages',
    generateBundle(_options, bundle) {
      const names = new Set<string>();
      for (const chunk of Object.values(bundle)) {
        if (chunk.type !== 'chunk') continue;
        if (/<\/script|<!--/i.test(chunk.code)) this.error('the script cannot stand within a page');
        for (const id of chunk.moduleIds) {
          const name = /.*\/node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(id)?.[1];
          if (name) names.add(name);
        }
      }
      this.emitFile({ type: 'asset', fileName: 'packages.txt', source: `${[...names].sort().join('\n')}\n` });
    },
  };
}

export default defineConfig({
  plugins: [listPackages()],
  build: {
    target: 'es2020',
    outDir: 'dist-report',
    modulePreload: false,
    cssCodeSplit: false,
    rollupOptions: {
      input: 'src/report/main.tsx',
      output: {
        format: 'iife',
        entryFileNames: 'report.js',
        assetFileNames: 'report.[ext]',
      },
    },
  },
});
