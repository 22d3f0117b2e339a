// Licence texts of the npm packages that go into the program:
//   node licences.mjs [--before FILE] [--of PACKAGES] OUT FOLDER...
//
// Each FOLDER holds a package.json and its node_modules; its `dependencies`, and theirs, are bundled. Equal texts are
// written once. With --before, OUT is FILE with the texts before it as a comment; with --of, only the packages named in
// the lines of PACKAGES are included. A package without a licence text is an error: it may not be distributed.
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

const read = (name) => readFileSync(name, 'utf8');
const manifest = (folder) => JSON.parse(read(join(folder, 'package.json')));

/** Folder of the package `name` seen from `folder`, as Node resolves it: there and then in the parent folders. */
function place(name, folder) {
  for (let path = folder; ; path = dirname(path)) {
    const found = join(path, 'node_modules', name);
    if (existsSync(join(found, 'package.json'))) return found;
    if (dirname(path) === path) return null;
  }
}

function collect(folder, found) {
  const parent = manifest(folder);
  for (const name of Object.keys({ ...parent.dependencies, ...parent.optionalDependencies })) {
    const path = place(name, folder);
    if (path === null) {
      if (parent.dependencies?.[name]) throw new Error(`${name}, required by ${folder}, is not installed`);
      continue;
    }
    if (found.has(path)) continue;
    found.set(path, manifest(path));
    collect(path, found);
  }
  return found;
}

function licenceText(folder) {
  const file = readdirSync(folder).filter((name) => /^(licen[cs]e|copying|unlicen[cs]e)/i.test(name)).sort()[0];
  if (file === undefined) throw new Error(`${folder} has no licence text`);
  return read(join(folder, file)).replaceAll('\r\n', '\n').trim();
}

function licenceSections(folders, named) {
  const byText = new Map();
  for (const folder of folders) {
    for (const [path, { name, version, license }] of collect(folder, new Map())) {
      if (named !== null && !named.has(name)) continue;
      const text = licenceText(path);
      const title = `${name} ${version} (${license})`;
      byText.set(text, (byText.get(text) ?? new Set()).add(title));
    }
  }
  const sections = [...byText].map(([text, titles]) => `${[...titles].sort().join('\n')}\n\n${text}\n`);
  return sections.sort().join(`\n${'-'.repeat(78)}\n\n`);
}

const args = process.argv.slice(2);
const option = (name) => (args[0] === name ? args.splice(0, 2)[1] : null);
const before = option('--before');
const packages = option('--of');
const [out, ...folders] = args;
const text = licenceSections(folders, packages === null ? null : new Set(read(packages).split('\n')));
writeFileSync(out, before === null ? text : `/*!\n${text.replaceAll('*/', '* /')}*/\n${read(before)}`);
