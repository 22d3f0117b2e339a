// Worker with an instance of the program. Messages in and out are below; createOverbend is the script of emscripten, which
// stands before this one in the single file.

/** A file of the program: its contents, or null if it was removed. */
export interface FileChange { path: string; bytes: Uint8Array | null }

export type ToEngine =
  | { kind: 'start'; module: WebAssembly.Module; files: FileChange[]; executes: boolean }
  | { kind: 'files'; changes: FileChange[] }
  | { kind: 'request'; id: number; method: string; path: string; query: string; body: string };

export type FromEngine =
  | { kind: 'answer'; id: number; status: number; bytes: Uint8Array }
  | { kind: 'failure'; message: string }
  | { kind: 'event'; name: string; data: string }
  | { kind: 'files'; changes: FileChange[] };

interface FileSystem {
  mkdirTree(path: string): void;
  writeFile(path: string, bytes: Uint8Array): void;
  readFile(path: string): Uint8Array;
  readdir(path: string): string[];
  stat(path: string): { mode: number; mtime: Date; size: number };
  isDir(mode: number): boolean;
  unlink(path: string): void;
  analyzePath(path: string): { exists: boolean };
}

interface Program {
  FS: FileSystem;
  HEAPU8: Uint8Array;
  ccall(name: string, returns: 'string' | 'number' | null, types: string[], values: unknown[]): unknown;
}

declare function createOverbend(options: { instantiateWasm: (imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void) => object }): Promise<Program>;

const folder = '/models';
/** Duration of a part of a run, after which messages are read [ms]. */
const slice = 1000;

const post = (message: FromEngine, transfer: Transferable[] = []): void => {
  (self as unknown as { postMessage: (m: FromEngine, t: Transferable[]) => void }).postMessage(message, transfer);
};

let program: Program;
let executes = false;
/** Time and size of every file when it was last reported. */
let known = new Map<string, string>();

const stamp = ({ mtime, size }: { mtime: Date; size: number }): string => `${mtime.getTime()} ${size}`;

function listFiles(path: string, into: Map<string, string>): Map<string, string> {
  for (const name of program.FS.readdir(path)) {
    if (name === '.' || name === '..') continue;
    const file = `${path}/${name}`, status = program.FS.stat(file);
    if (program.FS.isDir(status.mode)) listFiles(file, into); else into.set(file, stamp(status));
  }
  return into;
}

/** Reports the files that the program has written or removed since the last call. */
function reportFiles(): void {
  const present = listFiles(folder, new Map());
  const changes: FileChange[] = [];
  for (const [path, seen] of present) if (known.get(path) !== seen) changes.push({ path, bytes: program.FS.readFile(path) });
  for (const path of known.keys()) if (!present.has(path)) changes.push({ path, bytes: null });
  known = present;
  if (changes.length) post({ kind: 'files', changes });
}

/** Takes files of the second instance or of another tab; what this instance has written meanwhile remains to be reported. */
function takeFiles(changes: FileChange[]): void {
  for (const { path, bytes } of changes) {
    if (bytes) {
      program.FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
      program.FS.writeFile(path, bytes);
      if (path.startsWith(`${folder}/`)) known.set(path, stamp(program.FS.stat(path)));
    } else {
      if (program.FS.analyzePath(path).exists) program.FS.unlink(path);
      known.delete(path);
    }
  }
}

function sendEvents(): void {
  for (const event of (program.ccall('overbend_take_events', 'string', [], []) as string).split('\n\n')) {
    const [, name, data] = /^event: (.*)\ndata: (.*)$/s.exec(event) ?? [];
    if (name) post({ kind: 'event', name, data: data! });
  }
}

function answer(request: Extract<ToEngine, { kind: 'request' }>): void {
  const status = program.ccall('overbend_request', 'number', ['string', 'string', 'string', 'string'], [request.method, request.path, request.query, request.body]) as number;
  const from = program.ccall('overbend_answer_body', 'number', [], []) as number;
  const size = program.ccall('overbend_answer_size', 'number', [], []) as number;
  const bytes = program.HEAPU8.slice(from, from + size);
  if (request.method !== 'GET') reportFiles();
  post({ kind: 'answer', id: request.id, status, bytes }, [bytes.buffer]);
  sendEvents();
}

/** After a failure, as when the memory is full, the program answers no more. */
function reportFailure(error: unknown): void {
  post({ kind: 'failure', message: error instanceof Error ? error.message : String(error) });
}

let working = false;
/** Executes queued runs in slices; between two of them messages are read. */
function work(): void {
  try {
    working = program.ccall('overbend_execute_slice', 'number', ['number'], [slice]) === 1;
    reportFiles();
    sendEvents();
    if (working) setTimeout(work);
  } catch (error) { reportFailure(error); }
}

async function start({ module, files, executes: does }: Extract<ToEngine, { kind: 'start' }>): Promise<void> {
  program = await createOverbend({
    instantiateWasm: (imports, done) => { void WebAssembly.instantiate(module, imports).then(done); return {}; },
  });
  executes = does;
  program.FS.mkdirTree(folder);
  takeFiles(files);
  const error = program.ccall('overbend_start', 'string', ['string', 'string'], [folder, '']) as string;
  if (error) throw new Error(error);
}

/** Messages are executed in their order: the first one starts the program. */
let queue: Promise<void> = Promise.resolve();
self.onmessage = (event: MessageEvent<ToEngine>): void => {
  const message = event.data;
  queue = queue.then(async () => {
    if (message.kind === 'start') return start(message);
    if (message.kind === 'files') return takeFiles(message.changes);
    answer(message);
    if (executes && !working) { working = true; setTimeout(work); }
  }).catch(reportFailure);
};
