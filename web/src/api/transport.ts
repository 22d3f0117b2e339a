// Transport between page and program: over HTTP from `overbend serve`, or in workers within the page (overbend.html).

export interface Answer { status: number; text: string }

export type Listeners = Record<string, (data: never) => void>;

export interface Transport {
  /** True if the program is within the page: files have no address. */
  readonly local: boolean;
  /** `path` below /api, with its query. Rejects if the program does not answer. */
  request(method: string, path: string, body?: string): Promise<Answer>;
  /** Contents of a file that the program makes. */
  file(path: string): Promise<Blob>;
  /** Receives events until the returned function is called; `state` is called when the connection changes. */
  listen(on: Listeners, state: (connected: boolean) => void): () => void;
}
