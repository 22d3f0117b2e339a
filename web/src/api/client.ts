// All requests to the program, with readable errors.
import { makeEngineTransport } from './engine';
import { http } from './http';
import type { Answer, Transport } from './transport';

declare const __OVERBEND_ENGINE__: boolean;
export const transport: Transport = __OVERBEND_ENGINE__ ? makeEngineTransport() : http;

if (new URLSearchParams(globalThis.location?.search).has('debug')) Object.assign(globalThis, { overbendTransport: transport });

export class ApiError extends Error {
  constructor(message: string, readonly status: number, readonly hint: string, readonly body: unknown) { super(message); }
}

let noteAnswer: (answered: boolean) => void = () => undefined;
/** `note` is called after every request with true if the program answered it. */
export const watchAnswers = (note: (answered: boolean) => void): void => { noteAnswer = note; };

function noAnswer(reason?: unknown): ApiError {
  noteAnswer(false);
  if (transport.local) {
    const text = reason instanceof Error ? reason.message : String(reason);
    return new ApiError(`The program within this page does not run: ${text}`, 0, 'It needs Chrome or Edge 95, Firefox 113, Safari 16.4 or later. Reload the page; models and results that were saved are kept.', null);
  }
  return new ApiError('The program does not answer. Is `overbend serve` still running?', 0, 'Start it again and open the address it prints.', null);
}

export async function ask<T>(method: string, path: string, body?: unknown): Promise<T> {
  let answer: Answer;
  try {
    answer = await transport.request(method, path, body === undefined ? undefined : JSON.stringify(body));
  } catch (reason) {
    throw noAnswer(reason);
  }
  const { status, text } = answer, ok = status >= 200 && status < 300;
  let data: unknown = null;
  try { data = text ? JSON.parse(text) : null; } catch { /* not JSON: reported below */ }
  // the program answers errors in JSON: any other text is from a proxy that does not reach it
  if (!ok && data === null && status !== 401) throw noAnswer();
  noteAnswer(true);
  if (ok) return data as T;
  const error = (data as { error?: { message?: string; hint?: string } } | null)?.error;
  const message = error?.message ?? (status === 401 ? 'This page belongs to an earlier session of the program.' : `The program rejected the request (${status}).`);
  throw new ApiError(message, status, error?.hint ?? (status === 401 ? 'Open the address that the program printed when it started.' : ''), data);
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
