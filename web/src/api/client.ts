// All requests to the program, with the access token of this start and with readable errors.

let token = new URLSearchParams(location.search).get('token') ?? '';
export const currentToken = (): string => token;
export const setToken = (given: string): void => { token = given; };

export class ApiError extends Error {
  constructor(message: string, readonly status: number, readonly hint: string, readonly body: unknown) { super(message); }
}

export function address(path: string): string {
  return `/api/${path}${path.includes('?') ? '&' : '?'}token=${encodeURIComponent(token)}`;
}

let noteAnswer: (answered: boolean) => void = () => undefined;
/** `note` is called after every request with true if the program answered it. */
export const watchAnswers = (note: (answered: boolean) => void): void => { noteAnswer = note; };

function noAnswer(): ApiError {
  noteAnswer(false);
  return new ApiError('The program does not answer. Is `overbend serve` still running?', 0, 'Start it again and open the address it prints.', null);
}

export async function ask<T>(method: string, path: string, body?: unknown): Promise<T> {
  let answer: Response;
  try {
    answer = await fetch(`/api/${path}`, {
      method,
      headers: { 'X-Overbend-Token': token, ...(body === undefined ? {} : { 'Content-Type': 'application/json' }) },
      ...(body === undefined ? {} : { body: JSON.stringify(body) }),
    });
  } catch {
    throw noAnswer();
  }
  const text = await answer.text();
  let data: unknown = null;
  try { data = text ? JSON.parse(text) : null; } catch { /* not JSON: reported below */ }
  // the program answers errors in JSON: any other text is from a proxy that does not reach it
  if (!answer.ok && data === null && answer.status !== 401) throw noAnswer();
  noteAnswer(true);
  if (answer.ok) return data as T;
  const error = (data as { error?: { message?: string; hint?: string } } | null)?.error;
  const message = error?.message ?? (answer.status === 401 ? 'This page belongs to an earlier session of the program.' : `The program rejected the request (${answer.status}).`);
  throw new ApiError(message, answer.status, error?.hint ?? (answer.status === 401 ? 'Open the address that the program printed when it started.' : ''), data);
}

const reads = new Set<Promise<unknown>>();

export function get<T>(path: string): Promise<T> {
  const answer = ask<T>('GET', path);
  reads.add(answer);
  const done = (): void => { reads.delete(answer); };
  answer.then(done, done);
  return answer;
}

/** Waits for all pending reads: their data can be deleted afterwards. */
export const finishReads = async (): Promise<void> => { await Promise.allSettled([...reads]); };

export const post = <T>(path: string, body: unknown = {}): Promise<T> => ask<T>('POST', path, body);
export const put = <T>(path: string, body: unknown): Promise<T> => ask<T>('PUT', path, body);

/** Server-sent events; the browser reconnects by itself after an interruption. */
export function listen(on: Record<string, (data: never) => void>, state: (connected: boolean) => void): () => void {
  const source = new EventSource(address('events'));
  source.onopen = () => state(true);
  source.onerror = () => state(false);
  for (const [name, act] of Object.entries(on)) {
    source.addEventListener(name, (event) => act(JSON.parse((event as MessageEvent<string>).data) as never));
  }
  return () => source.close();
}
