// One way to ask the program, with the token of this start and with errors in words.

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
/** `note` is called after every request with whether the program answered it. */
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
  try { data = text ? JSON.parse(text) : null; } catch { /* not JSON: said below */ }
  // the program gives its reasons as JSON: other words are those of a proxy that does not reach it
  if (!answer.ok && data === null && answer.status !== 401) throw noAnswer();
  noteAnswer(true);
  if (answer.ok) return data as T;
  const error = (data as { error?: { message?: string; hint?: string } } | null)?.error;
  const words = error?.message ?? (answer.status === 401 ? 'This page belongs to an earlier start of the program.' : `The program refused (${answer.status}).`);
  throw new ApiError(words, answer.status, error?.hint ?? (answer.status === 401 ? 'Open the address that the program printed at its start.' : ''), data);
}

const reads = new Set<Promise<unknown>>();

export function get<T>(path: string): Promise<T> {
  const answer = ask<T>('GET', path);
  reads.add(answer);
  const done = (): void => { reads.delete(answer); };
  answer.then(done, done);
  return answer;
}

/** Waits for every read on its way: what it reads can be deleted afterwards. */
export const finishReads = async (): Promise<void> => { await Promise.allSettled([...reads]); };

export const post = <T>(path: string, body: unknown = {}): Promise<T> => ask<T>('POST', path, body);
export const put = <T>(path: string, body: unknown): Promise<T> => ask<T>('PUT', path, body);

/** Server-sent events; the browser itself tries again when the program was away. */
export function listen(on: Record<string, (data: never) => void>, state: (connected: boolean) => void): () => void {
  const source = new EventSource(address('events'));
  source.onopen = () => state(true);
  source.onerror = () => state(false);
  for (const [name, act] of Object.entries(on)) {
    source.addEventListener(name, (event) => act(JSON.parse((event as MessageEvent<string>).data) as never));
  }
  return () => source.close();
}
