// Removes the download addresses from package-lock.json: checksums remain, and any registry can serve the files.
import { readFileSync, writeFileSync } from 'node:fs';

const name = new URL('../package-lock.json', import.meta.url);
const lock = JSON.parse(readFileSync(name, 'utf8'));
for (const entry of Object.values(lock.packages)) delete entry.resolved;
writeFileSync(name, `${JSON.stringify(lock, null, 2)}\n`);
