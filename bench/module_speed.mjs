// Time of statics as the page asks for them: the WebAssembly module under node, and the native program without AVX,
// the median of 15 requests each. Reproduces the table of docs/guide/other-systems.md.
//
//   node --no-experimental-fetch bench/module_speed.mjs FOLDER      FOLDER: overbend.js and overbend.wasm
//                                                                   OVERBEND_PROGRAM: the native program
import { spawn } from 'node:child_process';
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { request } from 'node:http';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '..'), folder = resolve(process.argv[2]);
const program = await createRequire(import.meta.url)(join(folder, 'overbend.js'))();

function copy(from, to) {
  program.FS.mkdirTree(to);
  for (const name of readdirSync(from)) {
    const path = join(from, name);
    if (statSync(path).isDirectory()) copy(path, `${to}/${name}`); else program.FS.writeFile(`${to}/${name}`, readFileSync(path));
  }
}

async function median(solve) {
  const times = [];
  for (let i = 0; i < 15; ++i) {
    const begun = performance.now(), status = await solve();
    if (status !== 200) throw new Error(`status ${status}`);
    times.push(performance.now() - begun);
  }
  return times.sort((a, b) => a - b)[7];
}

async function nativeTime(model) {
  const child = spawn(process.env.OVERBEND_PROGRAM, ['serve', join(root, 'examples', model), '--no-browser'], { env: { ...process.env, OVERBEND_ISA: 'baseline' } });
  try {
    let said = '';
    for await (const part of child.stdout) {
      said += part;
      const [, port, token] = /127\.0\.0\.1:(\d+)\/\?token=(\w+)/.exec(said) ?? [];
      if (!token) continue;
      return await median(() => new Promise((done, fail) => {
        const headers = { 'X-Overbend-Token': token, 'Content-Type': 'application/json' };
        const asked = request({ port, path: '/api/static', method: 'POST', headers }, (answer) => { answer.resume(); answer.on('end', () => done(answer.statusCode)); });
        asked.on('error', fail);
        asked.end('{}');
      }));
    }
    throw new Error(said);
  } finally { child.kill('SIGINT'); }
}

copy(join(root, 'examples'), '/models/examples');
copy(join(root, 'data'), '/models/data');
for (const model of ['bgl1.yaml', 'first-model.yaml', 'jlay.yaml', 'bgl1-moored.yaml']) {
  const error = program.ccall('overbend_start', 'string', ['string', 'string'], ['/models/examples', model]);
  if (error) throw new Error(error);
  const types = ['string', 'string', 'string', 'string'];
  const module = await median(() => program.ccall('overbend_request', 'number', types, ['POST', '/api/static', '', '{}']));
  const native = await nativeTime(model);
  console.log(`${model}: module ${module.toFixed(1)} ms, native ${native.toFixed(1)} ms, ratio ${(module / native).toFixed(2)}`);
}
