// Licence texts of the npm packages that go into the program:
//   node licences.mjs [--before FILE] [--of PACKAGES] OUT FOLDER...
//
// Each FOLDER holds a package.json and its node_modules; its `dependencies`, and theirs, are what is bundled. Equal texts
// are written once. With --before, OUT is FILE with the texts before it as a comment; with --of, only packages that are
// named in the lines of PACKAGES are meant. A package without a licence text is an error: nothing may be passed on without.
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

const read = (name) => readFileSync(name, 'utf8');
const manifest = (folder) => JSON.parse(read(join(folder, 'package.json')));

/** Where `name` is found from `folder`, as Node looks for it: there and then further out. */
function place(name, folder) {
  for (let at = folder; ; at = dirname(at)) {
    const found = join(at, 'node_modules', name);
    if (existsSync(join(found, 'package.json'))) return found;
    if (dirname(at) === at) return null;
  }
}

function collect(folder, found) {
  const own = manifest(folder);
  for (const name of Object.keys({ ...own.dependencies, ...own.optionalDependencies })) {
    const at = place(name, folder);
    if (at === null) {
      if (own.dependencies?.[name]) throw new Error(`${name}, wanted by ${folder}, is not installed`);
      continue;
    }
    if (found.has(at)) continue;
    found.set(at, manifest(at));
    collect(at, found);
  }
  return found;
}

function textOf(folder) {
  const file = readdirSync(folder).filter((name) => /^(licen[cs]e|copying|unlicen[cs]e)/i.test(name)).sort()[0];
  if (file === undefined) throw new Error(`${folder} has no licence text`);
  return read(join(folder, file)).replaceAll('\r\n', '\n').trim();
}

function sections(folders, named) {
  const byText = new Map();
  for (const folder of folders) {
    for (const [at, { name, version, license }] of collect(folder, new Map())) {
      if (named !== null && !named.has(name)) continue;
      const text = textOf(at);
      const title = `${name} ${version} (${license})`;
      byText.set(text, (byText.get(text) ?? new Set()).add(title));
    }
  }
  const told = [...byText].map(([text, titles]) => `${[...titles].sort().join('\n')}\n\n${text}\n`);
  return told.sort().join(`\n${'-'.repeat(78)}\n\n`);
}

const words = process.argv.slice(2);
const option = (name) => (words[0] === name ? words.splice(0, 2)[1] : null);
const before = option('--before');
const packages = option('--of');
const [out, ...folders] = words;
const text = sections(folders, packages === null ? null : new Set(read(packages).split('\n')));
writeFileSync(out, before === null ? text : `/*!\n${text.replaceAll('*/', '* /')}*/\n${read(before)}`);
