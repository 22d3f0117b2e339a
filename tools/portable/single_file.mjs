// Writes overbend.html, the page with the program within it:
//
//   node tools/portable/single_file.mjs WEB FOLDER OUTPUT
//
// WEB: folder of the page's sources with its packages. FOLDER: overbend.js and overbend.wasm of the WebAssembly build.
import { readFileSync, renameSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { gzipSync } from 'node:zlib';

const [web, folder, output] = process.argv.slice(2).map((path) => resolve(path));
const require = createRequire(join(web, 'package.json'));
const { build } = await import(require.resolve('vite').replace(/index\.cjs$/, 'dist/node/index.js'));

const worker = await build({
  root: web,
  configFile: false,
  logLevel: 'error',
  build: { write: false, target: 'es2022', lib: { entry: join(web, 'src/api/engine.worker.ts'), formats: ['iife'], name: 'engine', fileName: 'engine' } },
});
await build({ root: web, configFile: join(web, 'vite.single.config.ts'), logLevel: 'error' });

/** Text of an element that is no script of the page's own; it must not end its element. */
const element = (id, text) => `<script type="text/plain" id="${id}">${text.replace(/<\/script/gi, '<\\/script').replace(/<!--/g, '<\\!--')}</script>\n`;
const program = `${readFileSync(join(folder, 'overbend.js'), 'utf8')}\n${worker[0].output[0].code}`;
const module = gzipSync(readFileSync(join(folder, 'overbend.wasm')), { level: 9 }).toString('base64');
const page = readFileSync(join(web, 'dist-single/index.html'), 'utf8');
const html = page.replace('<script type="module">', () => `${element('overbend-worker', program)}${element('overbend-module', module)}<script type="module">`);
writeFileSync(`${output}.part`, html);
renameSync(`${output}.part`, output);
console.log(`${output}: ${(html.length / 1e6).toFixed(1)} MB`);
