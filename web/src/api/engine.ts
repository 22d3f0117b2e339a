// The program within the page: one worker answers requests and solves live statics, another executes runs. Each has an
// instance of its own; files that one of them writes are kept by the browser and given to the second.
import { readFiles, writeFiles } from './files';
import type { Answer, Listeners, Transport } from './transport';
import type { FileChange, FromEngine, ToEngine } from './engine.worker';

interface Reply { status: number; bytes: Uint8Array }

/** One instance of the program, in a worker. */
class Engine {
  private readonly worker: Worker;
  private readonly waiting = new Map<number, { done: (reply: Reply) => void; fail: (error: Error) => void }>();
  private last = 0;
  private failure: Error | null = null;

  constructor(script: string, private readonly receive: (message: FromEngine) => void) {
    this.worker = new Worker(script);
    this.worker.onmessage = (event: MessageEvent<FromEngine>) => {
      const message = event.data;
      if (message.kind === 'failure') return this.stop(message.message);
      if (message.kind !== 'answer') return this.receive(message);
      this.waiting.get(message.id)?.done({ status: message.status, bytes: message.bytes });
      this.waiting.delete(message.id);
    };
    this.worker.onerror = (event) => this.stop(event.message);
  }

  private stop(message: string): void {
    this.failure = new Error(message);
    for (const { fail } of this.waiting.values()) fail(this.failure);
    this.waiting.clear();
  }

  send(message: ToEngine): void { this.worker.postMessage(message); }

  request(method: string, path: string, body = ''): Promise<Reply> {
    const id = ++this.last;
    const [name, query = ''] = path.split('?') as [string, string?];
    return new Promise((done, fail) => {
      if (this.failure) return fail(this.failure);
      this.waiting.set(id, { done, fail });
      this.send({ kind: 'request', id, method, path: `/api/${name}`, query, body });
    });
  }
}

/** Text of an element that the single file has for the program, which is then removed to free its memory. */
function takeElement(id: string): string {
  const element = document.getElementById(id)!;
  const text = element.textContent!;
  element.remove();
  return text;
}

/** WebAssembly module of the page: base64 of a gzip stream. */
function unpackModule(): Promise<WebAssembly.Module> {
  const letters = atob(takeElement('overbend-module').trim()), packed = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) packed[i] = letters.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return WebAssembly.compileStreaming(new Response(stream, { headers: { 'Content-Type': 'application/wasm' } }));
}

const belongsToRuns = (path: string): boolean => /^runs(\/|\?|$)/.test(path);
/** Requests that change the model or its folder: both instances execute them. */
const changesModel = (method: string, path: string): boolean => method !== 'GET' && /^(model|data|hull|units)\b/.test(path);

class EngineTransport implements Transport {
  readonly local = true;
  private readonly listeners = new Set<Listeners>();
  /** Changes of files between tabs of this page, which keep the same files. */
  private readonly tabs = new BroadcastChannel('overbend-files');
  private readonly ready: Promise<{ model: Engine; runs: Engine }>;

  constructor() {
    this.ready = this.start();
    // Heard from the first moment: a change while the program starts may be missing among the files that are read.
    this.tabs.onmessage = (event: MessageEvent<FileChange[]>) => {
      void this.ready.then(({ model, runs }) => { for (const engine of [model, runs]) engine.send({ kind: 'files', changes: event.data }); });
    };
  }

  private async start(): Promise<{ model: Engine; runs: Engine }> {
    const script = URL.createObjectURL(new Blob([takeElement('overbend-worker')], { type: 'text/javascript' }));
    const [module, files] = await Promise.all([unpackModule(), readFiles()]);
    const model: Engine = new Engine(script, (message) => this.receive(message, runs, (name) => name !== 'run'));
    const runs: Engine = new Engine(script, (message) => this.receive(message, model, (name) => name === 'run'));
    for (const engine of [model, runs]) engine.send({ kind: 'start', module, files, executes: engine === runs });
    return { model, runs };
  }

  private receive(message: FromEngine, second: Engine, wanted: (event: string) => boolean): void {
    if (message.kind === 'files') {
      second.send({ kind: 'files', changes: message.changes });
      this.tabs.postMessage(message.changes);
      writeFiles(message.changes).catch((error: unknown) => this.emit('unsaved', { message: String(error) }));
    } else if (message.kind === 'event' && wanted(message.name)) {
      this.emit(message.name, JSON.parse(message.data));
    }
  }

  private emit(name: string, data: unknown): void {
    for (const on of this.listeners) on[name]?.(data as never);
  }

  private async reply(method: string, path: string, body?: string): Promise<Reply> {
    const { model, runs } = await this.ready;
    if (belongsToRuns(path)) return runs.request(method, path, body);
    if (changesModel(method, path)) void runs.request(method, path, body);
    return model.request(method, path, body);
  }

  async request(method: string, path: string, body?: string): Promise<Answer> {
    const { status, bytes } = await this.reply(method, path, body);
    return { status, text: new TextDecoder().decode(bytes) };
  }

  async file(path: string): Promise<Blob> {
    return new Blob([(await this.reply('GET', path)).bytes as BlobPart]);
  }

  listen(on: Listeners, state: (connected: boolean) => void): () => void {
    this.listeners.add(on);
    void this.ready.then(() => state(true));
    return () => { this.listeners.delete(on); };
  }
}

export const makeEngineTransport = (): Transport => new EngineTransport();

export type { FileChange };
